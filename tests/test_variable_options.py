"""Variables by option: what `replace` takes, what an alarm says of them, and where they are shown."""

from __future__ import annotations

import json
import pickle
import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app
from cncsub.questions.asking import ISO_FAMILY

MITSUBISHI = "mitsubishi-m700"
# The controls whose variables are #1, #100 ..., and whose programs may have a head O1.
OTHERS = ("gsk-928te", "grblhal")
WITH_MACROS = [
    name
    for name in cncsub.controls
    if name not in OTHERS and not name.startswith(("siemens", "okuma"))
]
WITH_COMMONS = [
    name
    for name in WITH_MACROS
    if any(rule.name == "commons" for rule in cncsub.controls[name].rules)
]
WITH_OPTIONS = [
    name
    for name, control in cncsub.controls.items()
    if control.variable_options and control.dialect in ISO_FAMILY
]


def commons(control: cncsub.Control) -> str:
    return str(next(rule.value for rule in control.rules if rule.name == "commons"))


def ranges(text: str) -> list[tuple[int, int]]:
    """Return `100-199 500` as pairs of first and last."""
    pairs = [entry.split("-") for entry in text.split()]
    return [(int(pair[0]), int(pair[-1])) for pair in pairs]


def program(*blocks: str) -> str:
    return "\n".join(["%1", *blocks, "M30", ""])


def run(control: cncsub.Control, *blocks: str, **options: object) -> cncsub.Run:
    text = program(*blocks).replace("%1", "%1" if control.name == "hnc-21m" else "O1")
    return cncsub.loads(text, control=control).run(**options)  # type: ignore[arg-type]


# ---- values that replace takes ----


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("100-199 150-200", "100-199 and 150-200 overlap"),
        ("100-199 500 500", "500 and 500 overlap"),
        ("500-999 100-500", "100-500 and 500-999 overlap"),
        ("199-100", "199-100 ends before it begins: write 100-199"),
        ("1-33", "#1 is a local variable"),
        ("0", "#0 is always vacant"),
        ("33-100", "#33 is a local variable"),
        ("100-1000", "100-1000: #1000 is a system variable of the control"),
        ("3000", "#3000 is a system variable of the control"),
        ("5008-5010", "#5008 is a system variable of the control"),
        ("2201", "#2201 is a system variable of the control, with the option offsets-from-2201"),
        ("100010", "with the option parameter-reading"),
        ("200000-300000", "100001 variables are more than a run can hold: at most 100000"),
        ("0-999999999", "#0 is always vacant"),
        ("1000000-999999999", "999000000 variables are more than a run can hold"),
        ("100-9999999999", "100-9999999999 is neither a range of numbers nor"),
        ("100--199", "100--199 is neither a range of numbers nor an option"),
        ("100-", "100- is neither a range of numbers nor"),
        ("-100", "-100 is neither a range of numbers nor"),
        ("1e2", "1e2 is neither a range of numbers nor"),
        (
            "700-set",
            "700-set is neither a range of numbers nor an option: write 100-199; the nearest are 700-sets",
        ),
        ("parameter-reading", "parameter-reading is neither a range of numbers nor an option"),
    ],
)
def test_a_wrong_entry_of_commons_is_named(text: str, told: str) -> None:
    with pytest.raises(ValueError, match="^commons: ") as raised:
        cncsub.controls[MITSUBISHI].replace(commons=text)
    assert told in str(raised.value)


@pytest.mark.parametrize(
    ("control", "text", "told"),
    [
        ("gsk-980tdi", "100-500", "#995 is missing: G31 writes to it"),
        ("gsk-980mdi", "100-999 9100", "#9000 to #9999 are #[#0] to #[#999] on this control"),
        ("hnc-21m", "100-250", "100-250: #200 is a system variable of the control"),
        ("fanuc-0i-f", "2500", "with the option work-offsets-by-axis"),
        ("gsk-988ta", "8000-sets", "8000-sets is neither a range of numbers nor an option"),
    ],
)
def test_commons_have_to_suit_their_control(control: str, text: str, told: str) -> None:
    with pytest.raises(ValueError, match=re.escape(told)):
        cncsub.controls[control].replace(commons=text)


@pytest.mark.parametrize("value", [100, True, None, ["100-199"]])
def test_commons_are_a_text(value: object) -> None:
    with pytest.raises((TypeError, ValueError)):
        cncsub.controls[MITSUBISHI].replace(commons=value)  # type: ignore[arg-type]


