"""What a test expects of a run: `assert_ends`, `assert_alarm`, and the text of a failure."""

import pytest

import cncsub

ENDS = "O1\nN10 #100=5\nM30\n"
ALARMS = "O1\nN10 #100=5\nN20 M98 P2\nM30\nO2\nN30 M98 P9\nM99\n"  # 078 on a 16i


def run_of(text: str) -> cncsub.Run:
    return cncsub.loads(text, control="fanuc-16i").run(max_blocks=1000)


def test_a_run_that_ends() -> None:
    run_of(ENDS).assert_ends()


@pytest.mark.parametrize(
    ("text", "why"),
    [
        (ALARMS, "alarm 078 program-not-found at O2 N30"),
        ("O1\nN10 GOTO10\n", "Stop.LIMIT"),
        ("O1\nM0\nM99\n", "Stop.CYCLES"),
    ],
)
def test_a_run_that_does_not_end(text: str, why: str) -> None:
    with pytest.raises(AssertionError) as failure:
        run_of(text).assert_ends()
    assert str(failure.value).startswith("the program does not end: it stopped with ")
    assert why in str(failure.value).splitlines()[0]


def test_a_failure_shows_what_happened() -> None:
    with pytest.raises(AssertionError) as failure:
        run_of(ALARMS).assert_ends()
    shown = str(failure.value)
    assert "N30 M98 P9" in shown  # the block, as the message of the alarm has it
    assert "called from O0001 N20" in shown or "called from O1 N20" in shown
    assert (
        "the last of 2 blocks:\n  O1 N10, line 2, depth 0: N10 #100=5\n"
        "  O1 N20, line 3, depth 0: N20 M98 P2" in shown
    )
    assert shown.endswith("variables: #100 = 5")


def test_a_failure_is_no_longer_than_it_must_be() -> None:
    text = "O1\n" + "".join(f"#{n}={n}\n" for n in range(100, 140)) + "M98 P9\n"
    with pytest.raises(AssertionError) as failure:
        run_of(text).assert_ends()
    shown = str(failure.value)
    assert "and 16 more with a value" in shown
    assert shown.count("line ") < 12


@pytest.mark.parametrize(
    ("expected", "at"),
    [
        ("078", None),
        ("program-not-found", None),
        ("078", "O2 N30"),
        ("078", "O0002 N30"),
        ("078", "o2"),
        ("078", "n30"),
        ("078", "2 N30"),
    ],
)
def test_the_alarm_that_is_expected(expected: str, at: str | None) -> None:
    run_of(ALARMS).assert_alarm(expected, at=at)


@pytest.mark.parametrize(
    ("text", "expected", "at"),
    [
        (ALARMS, "077", None),
        (ALARMS, "Program-Not-Found", None),
        (ALARMS, "078", "O1"),
        (ALARMS, "078", "O1 N30"),
        (ALARMS, "078", "N20"),
        (ALARMS, "078", "O2 N3"),
        (ENDS, "078", None),
        (ENDS, "078", "O1 N10"),
    ],
)
def test_another_alarm_or_another_place_fails(text: str, expected: str, at: str | None) -> None:
    with pytest.raises(AssertionError, match=f"^expected alarm {expected}"):
        run_of(text).assert_alarm(expected, at=at)


@pytest.mark.parametrize(
    ("expected", "at", "error", "says"),
    [
        (78, None, TypeError, "the number or the cause of an alarm, a text, not 78"),
        (None, None, TypeError, "not None"),
        ("078", 30, TypeError, 'such as "O10 N30", not 30'),
        ("078", "", ValueError, 'such as "O10 N30"'),
        ("078", "O2 N30 L1", ValueError, 'such as "O10 N30"'),
        ("078", "O7 N30", ValueError, "there is no program O7"),
    ],
)
def test_wrong_use_is_told(expected: object, at: object, error: type[Exception], says: str) -> None:
    with pytest.raises(error, match=says):
        run_of(ALARMS).assert_alarm(expected, at=at)  # type: ignore[arg-type]
