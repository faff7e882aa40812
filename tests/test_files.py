"""Files and folders: which are read, which are never opened, and how bytes become text."""

from __future__ import annotations

import codecs
import errno
import os
import pickle
import signal
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import cncsub
from cncsub import _core, files
from cncsub.files import decode, name_order, read_paths
from cncsub.writing import replace_whole

CONTROL = "fanuc-0i-f"
PROGRAM = "N10 M30\n"


@pytest.fixture(autouse=True)
def no_hang() -> Iterator[None]:
    """A read that waits for a pipe or a device ends as a failure."""
    signal.alarm(30)
    yield
    signal.alarm(0)


def write(folder: Path, *names: str, text: str = PROGRAM) -> None:
    for name in names:
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


def found(folder: Path, **options: str | Path) -> list[str]:
    """Return the files of a folder as they are read, by their path inside it."""
    reading = read_paths([folder], **options)  # type: ignore[arg-type]
    return [Path(name).relative_to(folder).as_posix() for name in reading.names]


def reasons(folder: Path) -> dict[str, str]:
    skipped = read_paths([folder]).skipped
    return {Path(name).relative_to(folder).as_posix(): why for name, why in skipped}


# ---- order ----


def test_files_come_by_name_with_numbers_by_value_and_without_regard_to_case(
    tmp_path: Path,
) -> None:
    write(tmp_path, "o10.nc", "O9.NC", "b.nc", "A.nc", "O1.nc", "z/O0.nc")
    assert found(tmp_path) == ["A.nc", "b.nc", "O1.nc", "O9.NC", "o10.nc", "z/O0.nc"]


@given(st.lists(st.text(max_size=20)))
def test_any_names_have_an_order(names: list[str]) -> None:
    ordered = sorted(names, key=name_order)
    names.reverse()
    assert sorted(names, key=name_order) == ordered


def test_paths_keep_the_order_in_which_they_are_given(tmp_path: Path) -> None:
    write(tmp_path, "O1.nc", "O2.nc")
    library = cncsub.load(tmp_path / "O2.nc", tmp_path, control=CONTROL)
    assert list(library) == ["O2", "O1"]
    assert library.main is library["O2"]


def test_a_file_given_twice_is_read_once(tmp_path: Path) -> None:
    write(tmp_path, "O1.nc")
    library = cncsub.load(tmp_path / "O1.nc", tmp_path / ".." / tmp_path.name, control=CONTROL)
    assert len(library.files) == 1
    assert library.duplicates == ()


def test_names_that_differ_in_case_only_are_one_program_and_its_duplicate(tmp_path: Path) -> None:
    write(tmp_path, "part.nc", "PART.nc")
    library = cncsub.load(tmp_path, control="gsk-988ta")
    assert len(library) == 1
    assert [program.name for program in library.duplicates] == ["part"]


# ---- files that are left out ----


@pytest.mark.parametrize(
    ("name", "data"),
    [
        (".hidden.nc", b"N10 M30\n"),
        (".git/O1.nc", b"N10 M30\n"),
        ("notes.pdf", b"%PDF-1.7\n"),
        ("readme.md", b"# about\n"),
        ("photo.nc", b"\x89PNG\r\n\x1a\n"),
        ("job.cnc", b"PK\x03\x04zipped"),
        ("O5", b"\x01\x02\x03\x04\x05\x06" * 50),
    ],
)
def test_a_folder_leaves_out_what_is_no_program_and_says_so(
    tmp_path: Path, name: str, data: bytes
) -> None:
    write(tmp_path, "O1.nc")
    file = tmp_path / name
    file.parent.mkdir(exist_ok=True)
    file.write_bytes(data)
    library = cncsub.load(tmp_path, control=CONTROL)
    assert list(library) == ["O1"]
    assert len(library.skipped) == 1


def test_a_file_that_is_named_is_read_whatever_it_is_called(tmp_path: Path) -> None:
    write(tmp_path, "O1.md")
    assert list(cncsub.load(tmp_path / "O1.md", control=CONTROL)) == ["O1"]


def test_a_file_above_the_bound_is_left_out_of_a_folder_and_refused_by_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(tmp_path, "O1.nc")
    write(tmp_path, "O2.nc", text="N1 X1\n" * 20)
    monkeypatch.setattr(files, "LARGEST_FILE", 50)
    assert found(tmp_path) == ["O1.nc"]
    with pytest.raises(ValueError, match="larger than"):
        cncsub.load(tmp_path / "O2.nc", control=CONTROL)


