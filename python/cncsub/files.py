"""Program files and folders, read safely and decoded.

A folder is the memory of a control: every program file in it and in the folders below it, each
folder once. Files come in the order of their names, without regard to case and with numbers by
their value (`O2.nc` before `O10.nc`), the files of a folder before those of the folders in it.

`Reading.skipped` lists what is left out of a folder: hidden files and folders, files that are
plainly no programs (by their ending or their first bytes), files above `LARGEST_FILE`, links that
lead out of the folder, and everything that is no regular file, such as a device or a pipe. None of
these is opened. A file that is named itself is always read, unless it is no regular file or too
large, which raises `ValueError`.
"""

from __future__ import annotations

import codecs
import errno
import os
import re
import stat
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from cncsub import _core, system
from cncsub._core import Text, Texts

StrPath = str | os.PathLike[str]
Data = bytes | bytearray
Piece = str | Data | Text  # a piece of a text, for the engine
CoreFile = tuple[str, str, Sequence[Piece], bool] | tuple[Texts, bool]

LARGEST_FILE = 1 << 30  # bytes
_PIECE = 1 << 22  # bytes that are read, decoded or copied in one go

# Endings of files that people keep beside their programs; the engine knows their first bytes.
_OTHER_ENDINGS = frozenset(
    """
    .7z .bak .bmp .bz2 .c .cfg .cpp .css .csv .db .doc .docx .dll .dwg .dxf .exe .gif .gz .h .htm
    .html .ico .iges .igs .ini .ipynb .jpeg .jpg .js .json .log .md .mp4 .odt .parquet .pdf .png
    .ppt .pptx .py .pyc .rar .rst .rtf .sh .so .sqlite .stl .step .stp .svg .tar .tgz .tif .tiff
    .toml .webp .xls .xlsx .xml .xz .yaml .yml .zip
    """.split()  # noqa: SIM905
)
_NUMBERS = re.compile(r"([0-9]+)")
TEXT = "<text>"  # the name of a text that was read from no file
_CONTROLS = re.compile(r"[\x00-\x1f\x7f-\x9f]")

_BOMS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF32_LE, "utf-32"),
    (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)


class TextFile(NamedTuple):
    """A file as text: the name to show, the name of a program in it that has none of its own, and
    the text, in pieces.
    """

    name: str
    stem: str
    pieces: Sequence[Piece]


@dataclass(slots=True)
class Reading:
    """The files of some paths, and what was left out of their folders: path and reason."""

    files: list[TextFile | Texts] = field(default_factory=list)
    skipped: list[tuple[str, str]] = field(default_factory=list)
    # Folders already seen, by their real path, and names of files already seen in each.
    folders: set[str] = field(default_factory=set)
    known: dict[str, set[str]] = field(default_factory=dict)
    left_out: set[str] = field(default_factory=set)  # folders that are not to be read

    @property
    def names(self) -> list[str]:
        """The names of the files as shown."""
        names: list[str] = []
        for part in self.files:
            names += part.names if isinstance(part, Texts) else [part.name]
        return names

    def rows(self, external: bool) -> list[CoreFile]:
        """Return the files of the memory, or of the external device, for the engine, which takes
        them over.
        """
        return [
            (part, external)
            if isinstance(part, Texts)
            else (part.name, part.stem, part.pieces, external)
            for part in self.files
        ]


def read_paths(
    paths: Sequence[StrPath],
    *,
    siblings: Sequence[StrPath] = (),
    encoding: str | None = None,
    without: StrPath | None = None,
) -> Reading:
    """Read files and folders in the given order, each file once; `without` is a folder to leave
    out. `siblings`: files that nobody named, which are read after the paths as files of a folder
    are.

    Raises `FileNotFoundError` for a missing path, suggesting similar names, and `ValueError` for a
    path that is neither a file nor a folder, for a folder without programs and for an unknown
    encoding.
    """
    check_encoding(encoding)
    reading = Reading()
    for path in map(_checked_path, paths):
        # A folder that is given both ways is read both ways.
        if without is not None and _real(path) != _real(without):
            reading.folders.add(_real(without))
            reading.left_out.add(_real(without))
        _read_path(path, encoding, reading)
    for path in map(Path, siblings):
        folder = os.path.realpath(path.parent)
        fault = refused_entry(path, Path(folder))
        if fault is None:
            read_found_files(str(path.parent / "_")[:-1], [path.name], folder, encoding, reading)
        else:
            reading.skipped.append((str(path), fault))
    return reading


