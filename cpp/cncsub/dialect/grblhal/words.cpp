// The words of a line as grblHAL writes them. A flow word is one word with all the text after it,
// and an assignment is one with its value.
#include "cncsub/text/words.hpp"

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/grblhal/expression.hpp"

namespace cncsub {

namespace {

void pass_bracket(Scanner& s) {
  if (s.peek() != '[') return;
  int open = 0;
  for (char c = s.peek(); c != '\0'; c = s.peek()) {
    open += c == '[' ? 1 : c == ']' ? -1 : 0;
    ++s.at;
    if (open == 0) return;
  }
}

/// Pass over a number, #5, #<name>, [1 + 2] or SIN[30], with its signs.
void pass_value(Scanner& s) {
  while (s.peek() == '+' || s.peek() == '-' || s.peek() == '#') ++s.at;
  if (s.peek() == '<') {
    while (s.at != s.end && *s.at != '>') ++s.at;
    if (s.at != s.end) ++s.at;
    return;
  }
  if (is_letter(s.peek())) {
    while (is_letter(s.peek())) ++s.at;
    pass_bracket(s);
    if (s.take('/')) pass_bracket(s);  // ATAN
    return;
  }
  if (s.peek() == '[') return pass_bracket(s);
  while (is_digit(s.peek()) || s.peek() == '.') ++s.at;
}

}  // namespace

// The rules that the language of grblHAL asks. It has its own way with characters, numbers, words
// and statements, and no codes of corners, rotation, scaling, stored stroke or radius compensation.
const std::string_view grblhal_rules =
    "refuses power_on reset_clears missing_end g_codes "
    "max_program_digits max_macro_digits program_word call_values zero_repeats "
    "self_call caller_call max_nesting max_macro_nesting nesting_counts_macros "
    "max_total_nesting roles main_return end_in_subprogram "
    "machine g_meanings power_on_feed rapid_rate max_feed "
    "arc_tolerance arc_tolerance_share no_radius small_radius negative_radius helix "
    "drops_centre_across dwell_words dwell_unit machine_move max_extra_systems data_forms "
    "length_type cycle_repeats cycle_approach "
    "zero_cycle_repeats "
    "computed_lengths codes_that_move feed_mode_change feed_unit";

// A number has 32 bits, and comes to its decimals in a few steps, each with a rounding of its own.
// [gHn, read_float]
const double grblhal_precision = 0x1p-20;

const Spelling grblhal_spelling{.comment = {";", ""},
                                .value = {"[", "]"},
                                .message = {"(MSG,", ")"},
                                .head = {},
                                .operators = [](LogicOrder) { return grblhal::kOperators; },
                                .long_numbers = true,
                                .unsigned_words = "LST"};

std::optional<WrittenWord> grblhal_word(std::string_view block, std::size_t& from) {
  Scanner s{block.data() + from, block.data() + block.size(), block.data()};
  const char c = s.peek();
  if (s.at == s.end || c == ';') return std::nullopt;
  const char* start = s.at++;
  WrittenWord word;
  if (c == 'O') {
    while (s.at != s.end && *s.at != ';') ++s.at;
  } else if (c == '#') {
    word.address = "#";
    pass_value(s);
    if (s.take('=')) pass_value(s);
  } else if (is_letter(c)) {
    word.address = std::string(1, c);
    Scanner ahead = s;
    take_number(ahead, word);
    pass_value(s);
  } else {
    word.address = first_character({start, static_cast<std::size_t>(s.end - start)});
    s.at = start + word.address.size();
  }
  s.at = place_word(word, block, start, s.at);
  for (char& of : word.text) of = upper(of);
  from = static_cast<std::size_t>(s.at - block.data());
  return word;
}

}  // namespace cncsub