def test_options_of_system_variables_are_added_taken_away_and_checked() -> None:
    control = cncsub.controls[MITSUBISHI]
    both = control.replace(variable_options="parameter-reading").replace(
        variable_options="offsets-from-2201"
    )
    fitted = [o.name for o in both.variable_options.values() if o.fitted and o.rule != "commons"]
    assert fitted == ["offsets-from-2201", "parameter-reading"]
    assert run(both, "#100000=1", "#2201=1").alarm is None
    fewer = both.replace(variable_options="-parameter-reading")
    assert run(fewer, "#2201=1", "#100000=1").alarm is not None
    for wrong in ("parameter-readin", "8000-sets", "-work-offsets-by-axis"):
        with pytest.raises(ValueError, match="^variable_options: .*nearest are"):
            both.replace(variable_options=wrong)


def test_what_is_given_is_put_in_order_and_options_that_share_numbers_are_one() -> None:
    control = cncsub.controls[MITSUBISHI]
    assert commons(control.replace(commons="500-999   100-199")) == "100-199 500-999"
    assert commons(control.replace(commons="=700-sets 200-sets")) == "100-199 400-999"
    assert commons(control.replace(commons="200-sets 900000")) == "100-199 500-599 900000"
    assert commons(control.replace(commons="")) == ""
    assert run(control.replace(commons=""), "#100=1").alarm.cause == "illegal-variable"  # type: ignore[union-attr]


# ---- the variables that exist ----


SPAN = st.tuples(
    st.integers(34, 990) | st.integers(97_990, 98_510) | st.integers(899_990, 907_410),
    st.integers(0, 60),
)


@pytest.mark.parametrize("name", WITH_COMMONS)
@settings(max_examples=20)
@given(data=st.data())
def test_exactly_the_commons_that_were_given_hold_values(name: str, data: st.DataObject) -> None:
    """They are written, read back, read by computed number, step by step, and from Python alike."""
    base = cncsub.controls[name]
    pairs: list[tuple[int, int]] = []
    for first, more in sorted(data.draw(st.lists(SPAN, min_size=1, max_size=4))):
        if not pairs or first > pairs[-1][1]:
            pairs.append((first, first + more))
    text = " ".join(f"{first}-{last}" for first, last in pairs)
    try:
        control = base.replace(commons=text)
    except ValueError as wrong:
        if re.search("of the control|local|#9000|is missing", str(wrong)):
            return
        raise
    for number in {n + by for pair in pairs for n in pair for by in (-1, 0, 1)}:
        held = any(first <= number <= last for first, last in pairs)
        alarm = run(base.replace(commons=""), f"#{number}=1").alarm
        if alarm is None or alarm.cause != "illegal-variable":
            continue  # the control answers it itself, whatever the commons are
        text = program(f"#{number}=7", f"#{number}=[#[{number}]+#{number}]")
        library = cncsub.loads(
            text.replace("%1", "%1" if name == "hnc-21m" else "O1"), control=control
        )
        made = library.run()
        steps = library.machine()
        steps.run()
        assert (made.alarm is None) is held is (steps.alarm is None)
        assert made.variables == steps.variables == ({number: 14.0} if held else {})
        if held:
            assert library.run(variables={number: 3}).variables[number] == 14.0
        else:
            assert made.alarm is not None
            assert made.alarm.cause == "illegal-variable"
            with pytest.raises(ValueError, match=f"variables: there is no #{number}"):
                library.run(variables={number: 3})


@pytest.mark.parametrize("name", WITH_OPTIONS)
def test_an_alarm_names_an_option_that_has_the_variable_and_how_it_is_fitted(name: str) -> None:
    """If a user does what the detail says, the same program runs."""
    control = cncsub.controls[name]
    for option in control.variable_options.values():
        for number in {end for pair in ranges(option.numbers) for end in pair}:
            for block in (f"#101=#{number}", f"#101=#[{number}]"):
                alarm = run(control, block).alarm
                if option.fitted:
                    assert alarm is None
                    continue
                if alarm is None:
                    continue  # another option that is fitted has it
                assert alarm.cause == "illegal-variable"
                assert f"there is no #{number}" in alarm.detail
                said = re.search(r'control\.replace\((\w+)="([\w-]+)"\)', alarm.detail)
                assert said is not None
                assert run(control.replace(**{said[1]: said[2]}), block).alarm is None


