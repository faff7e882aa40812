// The language of LinuxCNC as others see it: its words, its spelling and the rules that it asks.
#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/ngc_values.hpp"
#include "cncsub/dialect/ngc_words.hpp"

namespace cncsub {

namespace {

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

const double linuxcnc_precision = 0;  // a number has 64 bits

// A comment in brackets after a message would be shown instead: the last comment counts.
const Spelling linuxcnc_spelling{.comment = {";", ""},
                                 .value = {"[", "]"},
                                 .message = {"(MSG,", ")"},
                                 .head = {},
                                 .operators = [](LogicOrder) { return ngc_operators; },
                                 .long_numbers = true,
                                 .polar = kPolar,
                                 .own_m_codes = {100, 199},
                                 .unsigned_words = "LST"};

std::optional<WrittenWord> linuxcnc_word(std::string_view block, std::size_t& from) {
  return ngc_word(block, from, kPolar);
}

}  // namespace cncsub