def test_the_external_folder_is_no_part_of_the_memory_it_lies_in(tmp_path: Path) -> None:
    write(tmp_path, "O1.nc", "usb/O2.nc")
    library = cncsub.load(tmp_path, control=CONTROL, external=tmp_path / "usb")
    assert list(library) == ["O1"]
    assert list(library.external) == ["O2"]


def test_one_folder_may_be_memory_and_external_device(tmp_path: Path) -> None:
    write(tmp_path, "O1.nc")
    library = cncsub.load(tmp_path, control=CONTROL, external=tmp_path)
    assert list(library) == list(library.external) == ["O1"]


# ---- links, devices, pipes ----


def test_a_link_that_leaves_the_folder_is_not_followed(tmp_path: Path) -> None:
    write(tmp_path, "secret/O2.nc", "job/O1.nc")
    job = tmp_path / "job"
    (job / "O2.nc").symlink_to(tmp_path / "secret" / "O2.nc")
    (job / "O3.nc").symlink_to("../secret/O2.nc")
    (job / "sub").symlink_to(tmp_path / "secret")
    (job / "zero.nc").symlink_to("/dev/zero")
    assert found(job) == ["O1.nc"]
    assert set(reasons(job).values()) == {"a link to a place outside the folder"}
    assert set(reasons(job)) == {"O2.nc", "O3.nc", "sub", "zero.nc"}


def test_a_link_inside_the_folder_is_another_name_of_the_file(tmp_path: Path) -> None:
    write(tmp_path, "T1.nc")
    (tmp_path / "T2.nc").symlink_to("T1.nc")
    assert list(cncsub.load(tmp_path, control="gsk-988ta")) == ["T1", "T2"]


def test_links_in_a_circle_end(tmp_path: Path) -> None:
    write(tmp_path, "a/O1.nc")
    (tmp_path / "a" / "up").symlink_to(tmp_path)
    (tmp_path / "b").symlink_to("a")
    (tmp_path / "self.nc").symlink_to("self.nc")
    (tmp_path / "dead.nc").symlink_to("nowhere.nc")
    assert found(tmp_path) == ["a/O1.nc"]
    assert set(reasons(tmp_path)) == {"self.nc", "dead.nc"}


def test_a_folder_that_is_given_through_a_link_is_read(tmp_path: Path) -> None:
    write(tmp_path, "job/O1.nc")
    (tmp_path / "link").symlink_to("job")
    assert found(tmp_path / "link") == ["O1.nc"]


def test_a_folder_that_is_given_twice_is_read_once(tmp_path: Path) -> None:
    write(tmp_path, "job/O1.nc", "job/parts/O2.nc")
    job = tmp_path / "job"
    for paths in ((job, job), (job, job / "parts"), (job / "parts", job), (job, job / "O1.nc")):
        library = cncsub.load(*paths, control="fanuc-0i-f")
        assert sorted(Path(file).name for file in library.files) == ["O1.nc", "O2.nc"]


