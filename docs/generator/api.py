"""The Python interface: from the docstrings of the package, and from the stubs of the engine."""

from __future__ import annotations

import ast
import inspect
from pathlib import Path

import cncsub
from cncsub import _core
from cncsub.run_options import stated
from cncsub.tables.columns import all_facts
from generator.markdown import code, fenced, table, words

# Every public name of the package, by the page it stands on.
PAGES: dict[str, tuple[str, str, list[str]]] = {
    "programs": (
        "Programs",
        "Reading programs, and what is in them.",
        ["load", "loads", "Library", "Program", "Block", "Token", "Word", "Note", "read_variables"],
    ),
    "references": (
        "References",
        "What programs refer to, found without running.",
        ["CallGraph", "Edge", "CallTo", "JumpTo", "VariableUse", "Computed", "Flow", "FlowEdge"],
    ),
    "runs": (
        "Runs",
        "What a run did; one step at a time; in parts.",
        [
            "Run",
            "RunOptions",
            "Stop",
            "AlarmError",
            "Machine",
            "Breakpoint",
            "Stream",
            "Part",
            "Endless",
            "Why",
            "LoopBlock",
            "Listed",
            "report",
        ],
    ),
    "tables": (
        "Tables",
        "Steps, calls, moves and changes of variables, as columns and as rows.",
        [
            "tables.Steps",
            "tables.Calls",
            "tables.Moves",
            "tables.Watch",
            "tables.Conditions",
            "tables.Codes",
            "Step",
            "Call",
            "Move",
            "Change",
            "Compared",
            "SentCode",
            "Polyline",
            "Dropped",
            "MissedSkip",
            "tables.columns.ColumnFacts",
        ],
    ),
    "controls": (
        "Controls and alarms",
        "The controls with their facts, causes and sources; alarms as values.",
        [
            "control",
            "controls",
            "aliases",
            "causes",
            "sources",
            "Alias",
            "Cause",
            "Source",
            "Control",
            "Alarm",
            "Frame",
        ],
    ),
    "setup": (
        "Setup and inputs",
        "What was set at the machine, and what answers while a program runs.",
        ["Setup", "Inputs", "Workpiece", "Plane", "Box", "Cylinder", "Sphere"],
    ),
    "checking": (
        "Checking",
        "What is wrong, found without running.",
        ["CheckRule", "Finding", "Edit"],
    ),
    "comparing": (
        "Flattening, starting again, comparing, translating",
        "One program without calls, the rest of a run, two controls, two versions.",
        [
            "flatten",
            "Flat",
            "FlattenError",
            "Origin",
            "Resume",
            "RestartState",
            "ResumeError",
            "compare",
            "Comparison",
            "Difference",
            "BlockChange",
            "translate",
            "Translation",
            "TranslateError",
        ],
    ),
    "editing": (
        "Editing",
        "Other numbers, names and layout, proved by a run.",
        [
            "editing.renumber",
            "editing.rename",
            "editing.format",
            "editing.mentions",
            "editing.mention_at",
            "editing.Edits",
            "editing.EditError",
            "editing.Mention",
            "editing.proof.Proof",
        ],
    ),
    "gate": (
        "Gate",
        "Whether the output of a post processor may go to the machine.",
        [
            "archive.gate.gate",
            "archive.gate.read_allow_list",
            "archive.gate.Gate",
            "archive.gate.GatedFile",
            "archive.gating.Allowed",
        ],
    ),
    "archives": ("Archives", "Every program of some folders.", ["run_many", "check_many"]),
    "testing": (
        "Testing",
        "Cases, and what pytest gets from cncsub.",
        [
            "testing.case",
            "testing.check_case",
            "testing.load_table",
            "cncsub_pytest.Cnc",
            "testing.strategies.arguments",
            "testing.strategies.call_words",
            "coverage.Coverage",
            "coverage.collecting",
        ],
    ),
}
# Classes that are made by calling them; the others come from a run, a library, a check.
_CALLED = ("Setup", "Inputs", "Workpiece", "Plane", "Box", "Cylinder", "Sphere")
_ENGINE = ("Control", "Alarm", "Frame")
_WITH = {"Control": ("Rule", "Parameter", "AlarmEntry", "VariableOption")}  # what it hands out


def names() -> list[str]:
    return ["reference/api/index.md", *(f"reference/api/{page}.md" for page in PAGES)]


def pages() -> dict[str, str]:
    told = {f"reference/api/{page}.md": _page(*PAGES[page]) for page in PAGES}
    return {"reference/api/index.md": _index(), **told}


def documented() -> set[str]:
    """The public names that stand on a page."""
    return {name for _, _, names in PAGES.values() for name in names if "." not in name}


