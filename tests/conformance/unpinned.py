"""Rules that no row can notice on a control, each with the reason why it is inert there."""

TA, T, TDI, MDI, TE = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "gsk-928te"
MITSUBISHI = ("mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800")
F16, F0D, F0F, F30 = FANUC = ("fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i")
HNC = "hnc-21m"
HAAS = "haas-ngc"
GSK_LATHES = (TA, T, TDI, TE)
MILLS = (MDI, HNC, HAAS)
EVERY = (*GSK_LATHES, MDI, *MITSUBISHI, *FANUC, HNC, HAAS)

NO_MACROS = "the control has no macro statements"
NO_MACRO_CALLS = "the control has no macro calls"
NO_NAMES = "the control calls no programs by name"
NO_COUNT = "P of M98 holds no count on this control"
NO_MODAL_CALLS = "the control has no G66"
NO_IF_BLOCKS = "the control has no IF blocks"
NO_JUMP = "the control has no GOTO, and M99 takes no P"
NO_CODE_CALLS = "no parameter of the control makes a code call a program"
NO_H_CODES = "the control has no G65 H"
A_MILL = "a rule of lathes, and the control is a mill"
A_LATHE = "a rule of mills, and the control is a lathe"
NO_ROTATION = "the control has no rotation, scaling or mirror"
NO_REPEATS = "no repeat count is known of its drilling cycles"

NOT_KNOWN = "no source says which codes of the control this rule is about"

Unpinned = dict[str, tuple[tuple[str, ...], str]]


def _all(rules: str, controls: tuple[str, ...], reason: str) -> Unpinned:
    return dict.fromkeys(rules.split(), (controls, reason))


def _joined(*parts: Unpinned) -> dict[str, dict[str, str]]:
    reasons: dict[str, dict[str, str]] = {}
    for part in parts:
        for rule, (controls, reason) in part.items():
            reasons.setdefault(rule, {}).update(dict.fromkeys(controls, reason))
    return reasons