def test_pipes_sockets_and_devices_are_never_opened(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(tmp_path, "O1.nc")
    os.mkfifo(tmp_path / "O2.nc")
    monkeypatch.chdir(tmp_path)  # the path of a socket must be short
    with socket.socket(socket.AF_UNIX) as server:
        server.bind("O3.nc")
        assert found(tmp_path) == ["O1.nc"]
        assert set(reasons(tmp_path).values()) == {"not a regular file"}


@pytest.mark.parametrize("path", ["/dev/zero", "/dev/null", "pipe"])
def test_a_path_that_is_no_regular_file_is_refused(tmp_path: Path, path: str) -> None:
    if path == "pipe":
        os.mkfifo(tmp_path / "pipe")
    with pytest.raises(ValueError, match="not a regular file"):
        cncsub.load(tmp_path / path, control=CONTROL)


@pytest.mark.parametrize("name", ["../O2", "/etc/passwd", "../../O2.nc", "sub/../../O2.nc"])
def test_names_in_a_program_reach_nothing_outside_the_folders(tmp_path: Path, name: str) -> None:
    write(tmp_path, "O2.nc", "O2", "job/sub/O3.nc", "usb/O4.nc")
    calls = [f"M98 <{name}>", f"M198 <{name}>", f"M98 P[{name}]", f"M198 P[{name}]"]
    for call in calls:
        write(tmp_path, "job/O1.nc", text=f"N10 {call}\nN20 M30\n")
        for control in cncsub.controls:
            library = cncsub.load(tmp_path / "job", control=control, external=tmp_path / "usb")
            assert library.run("O1").calls.programs[:2] == [p.name for p in library.values()]
            assert len(library.run("O1", max_blocks=100).calls) == 0


# ---- files that are not there ----


def test_a_missing_file_is_told_with_the_names_that_are_near(tmp_path: Path) -> None:
    write(tmp_path, "O0010.nc", "part.nc")
    with pytest.raises(FileNotFoundError, match="O0010.nc") as raised:
        cncsub.load(tmp_path / "O0100.nc", control=CONTROL)
    assert raised.value.filename == str(tmp_path / "O0100.nc")


def test_a_missing_folder_is_told(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="no such file or folder"):
        cncsub.load(tmp_path / "jobs" / "O1.nc", control=CONTROL)


def test_a_missing_external_folder_is_told(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        cncsub.loads(PROGRAM, control=CONTROL, external=tmp_path / "usb")


def test_a_folder_without_programs_is_told_with_what_was_left_out(tmp_path: Path) -> None:
    (tmp_path / "a.zip").write_bytes(b"PK\x03\x04")
    with pytest.raises(ValueError, match="no program in the folder.*a.zip"):
        cncsub.load(tmp_path, control=CONTROL)


def test_a_text_in_place_of_a_path_is_told() -> None:
    with pytest.raises(ValueError, match="loads"):
        cncsub.load("O1\nM30\n", control=CONTROL)
    with pytest.raises(TypeError, match="path"):
        cncsub.load(b"O1", control=CONTROL)  # type: ignore[arg-type]


# ---- encodings ----


@pytest.mark.parametrize(
    ("text", "encoding"),
    [
        ("O1 (加工外圆)\nN10 M30\n", "gbk"),
        ("O1 (程序名称: 车螺纹 M30x2)\n", "gbk"),
        ("(粗车循环)\n<轴类零件>\n", "gb18030"),
        ("O1 (テスト プログラム)\n", "shift-jis"),
        ("O1 (外径荒加工の開始)\n", "shift-jis"),
        ("(ドリル加工 ねじ切り)\n", "cp932"),
        ("O1 (Länge 50, Größe Ø20)\n", "cp1252"),
        ("O1 (pièce à usiner, 45°)\n", "cp1252"),
        ("O1 (加工)\n", "utf-8"),
        ("O1 (加工)\n", "utf-8-sig"),
        ("O1 (加工)\n", "utf-16"),
        ("O1 (加工)\n", "utf-32"),
        ("O1 (plain)\n", "ascii"),
    ],
)
def test_an_encoding_is_found_out(text: str, encoding: str) -> None:
    assert decode(text.encode(encoding)) == text


def test_a_byte_order_mark_of_either_order_decides() -> None:
    text = "O1 (加工)\n"
    assert decode(codecs.BOM_UTF16_BE + text.encode("utf-16-be")) == text
    assert decode(codecs.BOM_UTF16_LE + text.encode("utf-16-le")) == text


def test_a_given_encoding_is_obeyed_and_what_does_not_fit_is_marked() -> None:
    assert decode("ñ".encode("latin-1"), "latin-1") == "ñ"
    assert decode(b"A\xff\xffB", "utf-8") == "A\ufffd\ufffdB"


def test_an_unknown_encoding_is_told() -> None:
    with pytest.raises(ValueError, match="unknown encoding 'klingon'"):
        cncsub.loads(b"O1", control=CONTROL, encoding="klingon")
    with pytest.raises(ValueError, match="unknown encoding 'hex'"):
        cncsub.loads(b"O1", control=CONTROL, encoding="hex")


def test_nul_leaders_and_trailers_of_a_tape_are_no_part_of_the_program(tmp_path: Path) -> None:
    (tmp_path / "O1.nc").write_bytes(b"\0" * 300 + b"%\nO1\nN10 M30\n%\n" + b"\0" * 300)
    run = cncsub.load(tmp_path, control=CONTROL).run()
    assert run.stop is cncsub.Stop.END
    assert run.steps.n.tolist() == [10]


def test_a_comment_keeps_its_letters_through_a_file(tmp_path: Path) -> None:
    (tmp_path / "O1.nc").write_bytes("O1 (精车外圆)\nN10 M30\n".encode("gbk"))
    assert cncsub.load(tmp_path, control=CONTROL)["O1"].comment == "精车外圆"


@given(st.binary(max_size=300))
def test_decoding_never_fails(data: bytes) -> None:
    assert isinstance(decode(data), str)


@given(st.binary(max_size=100), st.sampled_from(["gbk", "shift-jis", "utf-16", "cp1252", "utf-7"]))
def test_decoding_never_fails_with_an_encoding(data: bytes, encoding: str) -> None:
    assert isinstance(decode(data, encoding), str)


@given(st.text(alphabet=st.characters(codec="utf-8"), max_size=100))
def test_utf8_is_read_as_it_is(text: str) -> None:
    if not text.startswith("\ufeff"):
        assert decode(text.encode()) == text


def test_the_leader_of_a_tape_is_told_and_its_lines_are_counted() -> None:
    library = cncsub.loads(
        "PART 12\nX1..2\n%\nO1\nN10 M99 P5\n%\n", control="fanuc-0i-f", name="a.nc"
    )
    assert library.skipped == (("a.nc", "the text before its first %: 2 lines"),)
    assert (library.main.line if library.main else 0) == 4
    assert pickle.loads(pickle.dumps(library)).skipped == library.skipped
    plain = cncsub.loads("N10 M98 P2\nM30\nO2\nM99\n", control="fanuc-0i-f")
    assert plain.skipped == ()


# ---- read by the engine ----


def is_utf8(data: bytes) -> bool:
    try:
        return not data.startswith(codecs.BOM_UTF8) and data.decode("utf-8") is not None
    except UnicodeDecodeError:
        return False


EDGES = [
    *(b"\xc1\xbf", b"\xc2\x80", b"\xdf\xbf", b"\xe0\x9f\xbf", b"\xe0\xa0\x80", b"\xed\x9f\xbf"),
    *(
        b"\xed\xa0\x80",
        b"\xee\x80\x80",
        b"\xf0\x8f\xbf\xbf",
        b"\xf0\x90\x80\x80",
        b"\xf4\x8f\xbf\xbf",
    ),
    *(
        b"\xf4\x90\x80\x80",
        b"\xf5\x80\x80\x80",
        b"\xe4\xb8",
        b"\x80",
        b"N1\xff",
        b"",
        codecs.BOM_UTF8,
    ),
    b"(" + "é".encode() * 70_000 + b")",
    b"x" * 65_535 + "中".encode(),
    b"x" * 65_535 + "中".encode()[:2],
    b"x" * (1 << 20) + b"\xe9",
]


@pytest.mark.parametrize("data", EDGES, ids=range(len(EDGES)))
def test_the_engine_takes_for_utf8_what_python_takes_for_it(tmp_path: Path, data: bytes) -> None:
    file = tmp_path / "O1.nc"
    file.write_bytes(data)
    text = _core.read_file(str(file), 1 << 30)
    assert isinstance(text, _core.Text)
    assert text.part(0, 1 << 30) == data
    assert text.utf8 == is_utf8(data)


@pytest.mark.parametrize("mark", ["", "é", "中", "\udce9"])
def test_a_large_file_is_put_together_of_pieces(tmp_path: Path, mark: str) -> None:
    """Several threads read the file, and a character may lie in two of their pieces."""
    count, length = 20 << 18, 1 << 18
    data = bytearray(b"".join(b"N%d\n" % n for n in range(count // 8)).ljust(count, b"X"))
    for at in range(length - 1, count, length):
        character = mark.encode(errors="surrogateescape")
        data[at : at + len(character)] = character
    file = tmp_path / "O1.nc"
    for size in (len(data), count - 1, 19 * length, 19 * length + 1, 19 * length - 1):
        file.write_bytes(data[:size])
        text = _core.read_file(str(file), 1 << 30)
        assert isinstance(text, _core.Text)
        assert text.part(0, 1 << 30) == data[:size]
        assert text.utf8 == is_utf8(bytes(data[:size]))


@pytest.mark.skipif(not Path("/proc/version").exists(), reason="a file that tells no size")
def test_a_file_that_is_longer_than_the_system_says_is_read_to_its_end() -> None:
    for name in ("/proc/version", "/proc/kallsyms"):
        text = _core.read_file(name, 1 << 30)
        assert isinstance(text, _core.Text)
        assert text.part(0, 1 << 30) == Path(name).read_bytes()


@given(st.lists(st.binary(max_size=40) | st.text(max_size=20).map(str.encode), max_size=5))
def test_utf8_is_told_of_any_bytes(
    tmp_path_factory: pytest.TempPathFactory, d: list[bytes]
) -> None:
    folder = tmp_path_factory.getbasetemp()
    names = [str(folder / f"utf8-{place}.nc") for place in range(len(d))]
    for name, data in zip(names, d, strict=True):
        Path(name).write_bytes(data)
    texts = [_core.read_file(name, 1 << 30) for name in names]
    assert [isinstance(t, _core.Text) and t.utf8 for t in texts] == [is_utf8(data) for data in d]


def test_many_files_of_any_encoding_come_in_order_each_with_its_own_text(tmp_path: Path) -> None:
    encodings = ("ascii", "utf-8", "gb18030", "utf-8-sig", "utf-16")
    comments = ("PART", "铣削零件", "铣削零件", "铣削零件", "铣削零件")
    for n in range(1, 501):
        text = f"O{n} ({comments[n % 5]})\nN{n} M30\n"
        (tmp_path / f"O{n}.nc").write_bytes(text.encode(encodings[n % 5]))
    (tmp_path / "O250.bin").write_bytes(b"\1\2\3\4" * 99)
    library = cncsub.load(tmp_path, control=CONTROL)
    assert list(library) == [f"O{n}" for n in range(1, 501)]
    assert [p.comment for p in library.values()] == [comments[n % 5] for n in range(1, 501)]
    assert library.skipped == ((str(tmp_path / "O250.bin"), "not a text"),)


# Names that most folders allow: the file system may fold case, so names differ in more than case.
FILE_NAMES = st.text(st.sampled_from("aBz019._- %é零"), min_size=1, max_size=12).filter(
    lambda name: name.strip(". ") == name
)


@given(st.lists(FILE_NAMES, max_size=12, unique_by=str.casefold))
def test_the_engine_lists_files_in_the_order_of_their_names(
    tmp_path_factory: pytest.TempPathFactory, names: list[str]
) -> None:
    folder = tmp_path_factory.mktemp("names")
    for name in names:
        (folder / name).write_text("M30\n")
    listing = _core.names_in(str(folder), [".z"])
    assert not isinstance(listing, int)
    files, folders, others, ordered = listing
    assert folders == []
    assert sorted([*files, *others]) == sorted(names)
    assert all(not name.isascii() or name.endswith((".z", ".Z")) for name in others)
    assert ordered == all(map(str.isascii, names))
    if ordered:
        assert files == sorted(files, key=name_order)
    expected = sorted(names, key=name_order)
    if expected:
        read = read_paths([folder]).names
        assert read == [str(folder / name) for name in expected]


def test_a_named_file_of_a_folder_is_read_once_with_it(tmp_path: Path) -> None:
    for number in (1, 2, 3):
        (tmp_path / f"O{number}.nc").write_text(f"O{number}\nM30\n")
    link = tmp_path / "O4.nc"
    link.symlink_to(tmp_path / "O3.nc")
    names = [str(tmp_path / f"O{number}.nc") for number in (2, 1, 3, 4)]
    assert read_paths([names[0], tmp_path, names[3]]).names == names


def test_what_the_system_refuses_is_told_in_its_words(tmp_path: Path) -> None:
    missing = str(tmp_path / "O1.nc")
    assert _core.read_file(missing, 99) == errno.ENOENT
    assert _core.read_file("/dev/null", 99) == "not a regular file"
    found = _core.read_found("/", ["missing", "dev/null"], 99, as_utf8=True)
    assert found == [(0, errno.ENOENT), (1, "not a regular file")]
    assert _core.names_in(missing, ()) == errno.ENOENT
    with pytest.raises(OSError, match="Input/output error"):
        cncsub.load("/proc/self/mem", control=CONTROL)


def test_what_is_no_regular_file_is_written_to_and_stays_what_it_is(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    try:
        replace_whole(pipe, b"O1\nM30\n")
        assert os.read(reader, 100) == b"O1\nM30\n"
    finally:
        os.close(reader)
    assert pipe.is_fifo()