def _real(path: StrPath) -> str:
    """Return where a path leads; the path itself where it leads nowhere, as links in a
    circle do.
    """
    path = os.fspath(path)
    return os.path.realpath(path) if os.path.exists(path) else os.path.abspath(path)  # noqa: PTH100, PTH110


def _checked_path(path: StrPath) -> Path:
    if not isinstance(path, str | os.PathLike):
        raise TypeError(
            f"a path must be a text or a pathlib.Path, not {type(path).__name__};"
            " loads() takes the text of a program"
        )
    name = os.fspath(path)
    if not name:
        raise FileNotFoundError(errno.ENOENT, "an empty path", name)
    if "\0" in name or "\n" in name:
        raise ValueError("this is not a path; cncsub.loads() takes the text of a program")
    return Path(name)


def _read_path(path: Path, encoding: str | None, reading: Reading) -> None:
    try:
        mode = path.stat().st_mode
    except OSError as error:
        raise _cannot_find(path, error) from None
    if not stat.S_ISDIR(mode):
        _read_named_file(path, encoding, reading)
        return
    real = _real(path)
    if real in reading.folders and real not in reading.left_out:
        return  # it was read before: it is given twice, or is inside a folder that was given
    if not _read_folder(path, encoding, reading):
        reasons = "; ".join(f"{name}: {why}" for name, why in reading.skipped[:3])
        raise ValueError(
            f"there is no program in the folder {path}" + (f" ({reasons})" if reasons else "")
        )


def _cannot_find(path: Path, error: OSError) -> OSError:
    if error.errno not in (errno.ENOENT, errno.ENOTDIR, errno.ELOOP, errno.ENAMETOOLONG):
        return error
    near = _near_files(path)
    cure = f"; did you mean {', '.join(near)}?" if near else ""
    what = (
        "a broken link"
        if error.errno == errno.ELOOP or path.is_symlink()
        else "no such file or folder"
    )
    return FileNotFoundError(errno.ENOENT, f"{what}{cure}", str(path))


def _near_files(path: Path) -> list[str]:
    import difflib

    try:
        names = [entry.name for entry in os.scandir(path.parent)][:10_000]
    except OSError:
        return []
    folded = {name.casefold(): name for name in names}
    near = difflib.get_close_matches(path.name.casefold(), folded, n=4, cutoff=0.6)
    # A link that leads nowhere lies in the folder too.
    return [str(path.parent / folded[name]) for name in near if folded[name] != path.name][:3]


def _read_named_file(path: Path, encoding: str | None, reading: Reading) -> None:
    if not first_time(os.path.realpath(path.parent), path.name, reading):
        return
    text = _core.read_file(str(path), LARGEST_FILE)
    if not isinstance(text, Text):
        raise ValueError(f"{path} cannot be read as a program: {_why_not(path, text)}")
    reading.files.append(_text_file(str(path), path.stem, text, encoding))


def _text_file(path: str, stem: str, text: Text, encoding: str | None) -> TextFile:
    pieces: Sequence[Piece]
    if encoding is None and text.utf8:
        pieces = [text]
    else:
        pieces = decoded(_bytes_of(text), encoding)
    # A name that is no text, as Linux allows, is shown with question marks.
    return TextFile(clean(path), clean(stem), pieces)


# Faults of this process and not of a file: no file may be left out because of them.
_OF_PROCESS = (errno.EMFILE, errno.ENFILE, errno.ENOMEM)


def _why_not(path: StrPath, fault: int | str) -> str:
    if not isinstance(fault, int):
        return fault
    if fault in _OF_PROCESS:
        raise OSError(fault, os.strerror(fault), os.fspath(path))
    return os.strerror(fault)


def first_time(folder: str, name: str, reading: Reading) -> bool:
    """Return whether this name of a file is met for the first time. A link to a file is another
    name.
    """
    names = reading.known.setdefault(folder, set())
    [same] = system.same_names([name])
    new = same not in names
    names.add(same)
    return new


def _new_names(folder: str, names: list[str], reading: Reading) -> list[str]:
    """Return the names that are met for the first time."""
    known = reading.known.setdefault(folder, set())
    same = system.same_names(names)
    new = [name for name, as_one in zip(names, same) if as_one not in known] if known else names
    known.update(same)
    return new