def _index() -> str:
    text = (
        "# Python\n\n`import cncsub` needs NumPy alone. What needs pandas, pyarrow, plotly or the"
        " command's packages (`cncsub[cli]`) imports them when it is used, and says so if they"
        " are missing.\n"
        "These pages have all that [is public](../../public.md).\n\n"
    )
    rows = (
        [f"[{title}]({page}.md)", words(about), ", ".join(code(name) for name in names)]
        for page, (title, about, names) in PAGES.items()
    )
    return text + table(("page", "about", "names"), rows)


def _page(title: str, about: str, listed: list[str]) -> str:
    text = f"# {title}\n\n{about}\n\n"
    for name in listed:
        if name == "RunOptions":
            text += _options()
        elif name in _ENGINE:
            for each in (name, *_WITH.get(name, ())):
                text += _of_the_engine(each)
        else:
            called = "    options:\n      merge_init_into_class: true\n" if name in _CALLED else ""
            text += f"::: {_home(name)}\n{called}\n{_columns(name)}"
    return text


_ROWS = {"Watch": "changes", "Conditions": "comparisons"}  # what a table calls its rows


def _columns(name: str) -> str:
    """The columns of a table, with their units."""
    room, _, own = name.partition(".")
    if room != "tables" or "." in own:
        return ""
    facts = all_facts(_ROWS.get(own, own.lower()))
    rows = ([code(column), words(of.unit), words(of.meaning)] for column, of in facts.items())
    return table(("column", "unit", "what it holds"), rows) + "\n"


def _options() -> str:
    """The options of a run, as they are stated."""
    about, _, example = inspect.cleandoc(cncsub.RunOptions.__doc__ or "").partition(">>> ")
    types = inspect.signature(cncsub.Library.run).parameters
    rows = (
        [
            code(name),
            code(str(types[name].annotation)),
            code(repr(option.default)),
            words(option.meaning),
        ]
        for name, option in stated().items()
    )
    head = f"## RunOptions {{ #RunOptions }}\n\n{about.strip()}\n\n"
    listed = table(("option", "type", "without it", "what it is"), rows)
    return f"{head}{fenced('python', '>>> ' + example)}\n{listed}\n"


def _home(name: str) -> str:
    """Where a name is defined, for whoever reads the sources without running them."""
    if "." in name:
        module, _, own = name.rpartition(".")
        home = module if module.startswith("cncsub") else f"cncsub.{module}"
        value = getattr(__import__(home, fromlist=[own]), own)
    else:
        own, value = name, getattr(cncsub, name)
    module = (
        getattr(value, "__module__", None) if inspect.isclass(value) or callable(value) else None
    )
    return f"{module or 'cncsub.controls'}.{own}"


# ---- what the engine makes: its stubs, and the words of `help()` ----


def _of_the_engine(name: str) -> str:
    kind = getattr(_core, name)
    stub = _stubs()[name]
    text = f"## {name} {{ #{name} }}\n\n"
    doc = inspect.cleandoc(kind.__doc__ or "")
    about, _, example = doc.partition(">>> ")
    if about.strip():
        text += f"{about.strip()}\n\n"
    if example:
        text += fenced("python", f">>> {example}") + "\n"
    rows, methods = [], ""
    for member in stub.body:
        if not isinstance(member, ast.FunctionDef) or member.name.startswith("_"):
            continue
        doc = inspect.cleandoc(getattr(kind, member.name).__doc__ or "")
        if any(isinstance(d, ast.Name) and d.id == "property" for d in member.decorator_list):
            first, _, example = doc.partition(">>> ")
            rows.append(
                [
                    code(member.name),
                    code(ast.unparse(member.returns or ast.Constant(""))),
                    words(" ".join(first.split())),
                ]
            )
        else:
            methods += _method(name, member, doc)
    if rows:
        text += table(("attribute", "type", "what it is"), rows) + "\n"
    return text + methods


def _method(owner: str, member: ast.FunctionDef, doc: str) -> str:
    arguments = ast.unparse(member.args).removeprefix("self").removeprefix(", ")
    text = f"### {owner}.{member.name}\n\n"
    text += (
        fenced(
            "python",
            f"{member.name}({arguments}) -> {ast.unparse(member.returns or ast.Constant(None))}",
        )
        + "\n"
    )
    lines = doc.splitlines()
    if lines and lines[0].startswith(f"{member.name}("):
        lines = lines[1:]
    about, _, example = "\n".join(lines).partition(">>> ")
    text += f"{about.strip()}\n\n" if about.strip() else ""
    return text + (fenced("python", f">>> {example}") + "\n" if example else "")


def _stubs() -> dict[str, ast.ClassDef]:
    stub = Path(_core.__file__).with_name("_core.pyi")
    tree = ast.parse(stub.read_text(encoding="utf-8"))
    return {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
