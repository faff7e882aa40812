// The language of grblHAL as others see it: its words, its spelling and the rules that it asks.
#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/grblhal/expression.hpp"
#include "cncsub/dialect/ngc_values.hpp"
#include "cncsub/dialect/ngc_words.hpp"

namespace cncsub {

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
                                .operators = [](LogicOrder) { return ngc_operators; },
                                .long_numbers = true,
                                .unsigned_words = "LST",
                                .read_number = grblhal::single_of};

std::optional<WrittenWord> grblhal_word(std::string_view block, std::size_t& from) {
  return ngc_word(block, from);
}

}  // namespace cncsub
