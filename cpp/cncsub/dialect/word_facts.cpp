#include "cncsub/dialect/word_facts.hpp"

#include <algorithm>
#include <charconv>

#include "cncsub/control/source.hpp"
#include "cncsub/control/variable_table.hpp"
#include "cncsub/dialect/asked.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

std::vector<Keyword> keywords_of(const Control& control) {
  const Dialect* const dialect = find_dialect(control.dialect);
  return dialect == nullptr ? std::vector<Keyword>() : dialect->keywords(control);
}

std::optional<CodeFacts> word_facts(const Control& control, std::string_view word) {
  const std::vector<Keyword> all = keywords_of(control);
  const auto found = std::find_if(
      all.begin(), all.end(), [word](const Keyword& of) { return same_letters(of.name, word); });
  if (found == all.end()) return std::nullopt;
  CodeFacts facts = facts_of_row(control, {found->does, found->words, found->causes});
  facts.name = found->name;
  facts.treatment = found->treatment;
  facts.sources = {{std::string(found->rule), std::string(found->source),
                    strongest(found->source, control.base.empty() ? control.name : control.base)}};
  return facts;
}

namespace {

/// Return the number after a sign, which is the whole rest of a name; -1 where none is.
std::int64_t number_behind(std::string_view name, std::string_view sign) {
  std::int64_t number = -1;
  if (name.size() <= sign.size() || !same_letters(name.substr(0, sign.size()), sign)) return -1;
  const char* const last = name.data() + name.size();
  const auto read = std::from_chars(name.data() + sign.size(), last, number);
  return read.ec == std::errc() && read.ptr == last && number >= 0 ? number : -1;
}

/// Say of a variable that the control has it not, or that no source tells of it.
void add_missing(const Control& control, std::string_view sign, std::int64_t number,
                 CodeFacts& facts) {
  const bool unknown = control.macros.unlisted_variables.value == UnlistedVariable::NotKnown;
  facts.treatment = unknown ? "not-known" : "refused";
  facts.does =
      unknown ? "is a variable of which no source says what it is"
              : "is a variable that the control has not: " + no_variable(control, sign, number);
  facts.causes.push_back(info(unknown ? Cause::VariableNotKnown : Cause::IllegalVariable).slug);
}

/// Return what is known of #3006 or R10.
std::optional<CodeFacts> variable_facts(const Control& control, std::string_view name) {
  const Dialect* const dialect = find_dialect(control.dialect);
  if (dialect == nullptr) return std::nullopt;
  const std::string_view sign = dialect->spelling->variable;
  const std::int64_t number = number_behind(name, sign);
  if (number < 0) return std::nullopt;
  CodeFacts facts;
  facts.name = std::string(sign) + std::to_string(number);
  facts.treatment = "computed";
  const std::vector<VariableRange> ranges = variable_ranges(control);
  const auto of = std::find_if(ranges.begin(), ranges.end(), [number](const VariableRange& range) {
    return number >= range.first && number <= range.last;
  });
  if (of == ranges.end()) {
    add_missing(control, sign, number, facts);
    return facts;
  }
  facts.does = what_it_holds(of->kind);
  if (of->first != of->last)
    facts.does += ": " + std::string(sign) + std::to_string(of->first) + " to " +
                  std::string(sign) + std::to_string(of->last);
  if (of->access == Access::ReadOnly) facts.does += "; programs only read it";
  if (of->access == Access::WriteOnly) facts.does += "; programs only write it";
  facts.sources = {{"", of->source, of->evidence}};
  return facts;
}

/// Return the letters at the beginning of a name where a number follows them to its end: DO of DO1.
std::string_view letters_before_number(std::string_view name) {
  const auto* const end = std::find_if_not(name.begin(), name.end(), is_letter);
  const bool number = end != name.end() &&
                      std::all_of(end, name.end(), [](char c) { return is_digit(c) || c == '.'; });
  return number ? name.substr(0, static_cast<std::size_t>(end - name.begin())) : "";
}

/// Return the code of a name such as G54.1 or M98, or of a word that is a G code of the control:
/// TRANS.
std::optional<CodeName> code_named(const Control& control, std::string_view name) {
  if (const auto code = CodeName::read(name)) return code;
  const int tenfold = code_of_word(name);
  if (tenfold < 0 || !control.reading.g_codes.value.has(tenfold)) return std::nullopt;
  return CodeName{'G', tenfold};
}

/// Return what is known of ,C or ,R, whose letter rules of the control name.
std::optional<CodeFacts> comma_facts(const Control& control, std::string_view name) {
  struct Comma {
    std::string_view rule, does;
  };
  static constexpr Comma kCommas[] = {
      {"chamfer_words", "a chamfer to the next move"},
      {"round_words", "a rounding to the next move"},
      {"angle_words", "the angle of a line whose end point is not written in full"}};
  for (const RuleView& rule : rules(control)) {
    const auto* const letters = std::get_if<std::string>(&rule.value);
    for (const Comma& of : kCommas) {
      if (letters == nullptr || rule.name != of.rule) continue;
      if (letters->find(capitals(name)) == std::string::npos) continue;
      CodeFacts facts;
      facts.name = capitals(name);
      facts.does = of.does;
      facts.treatment = "computed";
      facts.sources = {{std::string(rule.name), std::string(rule.source), rule.evidence}};
      return facts;
    }
  }
  return std::nullopt;
}

/// Return what is known of a word or of an address without its number.
std::optional<CodeFacts> plain_facts(const Control& control, std::string_view name) {
  auto facts = word_facts(control, name);
  if (!facts && name.size() == 1) facts = address_facts(control, upper(name[0]));
  return facts;
}

}  // namespace