def _read_folder(top: Path, encoding: str | None, reading: Reading) -> int:
    """Read a folder and those below it, however deep; return how many programs were found."""
    return sum(
        read_found_files(before, files, real, encoding, reading)
        for before, files, real in walk(top, reading)
    )


def walk(top: Path, reading: Reading) -> Iterator[tuple[str, list[str], str]]:
    """Yield each folder from `top` down that was not met before: what stands before the names of
    its files, the names, its real path. Opens no file; entries that are left alone go to
    `reading.skipped`.
    """
    root = os.path.realpath(top)
    waiting = [(top, root)]
    while waiting:
        folder, real = waiting.pop()
        if real in reading.folders:
            continue
        reading.folders.add(real)
        listing = _core.names_in(str(folder), _OTHER_ENDINGS)
        if isinstance(listing, int):
            reading.skipped.append((str(folder), _why_not(folder, listing)))
            listing = [], [], [], True
        files, folders = _sorted_out(folder, listing, root, reading)
        yield str(folder / "_")[:-1], files, real
        waiting += [
            (
                folder / name,
                os.path.realpath(folder / name) if link else f"{real}{os.sep}{name}",
            )
            for name, link in reversed(folders)
        ]


def _sorted_out(
    folder: Path,
    listing: tuple[list[str], list[str], list[str], bool],
    root: str,
    reading: Reading,
) -> tuple[list[str], list[tuple[str, bool]]]:
    """Return the files of a folder, and the folders in it with whether they are links."""
    files, plain, others, ordered = listing
    folders = [(name, False) for name in plain]
    if not system.may_be_entered(folder):
        # Not even the kind of an entry can be asked for here.
        others, files, folders, ordered = [*files, *plain, *others], [], [], False
    if not ordered:
        others.sort(key=name_order)
    for name in others:
        path = folder / name
        fault = refused_entry(path, Path(root))
        if fault is not None:
            reading.skipped.append((str(path), fault))
            continue
        ordered = False
        if path.is_dir():
            folders.append((name, system.leads_elsewhere(path)))
        else:
            files.append(name)
    if not ordered:
        files.sort(key=name_order)
        folders.sort(key=lambda found: name_order(found[0]))
    return files, folders


def name_order(name: str) -> tuple[list[Any], str]:
    """Return the sort key of a file's name: without regard to case, numbers by their value."""
    # Texts and numbers alternate, so that only like is compared with like.
    parts: list[Any] = _NUMBERS.split(name.casefold())
    for i in range(1, len(parts), 2):
        digits = parts[i].lstrip("0")
        parts[i] = len(digits), digits
    return parts, name


def refused_entry(path: Path, root: Path) -> str | None:
    """Return why an entry of a folder is left alone, or `None`. Nothing is read that lies outside
    `root`, the folder that was given. Opens nothing.
    """
    if system.is_hidden(path):
        return "hidden"
    if _CONTROLS.search(path.name):
        return "a name with control characters"
    try:
        mode = path.stat().st_mode
        # The folder is below the root, and so is every entry that is no link.
        if system.leads_elsewhere(path) and not Path(
            os.path.realpath(path, strict=True)
        ).is_relative_to(root):
            return "a link to a place outside the folder"
    except OSError:
        return "a broken link" if os.path.islink(path) else "cannot be opened"  # noqa: PTH114
    if not stat.S_ISDIR(mode) and not stat.S_ISREG(mode):
        return "not a regular file"
    if stat.S_ISREG(mode) and path.suffix.lower() in _OTHER_ENDINGS:
        return f"{path.suffix} files are not programs"
    return None


def read_found_files(
    before: str, names: list[str], folder: str, encoding: str | None, reading: Reading
) -> int:
    """Read these files of a folder and return how many of them are programs; a file that was read
    before is not read again. `before`: what stands before their names; `folder`: its real path.
    """
    new = _new_names(folder, names, reading)
    found = len(names) - len(new)
    for part in _core.read_found(before, new, LARGEST_FILE, as_utf8=encoding is None):
        if isinstance(part, Texts):
            reading.files.append(part)
            found += len(part)
            continue
        place, text = part
        path = before + new[place]
        if isinstance(text, Text):
            reading.files.append(_text_file(path, _stem(new[place]), text, encoding))
            found += 1
        else:
            reading.skipped.append((path, _why_not(path, text)))
    return found


