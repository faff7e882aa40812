// The rules that the language of the SINUMERIK asks, as far as it is computed: its words, its
// statements and its calls have their own way.
#include <string_view>

#include "cncsub/dialect/dialect.hpp"

namespace cncsub {

const std::string_view sinumerik_rules =
    "refuses power_on missing_end g_codes max_sequence_number "
    "self_call caller_call max_repeats zero_repeats too_many_repeats max_nesting max_total_nesting "
    "roles main_return end_in_subprogram commons "
    "machine g_meanings rapid_rate max_feed arc_tolerance arc_tolerance_share no_radius "
    "small_radius negative_radius helix dwell_words "
    "dwell_turn_words unit_change computed_lengths";

}  // namespace cncsub
