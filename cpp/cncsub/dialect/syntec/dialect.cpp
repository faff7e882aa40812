// The two languages of a Syntec: ISO programs, and programs that begin with %@MACRO. Their blocks
// of words are those of the ISO family; statements and expressions are the maker's.
#include "cncsub/dialect/dialect.hpp"

#include <algorithm>
#include <memory>

#include "cncsub/control/at_variables.hpp"
#include "cncsub/dialect/iso/operators.hpp"
#include "cncsub/dialect/iso/program_file.hpp"
#include "cncsub/dialect/iso/structured_words.hpp"
#include "cncsub/dialect/syntec/statements.hpp"

namespace cncsub {

namespace {

/// A row of keywords.def, and what becomes of the word.
struct TreatedRow : KeywordRow {
  std::string_view treatment;
};
constexpr const char* kSource = "SYM, the language of %@MACRO";
constexpr TreatedRow kRows[] = {
#define KEYWORD(word, does, words, causes) {{word, does, words, causes, kSource}, "computed"},
#define PASSED(word, does, words, causes) {{word, does, words, causes, kSource}, "passed-over"},
#include "cncsub/dialect/syntec/keywords.def"
#undef KEYWORD
#undef PASSED
#define NOT_COMPUTED(name, gives) \
  {{name, gives, "", "+code-not-computed", kSource}, "not-computed"},
#include "cncsub/dialect/iso/not_computed.def"
#undef NOT_COMPUTED
};

/// What both languages read otherwise than the family. [SYM: G66.1; arguments]
constexpr IsoVariant variant(bool structured) {
  return {.structured = structured,
          .after_blocks = true,
          .p_is_argument = true,
          .is_other_statement = structured ? nullptr : syntec::is_statement};
}

/// How far a block is looked at for one of its words, first: a block of many words costs what it
/// is long.
constexpr std::size_t kNear = 200;

/// Return the name of a variable whose number has the sign @. Those far above them are signals.
std::string at_variable(const Control& /*control*/, std::int64_t number) {
  const std::int64_t behind = number - kAtVariables;
  return behind < 0 || behind >= kAtVariables ? "" : "@" + std::to_string(behind);
}

/// Return whether a block was written in the maker's language: a value stands in round brackets,
/// where no comment can stand, or a sign that no other program has.
bool is_structured(std::string_view block) {
  for (std::size_t at = 0; at < block.size(); ++at) {
    if (block[at] != '(' && block[at] != '@' && block[at] != ':') continue;
    const char behind = at + 1 < block.size() ? block[at + 1] : '\0';
    if (block[at] == '@' || (block[at] == ':' && behind == '=')) return true;
    const bool value = is_digit(behind) || std::string_view("#@.+-(\"").find(behind) < 7;
    if (block[at] == '(' && at > 0 && is_letter(block[at - 1]) && value) return true;
  }
  return false;
}

}  // namespace

const std::string_view syntec_rules;  // all that the ISO family asks
const double syntec_precision = 0;    // a number has 64 bits

const std::span<const WordUse> syntec_word_uses;
const Spelling syntec_spelling{.comment = {"(", ")"},
                               .value = {"[", "]"},
                               .message = {},
                               .head = {"O", ""},
                               .operators = iso_operators,
                               .variable_name = at_variable,
                               .unsigned_words = "LPT",
                               .signs_by_rule = true,
                               .small_letters = false,
                               .ignores_words = true,
                               .open_comments = true};

FileReader syntec_reader(Builder& to, const ProgramNames& /*other_mode*/) {
  const auto own = std::make_shared<syntec::StructuredReader>(to, variant(true));
  return iso_reader(to, variant(false),
                    {[own](std::string_view text) { own->begin_text(text); }, heads_structured,
                     [own](std::size_t from, std::size_t to_at, std::uint32_t line) {
                       own->read(from, to_at, line);
                     },
                     [own](const Program& program) { own->end_program(program); }});
}

// Null: the first line of a program says what the lines after it mean.
PieceReader (*const syntec_pieces)(Builder& to) = nullptr;
ProgramNames (*const syntec_other_mode)(const Code& code) = nullptr;

std::optional<Fault> syntec_expression(Builder& to, const ExpressionText& text,
                                       std::uint32_t& expression, ValueType& type) {
  return iso_expression(to, text, expression, type);
}

/// Read a word, in which := is one.
static std::optional<WrittenWord> structured_word(std::string_view block, std::size_t& from) {
  if (from == 0 && !block.empty() && is_digit(block[0])) {  // the values of a branch: 2, 3:
    from = block.size();
    WrittenWord values;
    values.text = block;
    values.width = static_cast<std::uint32_t>(from);
    return values;
  }
  if (!is_structured(block.substr(from, kNear))) return iso_word(block, from);
  for (std::size_t width = kNear;; width = block.size() - from) {
    std::string text(block.substr(from, width));
    translate_structured(text, 0, text.size());
    std::size_t behind = 0;
    auto word = iso_word(text, behind);
    const bool cut = text.size() < block.size() - from;
    if (cut && (!word || behind == text.size())) continue;  // the word may go on
    if (!word) return word;
    word->at += static_cast<std::uint32_t>(from);
    word->text = trimmed(block.substr(word->at, word->width));
    from += behind;
    return word;
  }
}

std::optional<WrittenWord> syntec_word(std::string_view block, std::size_t& from) {
  auto word = structured_word(block, from);
  if (word && word->at > 0 && block[word->at] == '=' && block[word->at - 1] == ':') {
    --word->at;  // without a variable before it
    ++word->width;
    word->text = trimmed(block.substr(word->at, word->width));
  }
  return word;
}

std::vector<Keyword> syntec_keywords(const Control& control) {
  std::vector<Keyword> all;
  for (const TreatedRow& of : kRows) {
    all.push_back(of.keyword());
    all.back().treatment = of.treatment;
  }
  for (Keyword& of : iso_keywords(control))
    if (std::none_of(all.begin(), all.end(),
                     [&](const Keyword& known) { return known.name == of.name; }))
      all.push_back(std::move(of));
  return all;
}

}  // namespace cncsub