def _stem(name: str) -> str:
    """Return the name without its ending; a dot at its end begins none."""
    dot = name.rfind(".")
    return name[:dot] if 0 < dot < len(name) - 1 else name


def _bytes_of(text: Text) -> bytearray:
    data = bytearray()
    for at in range(0, len(text), _PIECE):
        data += text.part(at, _PIECE)
    return data


# ---- bytes to text ----

# Python counts these among its encodings, but no file is written in them, and they fail on some
# bytes whatever error handling is asked for.
_NO_FILES = ("idna", "punycode", "undefined", "unicode-escape", "raw-unicode-escape")


def check_encoding(encoding: str | None) -> None:
    """Raise `ValueError` for an encoding that Python does not know, or that no file uses."""
    if encoding is None:
        return
    if not isinstance(encoding, str):
        raise TypeError(f"encoding must be a name such as 'gbk', not {type(encoding).__name__}")
    try:
        known = codecs.lookup(encoding)
    except (LookupError, ValueError):
        known = None
    text = known is not None and getattr(known, "_is_text_encoding", True)
    if known is None or not text or known.name in _NO_FILES:
        raise ValueError(
            f"unknown encoding {encoding!r};"
            " common ones are utf-8, gbk, shift-jis, cp1252 and latin-1"
        )


def decode(data: Data, encoding: str | None = None) -> str:
    """Return the text of a program file; never fails. See `decoded`."""
    return "".join(p if isinstance(p, str) else p.decode("ascii") for p in decoded(data, encoding))


def decoded(data: Data, encoding: str | None = None) -> list[str | Data]:
    """Return the text of a program file in pieces, so that Ctrl-C can come between them; never
    fails. A piece is a text, or ASCII bytes.

    A byte-order mark decides first, then `encoding`, then UTF-8 where the bytes are UTF-8, and else
    the most plausible of GB18030 (with GBK), Shift-JIS and Windows-1252. What no encoding explains
    is read as Latin-1; with an `encoding` that does not fit, the bytes it does not know become
    U+FFFD. NULs stay.
    """
    for bom, name in _BOMS:
        if data.startswith(bom):
            return _decoded_as(name, data, "replace")
    if encoding is not None:
        return _decoded_as(encoding, data, "replace")
    if data.isascii():
        return [data]  # as it is: the engine takes UTF-8
    try:
        return _decoded_as("utf-8", data)
    except UnicodeDecodeError:
        return _decoded_as(_legacy_encoding(data), data)


def _decoded_as(encoding: str, data: Data, errors: str = "strict") -> list[str | Data]:
    if len(data) <= _PIECE:
        return [clean(data.decode(encoding, errors))]
    decoder = codecs.getincrementaldecoder(encoding)(errors)
    starts = range(0, len(data), _PIECE)
    pieces = [decoder.decode(data[at : at + _PIECE], at == starts[-1]) for at in starts]
    return [clean(piece) for piece in pieces]


def text_pieces(text: object, encoding: str | None = None) -> list[str | Data]:
    """Return the text of a program in pieces: a text, or bytes that are decoded as those of a file.

    Raises `TypeError` for anything else.
    """
    if isinstance(text, bytes | bytearray | memoryview):
        return decoded(bytes(text), encoding)
    if isinstance(text, str):
        return cut(text.removeprefix("\ufeff"))  # a byte order mark that somebody has decoded
    raise TypeError(f"the text of a program must be a text or bytes, not {type(text).__name__}")


def shown_and_stem(name: object) -> tuple[str, str]:
    """Return what a text is called in messages, and the stem that names a program without a name of
    its own. `name`: that of its file, `None` where it is of none.
    """
    if name is None:
        return TEXT, ""
    if not isinstance(name, str):
        raise TypeError(f"name must be a file name, not {type(name).__name__}")
    stem = os.path.splitext(os.path.basename(name))[0]  # noqa: PTH119, PTH122
    return clean(name), clean(stem)


def cut(text: str) -> list[str | Data]:
    """Return the text in pieces, without lone surrogates."""
    return [clean(text[at : at + _PIECE]) for at in range(0, len(text), _PIECE)]


