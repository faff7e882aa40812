"""A code of the list of a control is never refused with the number of the control."""

from __future__ import annotations

import pytest

import cncsub

MACHINES = ("mill", "lathe-a", "lathe-b")
# Codes that are read before their moves are looked up: calls and their ends.
CALLS = {"65", "66", "66.1", "67"}


def codes(control: cncsub.Control) -> list[str]:
    """Return the codes of the list; the SINUMERIK writes those with tenths as words."""
    listed = str(next(rule.value for rule in control.rules if rule.name == "g_codes")).split()
    words = control.name.startswith("siemens")
    return [code for code in listed if not (words and "." in code)]


def stopped(control: cncsub.Control, machine: str, code: str) -> cncsub.Alarm | None:
    text = f"N10 G{code}\nN20 M30\n"
    return cncsub.loads(text, control=control).run(setup=cncsub.Setup(machine=machine)).alarm


@pytest.mark.parametrize("machine", MACHINES)
@pytest.mark.parametrize("name", list(cncsub.controls))
def test_a_listed_code_is_run_or_not_computed_here(name: str, machine: str) -> None:
    control = cncsub.controls[name]
    refused = []
    for code in codes(control):
        alarm = stopped(control, machine, code)
        if alarm is not None and alarm.cause in ("g-code-not-available", "code-not-known"):
            refused.append(code)
        if alarm is not None and alarm.cause == "code-not-computed":
            assert alarm.number is None
    assert refused == []


@pytest.mark.parametrize("machine", MACHINES)
@pytest.mark.parametrize("name", list(cncsub.controls))
def test_a_code_outside_the_list_is_refused_or_not_known(name: str, machine: str) -> None:
    control = cncsub.controls[name]
    asked = {rule.name: rule.value for rule in control.rules}
    complete = asked.get("unlisted_codes", "refused") == "refused"  # a language with its own list
    listed = set(codes(control)) | CALLS
    none = {"10", "15", "16", "31", "45", "46", "47", "48", "96"} if name == "hnc-21m" else set()
    every = {f"{tenths / 10:g}" for tenths in range(1000)} - listed
    entry = control.alarms.get("g-code-not-available")
    for code in sorted(every, key=float):
        alarm = stopped(control, machine, code)
        assert alarm is not None, code
        if complete or code in none:
            assert alarm.cause == "g-code-not-available", code
            own = (n for n, _ in entry.directed.values()) if entry else ()
            assert alarm.number in {entry.number if entry else None, *own}
        else:
            assert (alarm.cause, alarm.number) == ("code-not-known", None), code


def value(control: cncsub.Control, name: str) -> str:
    return str(next(rule.value for rule in control.rules if rule.name == name))


@pytest.mark.parametrize("name", [n for n, c in cncsub.controls.items() if not c.absent])
def test_an_entry_is_added_to_a_list_and_taken_away(name: str) -> None:
    control = cncsub.controls[name]
    changed = control.replace(g_meanings="68.2=neutral", functions="RAND", refuses="groove-axis")
    for rule, entry in (("g_meanings", "68.2=neutral"), ("functions", "RAND")):
        assert set(value(changed, rule).split()) == {*value(control, rule).split(), entry}
    back = changed.replace(g_meanings="-68.2")
    assert value(back, "g_meanings") == value(control.replace(g_meanings=""), "g_meanings")
    again = changed.replace(g_meanings="68.2=not-computed 69.1=neutral")
    assert "68.2=not-computed" in value(again, "g_meanings").split()
    assert "68.2=neutral" not in value(again, "g_meanings").split()


def test_a_meaning_that_is_added_leaves_the_others() -> None:
    """G22 of the HNC-21M stays the unit of pulses."""
    control = cncsub.controls["hnc-21m"].replace(g_meanings="68.2=neutral")
    run = cncsub.loads("%1\nN10 G22\nN20 G1 X1000 F1000\nN30 M30\n", control=control).run()
    assert run.moves.x[-1] == pytest.approx(1.0)


def test_a_whole_list_is_given_with_an_equals_sign() -> None:
    control = cncsub.controls["fanuc-0i-f"].replace(g_codes="= 0 1 4", point_addresses="XYZ")
    assert value(control, "g_codes") == "0 1 4"
    assert value(control, "point_addresses") == "XYZ"


@pytest.mark.parametrize(
    ("rule", "entry", "told"),
    [
        (
            "g_meanings",
            "68.2=neutrl",
            "neutrl is not a known meaning of a G code; the nearest are neutral",
        ),
        ("g_meanings", "68.2", "write 68.2=neutral"),
        ("g_meanings", "68.25=neutral", "68.25 is not a code"),
        ("g_meanings", "-68.2", "there is no 68.2 to remove"),
        ("functions", "SINN", "SINN is not a known function; the nearest are SIN"),
        (
            "refuses",
            "no-such-cause",
            "no-such-cause is not a known cause that may be refused; the nearest are",
        ),
        (
            "refuses",
            "program-not-found",
            "program-not-found is not a known cause that may be refused",
        ),
        ("refuses", "groove-axs", "nearest are groove-axis"),
        ("g_codes", "1 G2", "G2 is not a code"),
        ("codes_not_with_call", "x", "x is not a code"),
        ("modal_groups", "plan=2", "plan is not a known group of G codes; the nearest are plane"),
        ("modal_groups", "plane", "write plane=2"),
        ("chamfer_words", ",,C", "write C or ,C"),
        ("statements", "DPRN", "DPRN is not a known macro statement; the nearest are DPRNT"),
        ("point_addresses", "XYz", "'z' is not an address"),
        ("point_addresses", "Xé", "'é' is not an address"),
        ("name_marks", "+A", "'A' is not a mark"),
    ],
)
def test_a_bad_entry_of_a_list_is_named(rule: str, entry: str, told: str) -> None:
    with pytest.raises(ValueError, match=rule) as raised:
        cncsub.controls["fanuc-0i-f"].replace(**{rule: entry})
    assert told in str(raised.value)


@pytest.mark.parametrize(
    ("rule", "entry", "message"),
    [
        ("commons", "{}", "commons: 129 ranges are more than the 128 that a control can hold"),
        ("g_meanings", "{}=neutral", "g_meanings: at most 128 entries"),
    ],
)
def test_a_list_says_how_many_entries_it_holds(rule: str, entry: str, message: str) -> None:
    control = cncsub.controls["fanuc-0i-d"]
    entries = [entry.format(number) for number in range(500, 758, 2)]
    assert len(value(control.replace(**{rule: "= " + " ".join(entries[:-1])}), rule).split()) == 128
    with pytest.raises(ValueError, match=message):
        control.replace(**{rule: "= " + " ".join(entries)})
