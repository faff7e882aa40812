// The words of a line as LinuxCNC writes them. An O-word is one word with all the text after it,
// and an assignment is one with its value.
#include "cncsub/text/words.hpp"

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/linuxcnc/expression.hpp"

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

constexpr std::string_view kPolar = "@^";

}  // namespace

// The rules that LinuxCNC's language asks. It has its own way with characters, numbers, words and
// statements, and no codes of corners, rotation, scaling or stored stroke.
const std::string_view linuxcnc_rules =
    "refuses repeated_address power_on reset_clears missing_end g_codes "
    "self_call caller_call max_nesting max_total_nesting roles main_return end_in_subprogram "
    "machine g_meanings modal_groups power_on_feed rapid_rate max_feed "
    "arc_rounding arc_tolerance_share no_radius negative_radius helix "
    "dwell_words dwell_unit speed_limit unit_change machine_move max_extra_systems data_forms "
    "length_type "
    "start_up radius_offset_diameter missing_radius_offset skip_own_feed skip_signals "
    "cycle_repeats max_cycle_repeats cycle_approach tap_return zero_cycle_repeats "
    "peck_retract peck_clearance computed_lengths codes_that_move spindle_at_change "
    "codes_not_compensated m_codes_not_compensated feed_mode_change feed_unit written_offset";

// A comment in brackets after a message would be shown instead: the last comment counts.
const double linuxcnc_precision = 0;  // a number has 64 bits

const Spelling linuxcnc_spelling{.comment = {";", ""},
                                 .value = {"[", "]"},
                                 .message = {"(MSG,", ")"},
                                 .head = {},
                                 .operators = [](LogicOrder) { return linuxcnc::kOperators; },
                                 .long_numbers = true,
                                 .polar = kPolar,
                                 .own_m_codes = {100, 199},
                                 .unsigned_words = "LST"};

std::optional<WrittenWord> linuxcnc_word(std::string_view block, std::size_t& from) {
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
  } else if (is_letter(c) || kPolar.find(c) != std::string_view::npos) {
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
