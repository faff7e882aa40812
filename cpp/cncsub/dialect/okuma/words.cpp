// The language of an OSP as others see it: its words, its spelling and the rules that it asks.
#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/given_value.hpp"
#include "cncsub/dialect/okuma/block.hpp"

namespace cncsub {

namespace okuma {

namespace {

constexpr std::string_view kSource = "OKA 2227: words; OKM";

/// Pass over an index or a value in brackets, with all between them.
void pass_brackets(Line& line) {
  int depth = 0;
  for (char c = line.peek(); c != '\0'; c = line.peek()) {
    line.pass(1);
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (depth == 0) return;
  }
}

bool is_operator(std::string_view name) {
  return !name.empty() && operator_of_letters(kOperators, capitals(name)) != nullptr;
}

void pass_operand(Line& line) {
  while (line.peek() == '-' || line.peek() == '+' || same_letters(line.name(), "NOT"))
    line.pass(line.name().empty() ? 1 : line.name().size());
  const char c = line.peek();
  if (c == '[') return pass_brackets(line);
  if (c == '\'') {
    std::string_view text;
    line.pass(1);
    if (!line.take_up_to('\'', text)) line.pass(line.rest().size());
    return;
  }
  if (is_digit(c) || c == '.')
    line.take_number();
  else
    line.pass(line.name().size());
  if (line.ahead(0) == '[') pass_brackets(line);
}

void pass_expression(Line& line) { pass_operands(line, "+-*/", pass_operand, is_operator); }

/// Pass over = and what is given after it.
void pass_given(Line& line, WrittenWord& word) {
  line.pass(1);
  cncsub::pass_given(line, word, pass_expression);
}

void pass_address(Line& line, char letter, WrittenWord& word) {
  word.address = letter;
  line.pass(1);
  if (line.peek() == '=') return pass_given(line, word);
  const char c = line.peek();
  if (is_digit(c) || c == '.' || c == '-' || c == '+') pass_number(line, word);
}

void pass_word(Line& line, WrittenWord& word) {
  const std::string name = capitals(line.name());
  const KnownWord* const known = find_word(name);
  const bool variable = line.begins_word() || name.starts_with('V');
  if (known != nullptr && known->treatment == Treatment::Statement) {
    line.pass(line.rest().size());
  } else if (variable && (!name.starts_with('N') || name.size() <= 1)) {
    line.pass(name.size());
    if (line.ahead(0) == '[') pass_brackets(line);
    if (line.peek() == '=') pass_given(line, word);
    word.known = false;
  } else if (name.starts_with('N') && name.size() > 1 && !is_digit(name[1])) {
    line.pass(name.size());  // the name of a block
  } else if (!name.empty() && is_letter(name[0])) {
    pass_address(line, name[0], word);
  } else {
    const std::string_view first = first_character(line.rest());
    word.address = first;
    line.pass(first.size());
    if (first == "/" && is_digit(line.ahead(0))) line.pass(1);
  }
}

}  // namespace

}  // namespace okuma

// The rules that the language asks, as far as it is computed: its words, its statements and its
// calls have their own way.
const std::string_view okuma_rules =
    "refuses power_on reset_clears missing_end g_codes unlisted_codes "
    "self_call caller_call max_repeats zero_repeats too_many_repeats "
    "max_nesting max_total_nesting "
    "modal_locals modal_trigger max_modal_calls second_modal_call cancel_alone calls_in_modal "
    "roles main_return end_in_subprogram "
    "machine g_meanings rapid_rate max_feed arc_tolerance arc_tolerance_share no_radius "
    "small_radius negative_radius helix dwell_words dwell_unit feed_mode_change "
    "max_extra_systems max_offset_number start_up acute_corner idle_blocks missing_radius_offset "
    "length_type computed_lengths angle_unit";

const double okuma_precision = 0;  // a number has 64 bits

const std::span<const WordUse> okuma_word_uses;
const Spelling okuma_spelling{.comment = {"(", ")"},
                              .value = {"=[", "]"},
                              .message = {},
                              .head = {"O", ""},
                              .operators = [](LogicOrder) { return okuma::kOperators; },
                              .numbered = false,
                              .variable = "V",
                              .variable_name = okuma::name_of_variable,
                              .program_name = {"", ""},
                              .open_comments = true};

std::optional<WrittenWord> okuma_word(std::string_view block, std::size_t& from) {
  using namespace okuma;
  Line line;
  line.set(block.substr(std::min(from, block.size())), static_cast<std::uint32_t>(from));
  if (line.at_end()) return std::nullopt;
  WrittenWord word;
  word.at = line.offset();
  pass_word(line, word);
  const std::size_t end = end_of_character(block, word.at + line.width_from(word.at));
  word.width = static_cast<std::uint32_t>(end - word.at);
  for (const char c : block.substr(word.at, word.width))
    if (!is_blank(c)) word.text += upper(c);
  from = std::size_t{word.at} + word.width;
  return word;
}

std::vector<Keyword> okuma_keywords(const Control& /*control*/) {
  using namespace okuma;
  std::vector<Keyword> all;
  for (const KnownWord& of : known_words()) {
    const bool computed = of.treatment == Treatment::Statement || of.treatment == Treatment::Value;
    const bool passed = of.treatment == Treatment::PassedOver;
    all.push_back({std::string(of.word),
                   computed ? "computed"
                   : passed ? "passed-over"
                            : "not-computed",
                   std::string(of.does), "", computed || passed ? "" : "+code-not-computed",
                   kSource});
  }
  return all;
}

}  // namespace cncsub
