"""Several texts as one memory, and a memory with one program in place of another."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest

import cncsub

CONTROL = "fanuc-0i-f"
JOB = {
    "O1.nc": "O1\nM98 P2\nM98 P3\nM30\n",
    "subs.nc": "%\nO2\n#100=2\nM99\nO3\n#101=3\nM99\n%\n",
}


def library() -> cncsub.Library:
    return cncsub.loads(JOB, control=CONTROL)


def values(of: cncsub.Library) -> tuple[float | None, float | None]:
    run = of.run()
    run.raise_for_alarm()
    return run.variables[100], run.variables[101]


# ---- loads ----


def test_a_list_of_texts_is_one_memory() -> None:
    both = cncsub.loads(["O1\nM98 P2\nM30\n", b"O2\n#100=7\nM99\n"], control=CONTROL)
    assert (list(both), both.files) == (["O1", "O2"], ("<text 1>", "<text 2>"))
    assert both.run().variables[100] == 7


def test_texts_have_the_names_of_their_files() -> None:
    both = library()
    assert (list(both), both.files) == (["O1", "O2", "O3"], ("O1.nc", "subs.nc"))
    assert (both["O3"].file, both["O3"].line) == ("subs.nc", 5)
    alarm = cncsub.loads({"a.nc": "O1\nM98 P9\nM30\n"}, control=CONTROL).run().alarm
    assert alarm is not None
    assert alarm.file == "a.nc"


def test_a_name_gives_a_program_without_one_its_own() -> None:
    both = cncsub.loads({"job/O7.nc": "M98 P8\nM30\n", "O8": "#100=1\nM99\n"}, control=CONTROL)
    assert list(both) == ["O7", "O8"]
    assert both.run().variables[100] == 1


def test_no_texts_are_an_empty_memory() -> None:
    assert len(cncsub.loads([], control=CONTROL)) == len(cncsub.loads({}, control=CONTROL)) == 0


@pytest.mark.parametrize(
    ("text", "options", "told"),
    [
        (["O1\n", 5], {}, "a text or bytes, not int"),
        ({"a": None}, {}, "a text or bytes, not NoneType"),
        ({5: "O1\n"}, {}, "name must be a file name, not int"),
        ({None: "O1\n"}, {}, "must be names of files, not None"),
        (Path("a.nc"), {}, "load takes paths"),
        (5, {}, "not int; load takes paths"),
        (["O1\n"], {"name": "a"}, "name is for one text"),
        ("O1\n", {"name": 5}, "name must be a file name"),
    ],
)
def test_what_is_no_text_is_a_type_error(
    text: object, options: dict[str, object], told: str
) -> None:
    with pytest.raises(TypeError, match=told):
        cncsub.loads(text, control=CONTROL, **options)  # type: ignore[arg-type]


# ---- with_program ----


def test_one_program_takes_the_place_of_another() -> None:
    before = library()
    after = before.with_program("O2\n#100=20\nM99\n")
    assert (values(before), values(after)) == ((2, 3), (20, 3))
    assert sorted(after) == ["O1", "O2", "O3"]
    assert (after.duplicates, after.notes) == ((), ())
    assert after.main is not None
    assert after.main.name == "O1"


@pytest.mark.parametrize("name", ["O2", "O0002", "O00002"])
def test_it_is_found_however_its_name_is_written(name: str) -> None:
    after = library().with_program(f"{name}\n#100=20\nM99\n")
    assert (values(after), len(after)) == ((20, 3), 3)


def test_the_others_of_its_file_keep_their_lines() -> None:
    before, after = library(), library().with_program("O2\nG4 X1.\n#100=20\n\nM99\n")
    assert (after["O3"].file, after["O3"].line, after["O3"].text) == (
        (before["O3"].file, before["O3"].line, before["O3"].text)
    )
    assert [b.line for b in after["O3"].blocks] == [b.line for b in before["O3"].blocks]
    assert after["O2"].file == "<text>"


def test_a_file_of_one_program_is_left_out() -> None:
    after = library().with_program("O1\nM98 P3\nM30\n", name="new.nc")
    assert after.files == ("new.nc", "subs.nc")
    assert list(after) == ["O1", "O2", "O3"]
    assert after.main is not None
    assert (after.main.name, after.main.file) == ("O1", "new.nc")
    assert values(after) == (None, 3)


def test_a_program_that_is_not_there_is_added_after_the_others() -> None:
    before = cncsub.loads("O1\nM98 P2\nM30\n", control=CONTROL)
    assert before.run().alarm is not None
    after = before.with_program("O2\n#100=5\nM99\n")
    assert (list(after), after.files) == (["O1", "O2"], ("<text>", "<text>"))
    assert after.run().variables[100] == 5
    again = after.with_program("O2\n#100=6\nM99\n")
    assert (list(again), again.run().variables[100]) == (["O1", "O2"], 6)


def test_a_program_without_a_head_has_the_name_of_its_file() -> None:
    after = library().with_program("#100=20\nM99\n", name="O2.nc")
    assert values(after) == (20, 3)


def test_bytes_are_decoded_as_those_of_a_file() -> None:
    after = library().with_program("O2 (中文)\n#100=20\nM99\n".encode("gbk"))
    assert after["O2"].comment == "中文"


def test_the_new_program_counts_before_another_of_its_name() -> None:
    twice = cncsub.loads(
        {"a": "O1\nM98 P2\nM30\n", "b": "O2\n#100=1\nM99\n", "c": "O2\n#100=2\nM99\n"},
        control=CONTROL,
    )
    after = twice.with_program("O2\n#100=3\nM99\n")
    assert after.run().variables[100] == 3
    assert [program.file for program in after.duplicates] == ["c"]


def test_the_control_the_device_and_the_main_program_stay(tmp_path: Path) -> None:
    usb = tmp_path / "usb"
    usb.mkdir()
    (usb / "O50.nc").write_text("O50\n#101=50\nM99\n")
    for name, text in {"O1": "O1\nM98 P2\nM198 P50\nM30\n", "O2": "O2\nM99\n"}.items():
        (tmp_path / f"{name}.nc").write_text(text)
    control = cncsub.controls[CONTROL].replace(max_nesting=3)
    files = [tmp_path / "O1.nc", tmp_path / "O2.nc"]
    before = cncsub.load(*files, control=control, external=usb, prefer=files[1])
    after = before.with_program("O2\n#100=2\nM99\n")
    assert after.control == control
    assert after.main is not None
    assert after.main.name == "O1"
    assert values(after) == (2, 50)
    sent = pickle.loads(pickle.dumps(after))
    assert (list(sent), values(sent)) == (list(after), (2, 50))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", "begin it with O1000"),
        ("M30\n", "begin it with O1000"),
        ("O2\nM99\nO5\nM99\n", "this text has O2, O5"),
    ],
)
def test_a_text_that_is_not_one_program_is_a_value_error(text: str, told: str) -> None:
    with pytest.raises(ValueError, match=told):
        library().with_program(text)


def test_a_path_is_a_type_error() -> None:
    with pytest.raises(TypeError, match="a text or bytes"):
        library().with_program(Path("a.nc"))  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="name"):
        library().with_program("O2\n", name=5)  # type: ignore[arg-type]


def test_a_part_of_a_program_is_not_replaced_alone() -> None:
    text = "o<hole> sub\n#1=1\no<hole> endsub\no<hole> call\nm2\n"
    whole = cncsub.loads(text, control="linuxcnc", name="main.ngc")
    assert len(whole) >= 1
    with pytest.raises(ValueError, match="part of main"):
        whole.with_program("o<hole> sub\n#1=2\no<hole> endsub\n", name="hole.ngc")
    with pytest.raises(ValueError, match="give name="):
        whole.with_program("o<hole> sub\n#1=2\no<hole> endsub\n")
