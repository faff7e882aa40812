"""Rules that no row can notice on a control, each with the reason why it is inert there.

Rows can say the same of one control: `inert(rules, control=..., reason=...)`.
"""

import cncsub
from cncsub.questions.values import entries_of
from conformance import inert_rules, rows

TA, T, TDI, MDI, TE = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "gsk-928te"
MITSUBISHI = ("mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800")
F16, F0D, F0F, F30 = FANUC = ("fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i")
HNC = "hnc-21m"
HAAS = "haas-ngc"
MAZAK = "mazak-smooth"
LINUXCNC = "linuxcnc"
GRBLHAL = "grblhal"
OKUMA = "okuma-osp-p300"
ONE = "siemens-one"
GSK_LATHES = (TA, T, TDI, TE)
MILLS = (MDI, HNC, HAAS)
EVERY = (*GSK_LATHES, MDI, *MITSUBISHI, *FANUC, HNC, HAAS)
NOT_MDI = tuple(name for name in EVERY if name != MDI)

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

NO_SUCH_ENTRY = (
    "the language has no code or state that this is about, or says itself what becomes of it"
)

NOT_KNOWN = "no source says which codes of the control this rule is about"

Unpinned = dict[str, tuple[tuple[str, ...], str]]


def _all(rules: str, controls: tuple[str, ...], reason: str) -> Unpinned:
    return dict.fromkeys(rules.split(), (controls, reason))


def _sets(control: str, rules: str, but: str, reason: str) -> Unpinned:
    """Return the reason for all entries of these sets, except those in `but`."""
    pinned = {word for row in rows() for word in row.case.pins}
    words = [
        word
        for rule in cncsub.controls[control].rules
        if rule.name in rules.split()
        for word in (f"{rule.name}:{entry}" for entry in entries_of(rule))
        if word not in but.split() and (rule.name not in ("refuses", "roles") or word in pinned)
    ]
    return dict.fromkeys(words, ((control,), reason))


def _joined(*parts: Unpinned) -> dict[str, dict[str, str]]:
    reasons: dict[str, dict[str, str]] = {}
    for part in parts:
        for rule, (controls, reason) in part.items():
            reasons.setdefault(rule, {}).update(dict.fromkeys(controls, reason))
    return reasons