std::optional<CodeFacts> named_facts(const Control& control, MachineType machine,
                                     std::string_view name) {
  if (const auto code = code_named(control, name)) {
    // A code that the language itself obeys is one of its words.
    if (auto of_language = word_facts(control, name); of_language && CodeName::read(name))
      return of_language;
    CodeFacts facts = code_facts(control, machine, *code);
    keep_taken(control, *code, facts.words);
    return facts;
  }
  if (auto facts = plain_facts(control, name)) return facts;
  if (auto facts = variable_facts(control, name)) return facts;
  if (name.starts_with("#<_")) return plain_facts(control, "#<_name>");
  if (name.starts_with("#<")) return plain_facts(control, "#<name>");
  if (name.starts_with(',')) return comma_facts(control, name);
  const bool system = name.starts_with('$') && name.find_first_of("[=(") == std::string_view::npos;
  const std::size_t prefix = system ? name.find('_') : std::string_view::npos;
  if (prefix != std::string_view::npos) return plain_facts(control, name.substr(0, prefix + 1));
  const std::string_view letters = letters_before_number(name);
  return letters.empty() ? std::nullopt : plain_facts(control, letters);
}

namespace {

/// Reads the names of one piece of a block.
class NameReader {
 public:
  NameReader(const Spelling& spelling, std::string_view text, std::vector<std::string>& to)
      : spelling_(spelling), text_(text), to_(to) {}

  void read() {
    while (at_ < text_.size()) one();
  }

 private:
  char ahead(std::size_t by) const { return at_ + by < text_.size() ? text_[at_ + by] : '\0'; }
  template <class Part>
  std::size_t run_of(std::size_t from, const Part& is_part) const {
    while (is_part(ahead(from))) ++from;
    return from;
  }
  void take(std::size_t characters) {
    const std::string_view name = text_.substr(at_, characters);
    const auto same = [name](const std::string& of) { return same_letters(of, name); };
    if (std::none_of(to_.begin(), to_.end(), same)) to_.emplace_back(name);
    at_ += characters;
  }
  void pass(std::size_t characters) { at_ += characters; }
  void pass_up_to(char close) {
    const std::size_t end = text_.find(close, at_ + 1);
    at_ = end == std::string_view::npos ? text_.size() : end + 1;
  }
  void one();
  void variable();
  void number();
  void exponent();
  void name();

  const Spelling& spelling_;
  std::string_view text_;
  std::vector<std::string>& to_;
  std::size_t at_ = 0;
};

bool is_of_name(char c) { return is_letter(c) || is_digit(c) || c == '_'; }
bool is_of_number(char c) { return is_digit(c) || c == '.'; }

void NameReader::one() {
  const char c = ahead(0);
  const bool comment = c == '(' && spelling_.comment.before == "(";
  if (c == '"') return pass_up_to('"');
  if (comment) return pass_up_to(')');
  if (is_of_number(c)) return number();
  if (c == '\'') return pass_up_to('\'');  // 'HFF'
  if (c == '<' && spelling_.numbered && text_.find('>', at_) != std::string_view::npos)
    return pass_up_to('>');  // the name of a program
  if (c == '#') return variable();
  if (c == '<' && ahead(1) == '<') return take(2);
  if (c == '$' && is_letter(ahead(1))) return take(run_of(1, is_of_name));
  if (c == ',' && at_ == 0 && is_letter(ahead(1))) return take(2);
  if (is_letter(c) || (c == '_' && !spelling_.numbered)) return name();
  pass(1);
}

/// Read #100 or #<depth>.
void NameReader::variable() {
  if (is_digit(ahead(1))) return take(run_of(1, is_digit));
  if (ahead(1) != '<') return pass(1);
  const std::size_t end = text_.find('>', at_);
  take(end == std::string_view::npos ? text_.size() - at_ : end + 1 - at_);
}

/// Pass over a number, which may have an exponent: 1.5EX-3.
void NameReader::number() {
  at_ += run_of(0, is_of_number);
  exponent();
}

void NameReader::exponent() {
  if (upper(ahead(0)) != 'E' || upper(ahead(1)) != 'X') return;
  at_ += ahead(2) == '-' || ahead(2) == '+' ? 3 : 2;
  at_ += run_of(0, is_digit);
}

/// Read a word, a code or an address with its number. Where variables have numbers for names, a
/// number ends a name: GOTO10 is one, and EQ2 of EQ2AND.
void NameReader::name() {
  std::size_t letters = run_of(0, is_letter);
  while (spelling_.numbered && ahead(letters) == '_' && is_letter(ahead(letters + 1)))
    letters = run_of(letters + 1, is_letter);  // END_IF
  const std::size_t whole = run_of(0, is_of_name);
  const bool code = letters == 1 && is_digit(ahead(1));
  const bool indexed = letters == 1 && ahead(1) == '[' && !spelling_.numbered;
  if (indexed) return take(2);  // R[R1] and G[8] are no feeds or axes, as F and X are
  take(spelling_.numbered || code ? run_of(letters, is_of_number) : whole);
  if (code) exponent();
}

}  // namespace

std::vector<std::string> names_in(const Control& control, std::string_view block) {
  std::vector<std::string> names;
  const Dialect* const dialect = find_dialect(control.dialect);
  if (dialect == nullptr) return names;
  TokenReader tokens(dialect->read_word, block);
  while (const auto token = tokens.next())
    if (token->kind == BlockToken::Kind::Word)
      NameReader(*dialect->spelling, block.substr(token->at, token->width), names).read();
  return names;
}

}  // namespace cncsub