# The reason by rule and control.
UNPINNED = _joined(
    # Reading
    _all("late_sequence_numbers", (TDI, MDI), "an N that is not the first word is refused"),
    _all("max_words", (TDI,), "no block of 255 characters has a hundred words that may differ"),
    _all("named_programs", (TA, T, TDI), "<NAME> ends the program before it either way"),
    _all("max_program_number", (TE, HNC), "the control's heads and calls are not held to it"),
    # Calls
    _all("max_program_digits start_word caller_call", (TE,), "P of M98 is a sequence number"),
    _all("count_and_l zero_count_alarms", (TE, *MITSUBISHI, HNC), NO_COUNT),
    _all("name_marks max_name_length", (MDI, TE, MITSUBISHI[0], F16, F0D, HNC), NO_NAMES),
    _all("wide_names", (MDI, TE, MITSUBISHI[0], F16, F0D, HNC), NO_NAMES),
    _all("call_values", (TE,), NO_MACROS),
    _all("return_search jump_search max_jump_number jumps_in_mdi", (TE, HNC), NO_JUMP),
    _all("jumps_in_compensation", (TE, HNC), NO_JUMP),
    _all("code_cascade", (TDI, MDI, TE, HNC), NO_CODE_CALLS),
    # Macro statements
    _all("commons variable_point", (TE,), NO_MACROS),
    _all("variable_options", (*GSK_LATHES, *MILLS), "no source tells of variables that are bought"),
    _all("if_form loop_form jumps max_loops max_constant_digits max_brackets", (TE,), NO_MACROS),
    _all("angle_unit atan_range asin_range joined_conditions", (TE,), NO_MACROS),
    _all("comparison_symbols conditions_without_brackets short_functions", (TE,), NO_MACROS),
    _all("functions modulo vacant_address vacant_comparison negative_logic logic_of_bits", (TE,), NO_MACROS),
    _all("reset_clears_locals reset_clears_commons logic_binds_last", (TE,), NO_MACROS),
    _all("max_condition_length indirect_9nnn variable_names", (TE,), NO_MACROS),
    _all("max_loop_number loops_count_across_calls", (TE,), NO_MACROS),
    _all("max_loop_number loops_count_across_calls", (HNC,), "loops of the HNC have no numbers"),
    _all("vacant_system_writes", (TE, HNC), "no system variable of it can be written"),
    _all("modal_groups", (TE, HNC), "the control has no variables of modal codes"),
    _all("indirect_9nnn variable_names", (HNC,), "the control has no such variables"),
    _all("atan_range asin_range", (HNC,), "it has no ASIN, and ATAN of one argument is signed"),
    _all("max_ifs", (TA, T, TDI, MDI, TE, *MITSUBISHI[:2], *FANUC), NO_IF_BLOCKS),
    _all("logic_of_numbers", (TA, T, TDI, MDI, TE, *FANUC), "logic binds like * and + there anyway"),
    # Macro calls
    _all("nesting_counts_macros max_macro_nesting calls_in_modal", (TE, HNC), NO_MACRO_CALLS),
    _all("return_alone_in_modal codes_not_with_macro_call", (TE, HNC), NO_MACRO_CALLS),
    _all("m_codes_not_with_macro_call codes_not_with_modal_call", (TE, HNC), NO_MACRO_CALLS),
    _all("modal_every_block max_macro_digits argument_sets", (TE, HNC), NO_MACRO_CALLS),
    _all("numbered_axis_arguments words_before_macro_call", (TE, HNC), NO_MACRO_CALLS),
    _all("repeated_argument modal_locals modal_trigger", (TE, HNC), NO_MACRO_CALLS),
    _all("modal_calls_stack max_modal_calls cancel_alone", (TE, HNC), NO_MACRO_CALLS),
    _all("macro_calls call_passes_words", (TE,), NO_MACRO_CALLS),
    _all("modal_calls_stack", (TA, T), "a second G66 is refused while one is active"),
    _all("codes_not_with_macro_call", (TDI,), "the control has no tool length offset"),
    _all("h_codes", (TE, HNC), NO_MACRO_CALLS),
    _all("h99_offset", (TA, T, TE, *MITSUBISHI, *FANUC, HNC), NO_H_CODES),
    _all("user_alarm_offset user_alarm_last", (TE, HNC), "the control has no #3000"),
    _all("user_alarm_offset", MITSUBISHI, "the alarm of #3000 has one number, whatever the value"),
    # Motion
    _all("g_meanings", (MDI,), "it has none of the codes that mean something else elsewhere"),
    _all("power_on_incremental", (TDI, TE), "the control has no G91"),
    _all("rotation_words", (TDI, TE), NO_ROTATION),
    _all("straight_rapid", (TE,), "without the area of G22 no alarm tells the way of a rapid"),
    _all("codes_not_with_return codes_not_with_call words_with_call_in_cycle", (TE,), NOT_KNOWN),
    _all("unit_change machine_move power_on_stroke_check stroke_outside", (TE,), NOT_KNOWN),
    _all("home_needed max_offset_number start_up acute_corner idle_blocks", (TE,), NOT_KNOWN),
    _all("idle_blocks_alarm peck_words peck_retract drill_full_retract", (TE,), NOT_KNOWN),
    _all("escape rough_depth rough_escape single_pass_pattern", (TE,), NOT_KNOWN),
    _all("cycle_increments one_block_cycles lead_apart thread_starts", (TE,), NOT_KNOWN),
    _all("thread_words_not_computed run_out_words lead_growth", (TE,), NOT_KNOWN),
    _all("thread_chamfer thread_digits_apart thread_passes thread_angle", (TE,), NOT_KNOWN),
    _all("thread_least_cut thread_allowance groove_retract cycle_point", (TE,), NOT_KNOWN),
    _all("groove_p_diameter profile_monotone max_profile_blocks", (TE,), NOT_KNOWN),
    _all("max_pockets type_by_shape pocket_pass contour_behind", (TE,), NOT_KNOWN),
    _all("bore_return drill_retract", (TE,), NOT_KNOWN),
    _all("clear_on_reset clear_local_on_reset thread_needs_spindle", (TE,), NOT_KNOWN),
    _all("thread_needs_spindle lead_apart run_out_words", (HNC,), "no thread of it is computed"),
    _all("power_on_per_minute", MILLS, "a mill wakes up with feed per minute"),
    _all("thread_needs_spindle", (MDI,), "the control cuts no threads"),
    _all("negative_radius_on_lathes", (MDI, HNC), A_MILL),
    _all("set_coordinate_alarms", MILLS, A_MILL),
    _all("tool_offset tool_offset_digits set_coordinate_without_tool", MILLS, A_MILL),
    _all("escape rough_depth rough_escape single_pass_pattern", MILLS, A_MILL),
    _all("cycle_increments groove_p_diameter profile_monotone contour_behind", MILLS, A_MILL),
    _all("drill_full_retract bore_return chamfer_ik one_block_cycles cycle_point", MILLS, A_MILL),
    _all("thread_passes thread_angle thread_least_cut thread_allowance", MILLS, A_MILL),
    _all("thread_chamfer thread_digits_apart lead_growth groove_retract", MILLS, A_MILL),
    _all("max_pockets max_profile_blocks", MILLS, A_MILL),
    _all("lead_apart run_out_words", (MDI,), "the control cuts no threads"),
    _all("peck_words peck_retract", (TDI,), "R is the retract of a peck, K no word of it"),
    _all("bore_return", (TDI,), "the control has no boring cycle"),
    _all("helix", (TE,), "a lathe without a third axis makes no helix"),
    _all("helix_on_lathes", GSK_LATHES, "the control makes no helix, whatever the machine"),
    _all("other_system_is_first parameters_by_l52", (TE, HNC), "the control has no G10"),
    _all("offsets_without_l", (HNC,), "the control has no G10"),
    _all("offsets_without_l", GSK_LATHES, A_LATHE),
    _all("max_extra_systems", (*GSK_LATHES, HNC), "the control has no G54.1"),
    _all("length_type missing_radius_offset", GSK_LATHES, A_LATHE),
    _all("peck_needed", GSK_LATHES, "a drilling cycle of a lathe without Q is a plain hole"),
    _all("peck_clearance", GSK_LATHES, "a drilling cycle draws back a little, not to R"),
    _all("max_rotation", (TDI, TE), NO_ROTATION),
    _all("scale_thousandths", GSK_LATHES, "a lathe has no scaling"),
    _all("cycle_repeats zero_cycle_repeats max_cycle_repeats", (TDI, TE), NO_REPEATS),
    _all("dwell_x_increments", FANUC, "all whole numbers of lengths count increments there"),
    _all("straight_rapid power_on_stroke_check stroke_outside", MILLS, "it has no stroke check"),
    _all("longer_words", (*GSK_LATHES, *MILLS), "the control has no G45 to G48"),
    _all("skip_variables", (TE,), NO_MACROS),
    _all(
        "skip_own_feed max_skip_signals skip_signals max_skip_feed measuring measuring_subtracts",
        (TE,),
        "nothing is known of its G31",
    ),
    _all(
        "skip_own_feed max_skip_signals skip_signals max_skip_feed measuring measuring_subtracts",
        (HNC,),
        "the control has no G31",
    ),
    _all("skip_variables", (HNC,), "the control has no G31"),
    _all("one_way_overrun", (*GSK_LATHES, MDI), "the control has no G60"),
    _all("angles_on_mills", GSK_LATHES, A_LATHE),
    _all("angles_on_mills", MILLS, "the control knows no angles"),
    _all("angle_words type_by_shape pocket_pass", MILLS, A_MILL),
    _all("thread_starts thread_words_not_computed", MILLS, A_MILL),
    _all("modal_calls", (TE, HNC), NO_MACRO_CALLS),
    _all("conditions_are_values conditional_return", (TE,), NO_MACROS),
    _all("conditions_are_values", (HNC,), "its conditions take values anyway"),
    # Haas
    _all("count_and_l zero_count_alarms", (HAAS,), NO_COUNT),
    _all("name_marks wide_names max_name_length", (HAAS,), NO_NAMES),
    _all("jump_m97 return_search", (HAAS,), "M97 calls there, and M99 P stays in its own program"),
    _all("calls_in_modal return_alone_in_modal codes_not_with_modal_call", (HAAS,), NO_MODAL_CALLS),
    _all("modal_locals modal_trigger max_modal_calls", (HAAS,), NO_MODAL_CALLS),
    _all("modal_calls_stack cancel_alone", (HAAS,), NO_MODAL_CALLS),
    _all("max_ifs", (HAAS,), NO_IF_BLOCKS),
    _all("logic_of_numbers", (HAAS,), "logic binds like * and + there anyway"),
    _all("h99_offset", (HAAS,), NO_H_CODES),
    _all("reset_clears_commons", (HAAS,), "all of its commons are kept at power-off"),
    _all("dwell_x_increments", (HAAS,), "X is no time of G04 there"),
    _all("helix_on_lathes", (HAAS,), A_MILL),
    _all("skip_signals measuring measuring_subtracts", (HAAS,), "its other signals and its G37 are not computed"),
    _all("thread_needs_spindle lead_apart run_out_words", (HAAS,), "the control cuts no threads"),
)