def clean(text: str) -> str:
    """Return the text without lone surrogates, which are no characters; NULs stay."""
    return text if text.isascii() else text.encode("utf-8", "replace").decode("utf-8")


def one_line(text: str) -> str:
    """Return the text as one line of a program: what ends a line is a blank."""
    return re.sub(r"[\r\n\0]", " ", clean(text))


def _legacy_encoding(data: Data) -> str:
    best, best_score = "latin-1", 0.0
    for encoding, score in (("gb18030", _gbk), ("cp932", _shift_jis), ("cp1252", _western)):
        try:
            _decoded_as(encoding, data)
        except UnicodeDecodeError:
            continue
        found = _plausibility(data, score)
        if found > best_score:
            best, best_score = encoding, found
    return best


_MOST_UNITS = 4000
_PAIRS = re.compile(rb"[\x81-\xfe][\x30-\xff]|[\x80-\xff]", re.DOTALL)


def _plausibility(data: Data, score: object) -> float:
    """Return the mean score of the bytes beyond ASCII, -1 to 1."""
    assert callable(score)
    total, count = 0.0, 0
    for value, weight in score(data):
        total += value * weight
        count += weight
        if count > _MOST_UNITS:
            break
    return total / count if count else 0.0


# The characters that Chinese comments in NC programs are made of.
_COMMON_CHINESE = frozenset(
    "的一是在不了有和人这中大为上个我以要他时来用们生到作地于出就分对成会可主发年动同工也能下过子说产种面而方后多定行学法所"
    "民得经十三之进着等部度家电力里如水化高自二理起小物现实加量都两体制机当使点从业本去把性好应开它合还因由其些然前外天政四"
    "日那社义事平形相全表间样与关各重新线内数正心反你明看原又么利比或但质气第向道命此变条只没结解问意建月公无系军很情者最立"
    "代想已通并提直题程展五果料象员革位入常文总次品式活设及管特件长求老头基资边流路级少图山统接知较将组见计别手角期根论运"
    "车床铣刀具轴转速螺纹孔钻槽圆弧循环零件坯毛粗精切削削径给冷却液停止夹松紧卡盘尾座顶尖深补偿半编号调用宏变赋值循序"
    "返回结束开始左右端倒锥球内外镗攻丝铰换安全退进快移测量对准检查注释名称说备用程序子主宽厚度距离模板型腔轮廓试测"
)


def _gbk(data: Data) -> Iterator[tuple[float, int]]:
    for match in _PAIRS.finditer(data):
        unit = match.group()
        if len(unit) == 1:
            yield -1.0, 1
        elif unit[1] < 0xA1:
            yield -0.5, 2  # only in the extension of GB2312
        elif 0xB0 <= unit[0] <= 0xD7:
            yield (1.0 if unit.decode("gb18030", "replace") in _COMMON_CHINESE else 0.5), 2
        elif unit[0] <= 0xA3:
            yield 0.6, 2  # punctuation, full-width letters
        else:
            yield (0.1 if 0xD8 <= unit[0] <= 0xF7 else -0.5), 2


_SHIFT_JIS = re.compile(rb"[\x81-\x9f\xe0-\xfc][\x40-\xfc]|[\x80-\xff]", re.DOTALL)


def _shift_jis(data: Data) -> Iterator[tuple[float, int]]:
    for match in _SHIFT_JIS.finditer(data):
        unit = match.group()
        if len(unit) == 1:
            yield 0.4, 1  # half-width katakana
        elif unit[0] in (0x82, 0x83):
            yield 1.0, 2  # kana, full-width letters
        elif unit[0] == 0x81:
            yield 0.6, 2  # punctuation
        else:
            yield (0.7 if 0x88 <= unit[0] <= 0x97 else -0.2), 2


_RUNS = re.compile(rb"[\x80-\xff]+")


def _western(data: Data) -> Iterator[tuple[float, int]]:
    """Yield scores for Western text. Letters with accents stand alone between plain letters; signs
    such as the degree stand after figures.
    """
    for match in _RUNS.finditer(data):
        run = match.group()
        letters = all(byte >= 0xC0 for byte in run)
        if len(run) == 1:
            yield (
                (0.9 if letters or run in b"\x80\xa7\xb0\xb1\xb2\xb3\xb5\xb7\xba\xd7\xf8" else 0.3),
                1,
            )
        else:
            yield (0.3 if letters and len(run) == 2 else -0.8), len(run)