def test_what_no_option_brings_is_only_said_not_to_be_there() -> None:
    for name in WITH_MACROS:
        alarm = run(cncsub.controls[name], "#101=#88888").alarm
        assert alarm is not None
        unknown = alarm.cause == "variable-not-known"
        assert alarm.detail == ("#88888 cannot be read" if unknown else "there is no #88888")


def test_an_option_stays_fitted_where_the_list_of_the_control_does_not_change() -> None:
    """The variables of the control itself stay what they were, whatever its commons are."""
    for name in WITH_OPTIONS:
        few = cncsub.controls[name].replace(commons="100")
        assert run(few, "#5221=4", "#100=#5221").variables[100] == 4.0
        assert run(few, "#1=4", "#100=#1").variables[100] == 4.0


# ---- machines, inputs, copies, limits ----


def test_variables_by_option_are_variables_everywhere() -> None:
    control = cncsub.controls[MITSUBISHI].replace(commons="8000-sets")
    library = cncsub.loads(
        "O1\n#900000=1\nN1 IF[#900001NE2]GOTO1\n#907399=#450\nM30\n", control=control
    )
    machine = library.machine(variables={450: 5}, inputs={"writes": [{900001: 2}]})
    while machine.step():
        pass
    assert dict(machine.variables) == {450: 5, 900000: 1, 900001: 2, 907399: 5}
    twin = machine.copy()
    twin.variables[900000] = 9
    assert (machine.variables[900000], twin.variables[900000]) == (1, 9)
    del twin.variables[907399]
    assert 907399 not in twin.variables
    with pytest.raises((KeyError, ValueError), match="there is no #907400"):
        twin.variables[907400] = 1
    with pytest.raises(ValueError, match="writes: there is no #899999"):
        library.run(inputs={"writes": [{899999: 2}]})
    assert library.mdi("#907398=3").variables[907398] == 3


def test_a_changed_control_is_the_same_when_it_comes_out_of_a_pickle() -> None:
    control = cncsub.controls[MITSUBISHI].replace(
        commons="100-149 900000-900009", variable_options="parameter-reading", g_codes="-54"
    )
    again = pickle.loads(pickle.dumps(control))
    assert [(r.name, r.value, r.source) for r in again.rules] == [
        (r.name, r.value, r.source) for r in control.rules
    ]
    assert run(again, "#900009=1", "#100000=1").alarm is None
    assert run(again, "#150=1").alarm is not None
    fitted = [(o.name, o.fitted) for o in control.variable_options.values()]
    assert [(o.name, o.fitted) for o in again.variable_options.values()] == fitted


def test_the_memory_of_a_run_counts_its_commons() -> None:
    control = cncsub.controls[MITSUBISHI]
    few = control.replace(commons="100-199")
    most = control.replace(commons="500-999 200000-299499")
    assert len(ranges(commons(most))) == 2
    loop = ("N10 #500=#500+1", "GOTO10")
    assert run(most, *loop, max_blocks=2000, max_memory=200_000).stop is cncsub.Stop.LIMIT
    assert run(few, "#100=1", max_memory=200_000).stop is cncsub.Stop.END
    assert run(most, "#100=1", max_memory=200_000).stop is not cncsub.Stop.END


# ---- the places that show them ----


def test_the_options_of_a_control_name_their_source() -> None:
    for control in cncsub.controls.values():
        for name, option in control.variable_options.items():
            assert name == option.name
            assert option.source
            assert option.evidence in ("secondary", "inferred")
            assert ranges(option.numbers)
            assert repr(option).startswith(f"<VariableOption {name}: {option.numbers}")


@pytest.mark.parametrize("name", list(cncsub.controls))
def test_the_command_line_lists_the_options(name: str) -> None:
    shown = CliRunner().invoke(app, ["controls", name, "--all"]).output
    facts = json.loads(CliRunner().invoke(app, ["controls", name, "--format", "json"]).output)
    options = cncsub.controls[name].variable_options
    assert [option["name"] for option in facts["variable_options"]] == list(options)
    assert ("Variables by option" in shown) is bool(options)
    if any(rule.name == "commons" for rule in cncsub.controls[name].rules):
        assert f"commons = {commons(cncsub.controls[name]) or 'none'}: " in shown
    elif "macros" in cncsub.controls[name].absent:
        assert "no rules of macros" in shown
    for option in options.values():
        fitted = ", fitted" if option.fitted else ""
        assert f"{option.rule}={option.name}{fitted}: {option.meaning}: {option.numbers}" in shown