# The reason by rule and control.
_TABLE = _joined(
    # Reading
    _all("late_sequence_numbers", (TDI, MDI), "an N that is not the first word is refused"),
    _all("max_words", (TDI,), "no block of 255 characters has a hundred words that may differ"),
    _all("program_heads:name", (TA, T, TDI), "<NAME> ends the program before it either way"),
    _all("max_program_number", (TE, HNC), "the control's heads and calls are not held to it"),
    # Words of other languages
    _all(
        "arc_angle_words added_turns poles extra_system_codes tool_edges shifts_move_increments"
        " modal_round_words corner_feed_words modal_corner_feed_words contour_offset_words"
        " fine_shift",
        (*EVERY, "syntec-22ma"),
        "no source tells of such words, or of such a D",
    ),
    _all(
        "unused_words_told corner_idle_blocks corner_feed_of_next round_before_chamfer"
        " corner_reduced corners_in_rapid",
        (*EVERY, "syntec-22ma"),
        "no source says what the control makes of such words and blocks",
    ),
    _all(
        "drops_centre_across",
        (*EVERY, "syntec-22ma"),
        "no source says that the control drops a word of the centre",
    ),
    _all(
        "search_path",
        (*EVERY, "syntec-22ma"),
        "no source says that calls search folders of the control's memory",
    ),
    # Calls
    _all("max_program_digits start_word caller_call", (TE,), "P of M98 is a sequence number"),
    _all("count_and_l refuses:illegal-repeat-count", (TE, *MITSUBISHI, HNC), NO_COUNT),
    _all("name_marks max_name_length", (MDI, TE, MITSUBISHI[0], F16, F0D, HNC), NO_NAMES),
    _all("wide_names", (MDI, TE, MITSUBISHI[0], F16, F0D, HNC), NO_NAMES),
    _all("call_values", (TE,), NO_MACROS),
    _all("return_search", (TE,), NO_JUMP),
    _all("jump_search max_jump_number refuses:jump-in-mdi", (TE, HNC), NO_JUMP),
    _all("refuses:jump-in-offset", (TE, HNC), NO_JUMP),
    _all("code_cascade", (TDI, MDI, HNC), NO_CODE_CALLS),
    _all("registered_codes", EVERY, "no code is registered as delivered: rows register theirs"),
    # Macro statements
    _all("variable_options", (TA, T, TDI, *MILLS), "no source tells of variables that are bought"),
    _all("refuses:logic-of-negative refuses:logic-of-other-than-0-and-1", (TE,), NO_MACROS),
    _all("reset_clears:locals reset_clears:commons", (TE,), NO_MACROS),
    _all("max_loop_number loops_count_across_calls", (HNC,), "loops of the HNC have no numbers"),
    _all("refuses:illegal-variable-value", (TE, HNC), "no system variable of it can be written"),
    _all("modal_groups", (TE, HNC), "the control has no variables of modal codes"),
    _all("variable_forms:9nnn variable_forms:names", (HNC,), "the control has no such variables"),
    _all("atan_range asin_range", (HNC,), "it has no ASIN, and ATAN of one argument is signed"),
    _all("max_ifs", (TA, T, TDI, MDI, *MITSUBISHI[:2], *FANUC), NO_IF_BLOCKS),
    # Macro calls
    _all("nesting_counts_macros max_macro_nesting calls_in_modal", (TE, HNC), NO_MACRO_CALLS),
    _all("refuses:illegal-word-with-return", (TE, HNC), NO_MACRO_CALLS),
    _all("codes_not_with_macro_call", (HNC,), NO_MACRO_CALLS),
    _all("m_codes_not_with_macro_call codes_not_with_modal_call", (HNC,), NO_MACRO_CALLS),
    _all("roles:G66.1=modal-call-every-block", (TE, HNC), NO_MACRO_CALLS),
    _all("max_macro_digits argument_sets", (HNC,), NO_MACRO_CALLS),
    _all("numbered_axis_arguments words_before_macro_call", (HNC,), NO_MACRO_CALLS),
    _all("repeated_argument modal_locals modal_trigger", (HNC,), NO_MACRO_CALLS),
    _all("second_modal_call max_modal_calls cancel_alone", (HNC,), NO_MACRO_CALLS),
    _all("roles:G65=macro-call", (TE,), NO_MACRO_CALLS),
    _all("second_modal_call", (TA, T), "a second G66 is refused while one is active"),
    _all("codes_not_with_macro_call", (TDI,), "the control has no tool length offset"),
    _all("h_codes", (HNC,), NO_MACRO_CALLS),
    _all("prints_leading_blanks", (TA, T, TDI, MDI, HNC), "no source says that it has DPRNT"),
    _all("h99_offset", (TA, T, *MITSUBISHI, *FANUC, HNC), NO_H_CODES),
    _all("user_alarm_offset user_alarm_last", (HNC,), "the control has no #3000"),
    _all("user_alarm_offset", MITSUBISHI, "the alarm of #3000 has one number, whatever the value"),
    _all(
        "computed_whole",
        (*GSK_LATHES, MDI, *MITSUBISHI, HNC, HAAS),
        "no source says what becomes of a computed S or P that is not whole",
    ),
    _all(
        "first_axis_allowance second_axis_allowance",
        (*GSK_LATHES, *MILLS, *MITSUBISHI, F16),
        "no parameter of the control lets a profile turn back a little",
    ),
    # Motion
    _all("g_meanings", (MDI,), "it has none of the codes that mean something else elsewhere"),
    _all("codes_not_turned pattern_codes", NOT_MDI, "it does not refuse what these codes do"),
    _all(
        "codes_not_compensated m_codes_not_compensated",
        EVERY,
        "it refuses no code of a list in radius compensation",
    ),
    _all(
        "written_offset",
        (*GSK_LATHES, MDI, *MITSUBISHI, HNC),
        "no row of it writes a work offset by a variable",
    ),
    _all("feed_unit", (*GSK_LATHES, MDI, HNC), "G20 stands in no block with an F"),
    _all("feed_mode_change", (TE, HNC), NOT_KNOWN),
    _all("codes_that_move", EVERY, "no source tells of words of a motion beside such a code"),
    _all("spindle_at_change", EVERY, "no source tells of the spindle at a tool change"),
    _all("computed_lengths", (TE,), NO_MACROS),
    _all("power_on:G99", GSK_LATHES, A_LATHE),
    _all("power_on:G91", (TDI, TE), "the control has no G91"),
    _all("power_on:G18 power_on:G19", GSK_LATHES, "a lathe wakes up in G18"),
    _all("power_on:G20", (TE,), NOT_KNOWN),
    _all("rotation_words", (TDI, TE), NO_ROTATION),
    _all("rapid_way", (TE,), "without the area of G22 no alarm tells the way of a rapid"),
    _all(
        "codes_not_with_return codes_not_with_call refuses:call-with-words-in-cycle",
        (TE,),
        NOT_KNOWN,
    ),
    _all("unit_change machine_move power_on:G22 stroke_area", (TE,), NOT_KNOWN),
    _all(
        "refuses:machine-zero-not-known max_offset_number start_up acute_corner idle_blocks",
        (TE,),
        NOT_KNOWN,
    ),
    _all(
        "refuses:idle-blocks-in-offset peck_words peck_retract drill_full_retract", (TE,), NOT_KNOWN
    ),
    _all("escape rough_depth rough_escape single_pattern", (TE,), NOT_KNOWN),
    _all("cycle_unit one_block_cycles lead_apart thread_starts", (TE,), NOT_KNOWN),
    _all("thread_words_not_computed run_out_words lead_growth", (TE,), NOT_KNOWN),
    _all("thread_chamfer thread_digits_apart thread_passes thread_angle", (TE,), NOT_KNOWN),
    _all("thread_least_cut thread_allowance groove_retract cycle_point", (TE,), NOT_KNOWN),
    _all("groove_p_diameter profile_monotone max_profile_blocks", (TE,), NOT_KNOWN),
    _all("max_pockets rough_type pocket_pass after_contour", (TE,), NOT_KNOWN),
    _all("bore_return drill_retract", (TE,), NOT_KNOWN),
    _all("refuses:no-feed", (TA,), "a feed is in force from power-on"),
    _all(
        "refuses:arc-axis-not-in-plane refuses:offset-in-wrong-plane refuses:radius-and-centre",
        (TE,),
        "it has no planes",
    ),
    _all("reset_clears:codes reset_clears:local-system refuses:spindle-stopped", (TE,), NOT_KNOWN),
    _all("refuses:spindle-stopped", (HNC,), "no thread of it is computed"),
    _all("power_on:G95", MILLS, "a mill wakes up with feed per minute"),
    _all("refuses:spindle-stopped", (MDI,), "the control cuts no threads"),
    _all("refuses:coordinate-setting-refused", MILLS, A_MILL),
    _all("tool_offset tool_offset_digits set_coordinate_without_tool", (HAAS,), A_MILL),
    _all("escape rough_depth rough_escape single_pattern", (HAAS,), A_MILL),
    _all("cycle_unit groove_p_diameter profile_monotone after_contour", (HAAS,), A_MILL),
    _all("drill_full_retract bore_return chamfer_ik one_block_cycles cycle_point", (HAAS,), A_MILL),
    _all("thread_passes thread_angle thread_least_cut thread_allowance", (HAAS,), A_MILL),
    _all("thread_chamfer thread_digits_apart lead_growth groove_retract", (HAAS,), A_MILL),
    _all("max_pockets max_profile_blocks", (HAAS,), A_MILL),
    _all("peck_words peck_retract", (TDI,), "R is the retract of a peck, K no word of it"),
    _all("bore_return", (TDI,), "the control has no boring cycle"),
    _all("helix", (TE,), "a lathe without a third axis makes no helix"),
    _all(
        "other_system data_forms:L52 data_forms:in-force data_forms:here data_forms:tools",
        (TE, HNC),
        "the control has no G10",
    ),
    _all("data_forms:here data_forms:tools refuses:rotary-axis-in-cycle", GSK_LATHES, A_LATHE),
    _all("data_forms:without-L", (HNC,), "the control has no G10"),
    _all("data_forms:without-L", GSK_LATHES, A_LATHE),
    _all("max_extra_systems", (*GSK_LATHES, HNC), "the control has no G54.1"),
    _all("length_type missing_radius_offset radius_offset_diameter", GSK_LATHES, A_LATHE),
    _all("refuses:peck-negative", GSK_LATHES, "pecks of a lathe are told by other words"),
    _all("refuses:no-peck", GSK_LATHES, "a drilling cycle of a lathe without Q is a plain hole"),
    _all("peck_clearance peck_above", GSK_LATHES, "a drilling cycle draws back a little, not to R"),
    _all("max_rotation", (TDI, TE), NO_ROTATION),
    _all("scale_unit", GSK_LATHES, "a lathe has no scaling"),
    _all("cycle_approach tap_return", GSK_LATHES, A_LATHE),
    _all("cycle_repeats zero_cycle_repeats max_cycle_repeats", (TDI, TE), NO_REPEATS),
    _all("rapid_way power_on:G22 stroke_area", MILLS, "it has no stroke check"),
    _all("longer_words", (*GSK_LATHES, *MILLS), "the control has no G45 to G48"),
    _all("skip_variables", (TE,), NO_MACROS),
    _all(
        "skip_own_feed max_skip_signals skip_signals max_skip_feed measuring measured",
        (TE,),
        "nothing is known of its G31",
    ),
    _all(
        "skip_own_feed max_skip_signals skip_signals max_skip_feed measuring measured",
        (HNC,),
        "the control has no G31",
    ),
    _all("skip_variables", (HNC,), "the control has no G31"),
    _all("one_way_overrun", (*GSK_LATHES, MDI), "the control has no G60"),
    _all("angles_on_mills", GSK_LATHES, A_LATHE),
    _all("angles_on_mills", MILLS, "the control knows no angles"),
    _all("angle_words", MILLS, A_MILL),
    _all("roles:G66=modal-call", (TE, HNC), NO_MACRO_CALLS),
    _all("conditional_return", (TE,), NO_MACROS),
    _all("conditions:values", (HNC,), "its conditions take values anyway"),
    # Haas
    _all("count_and_l refuses:illegal-repeat-count", (HAAS,), NO_COUNT),
    _all("name_marks wide_names max_name_length", (HAAS,), NO_NAMES),
    _all(
        "roles:M97=jump return_search",
        (HAAS,),
        "M97 calls there, and M99 P stays in its own program",
    ),
    _all(
        "calls_in_modal refuses:illegal-word-with-return codes_not_with_modal_call",
        (HAAS,),
        NO_MODAL_CALLS,
    ),
    _all("modal_locals modal_trigger max_modal_calls", (HAAS,), NO_MODAL_CALLS),
    _all("second_modal_call cancel_alone", (HAAS,), NO_MODAL_CALLS),
    _all("max_ifs", (HAAS,), NO_IF_BLOCKS),
    _all("h99_offset", (HAAS,), NO_H_CODES),
    _all("reset_clears:commons", (HAAS,), "all of its commons are kept at power-off"),
    _all(
        "skip_signals measuring measured",
        (HAAS, MAZAK),
        "its other signals and its G37 are not computed",
    ),
    _all("refuses:spindle-stopped", (HAAS,), "the control cuts no threads"),
    _all("tap_feed", GSK_LATHES, A_LATHE),
    _all(
        "call_words_not_computed",
        (*(name for name in EVERY if name != HNC), "syntec-22ma"),
        "I, J and K say nothing in the block of M98",
    ),
    _all(
        "user_alarm_numbers",
        (HNC, *MITSUBISHI, "syntec-22ma"),
        "a user alarm has no number of its own",
    ),
    _all(
        "cycle_words_not_computed",
        (TE, "syntec-22ma"),
        "no letter is without a meaning in its cycles",
    ),
    _all("peck_words", (MAZAK,), "K in the block of a cycle is not computed"),
    _all("parallel_axes", GSK_LATHES, A_LATHE),
    _all("return_to_line", (TE,), "nothing is known of a Q of its M99"),
    _all("return_to_line", (TDI,), "Q is the angle of a line there"),
    # Languages of their own
    _sets(
        LINUXCNC,
        "refuses roles power_on reset_clears data_forms",
        "power_on:G91 power_on:G18 power_on:G19 power_on:G20 power_on:G99 reset_clears:locals"
        " refuses:rotary-axis-in-cycle refuses:spindle-stopped refuses:no-motion-code refuses:no-feed"
        " refuses:arc-axis-not-in-plane refuses:offset-in-wrong-plane refuses:radius-and-centre refuses:peck-negative"
        " data_forms:in-force data_forms:here data_forms:tools"
        " roles:M70=save-modes roles:M71=forget-modes roles:M72=restore-modes roles:M73=keep-modes",
        NO_SUCH_ENTRY,
    ),
    _sets(
        GRBLHAL,
        "refuses roles power_on reset_clears data_forms",
        "power_on:G91 power_on:G18 power_on:G19 power_on:G20 power_on:G99 reset_clears:locals"
        " refuses:no-motion-code refuses:no-feed refuses:no-arc-travel refuses:radius-and-centre"
        " data_forms:in-force data_forms:here"
        " roles:G65=macro-call roles:M30=end"
        " roles:M70=save-modes roles:M71=forget-modes roles:M72=restore-modes",
        NO_SUCH_ENTRY,
    ),
    _sets(
        OKUMA,
        "refuses roles power_on reset_clears",
        "power_on:G91 power_on:G18 power_on:G19 refuses:no-radius roles:M30=end",
        NO_SUCH_ENTRY,
    ),
    _sets(
        ONE,
        "refuses power_on",
        "power_on:G01 power_on:G91 power_on:G18 power_on:G19 power_on:G20 refuses:no-motion-code",
        NO_SUCH_ENTRY,
    ),
)
UNPINNED = {
    rule: {**_TABLE.get(rule, {}), **inert_rules().get(rule, {})}
    for rule in (*_TABLE, *inert_rules())
}
