"""The tools: run, check, explain, compare, flatten, tree, listing, controls, rules."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict
from itertools import islice
from typing import Annotated, Any

from pydantic import Field

import cncsub
from cncsub.agents.answers import (
    CheckAnswer,
    CompareAnswer,
    ControlsAnswer,
    ExplainAnswer,
    FlattenAnswer,
    ListingAnswer,
    RulesAnswer,
    RunAnswer,
    TreeAnswer,
)
from cncsub.agents.programs import Folders, limits
from cncsub.reports.explained import known_facts, near_facts
from cncsub.reports.facts import (
    alarm_facts,
    comparison_facts,
    control_facts,
    endless_facts,
    tree_facts,
)
from cncsub.reports.findings import finding_facts
from cncsub.reports.nearest import nearest
from cncsub.tables.table import Table, records

MOST_ROWS = 200  # of a table, before the answer is measured

Control = Annotated[str, Field(description="The control, as fanuc-0i-f; `controls` lists them.")]
Programs = Annotated[
    dict[str, str] | None,
    Field(description="Texts by the names of their files: the memory of the control."),
]
Paths = Annotated[
    list[str] | None, Field(description="Files and folders, below those the server was given.")
]
Main = Annotated[str | None, Field(description="The program to run; the first without it.")]
Variables = Annotated[
    dict[str, float | None] | None, Field(description="Variables before the run: {'100': 5}.")
]
Blocks = Annotated[int, Field(description="How many blocks are executed at most.")]
Seconds = Annotated[float, Field(description="How many seconds the run may take.")]


def tools_on(folders: Folders) -> list[Callable[..., Any]]:
    """Return the tools, which read files below these folders."""
    return [*_running(folders), *_looking(folders), explain, controls, rules]


def _running(folders: Folders) -> list[Callable[..., Any]]:
    def run(
        control: Control,
        programs: Programs = None,
        paths: Paths = None,
        main: Main = None,
        variables: Variables = None,
        max_blocks: Blocks = 100_000,
        max_seconds: Seconds = 5.0,
    ) -> RunAnswer:
        """Run an NC program as the control would, down to the alarm: how it stopped and why,
        calls, moves, variables. The program is not simulated in material.
        """
        library = folders.library(control, programs, paths)
        asked = limits(max_blocks, max_seconds)
        made: cncsub.Run = library.run(main, variables=_numbered(variables), **asked)
        return _run_answer(library, made)

    def tree(
        control: Control,
        programs: Programs = None,
        paths: Paths = None,
        main: Main = None,
        max_blocks: Blocks = 100_000,
        max_seconds: Seconds = 5.0,
    ) -> TreeAnswer:
        """Run a program and return the tree of its calls, with arguments and callers."""
        library = folders.library(control, programs, paths)
        made: cncsub.Run = library.run(main, **limits(max_blocks, max_seconds))
        facts = tree_facts(made, "")
        return TreeAnswer(stop=made.stop.value, calls=facts["calls"]).fitted()

    def listing(
        control: Control,
        programs: Programs = None,
        paths: Paths = None,
        main: Main = None,
        program: Annotated[str | None, Field(description="Only blocks of this program.")] = None,
        n: Annotated[int | None, Field(description="Only blocks with this number.")] = None,
        watch: Annotated[
            list[int] | None, Field(description="Variables whose changes are told.")
        ] = None,
        max_blocks: Blocks = 100_000,
        max_seconds: Seconds = 5.0,
    ) -> ListingAnswer:
        """Run a program and list the executed blocks of a place, each with what it did: moves,
        calls, codes, changes of watched variables.
        """
        library = folders.library(control, programs, paths)
        asked = limits(max_blocks, max_seconds)
        made: cncsub.Run = library.run(main, watch=watch or (), **asked)
        rows = made.listing(program=program, n=n)
        blocks = [str(row) for row in islice(rows, MOST_ROWS)]
        left = sum(1 for _ in rows)
        answer = ListingAnswer(stop=made.stop.value, blocks=blocks)
        if left:
            answer.left_out["blocks"] = left
        return answer.fitted()

    return [run, tree, listing]


def _looking(folders: Folders) -> list[Callable[..., Any]]:
    def check(
        control: Control,
        programs: Programs = None,
        paths: Paths = None,
        main: Main = None,
        rules: Annotated[
            list[str] | None, Field(description="Only these rules: CS201, or a group such as CS2.")
        ] = None,
    ) -> CheckAnswer:
        """Find what the control would refuse or what will surprise, without running: each finding
        with its place, the alarm, the cure, and edits where the correction is certain.
        """
        library = folders.library(control, programs, paths)
        found = library.check(main, rules)
        facts = finding_facts(found)["findings"]
        notes = [str(note) for note in library.notes]
        return CheckAnswer(findings=facts, programs=list(library), notes=notes).fitted()

    def compare(
        controls: Annotated[
            list[str], Field(description="Two controls.", min_length=2, max_length=2)
        ],
        programs: Programs = None,
        paths: Paths = None,
        main: Main = None,
        max_blocks: Blocks = 20_000,
    ) -> CompareAnswer:
        """Run the same programs on two controls: where they part, what each does there, and the
        rules that cause it.
        """
        library = folders.library(controls[0], programs, paths)
        asked = limits(max_blocks, 2.0)
        compared = cncsub.compare(library, controls=controls, main=main, **asked)
        facts = comparison_facts(compared)
        return CompareAnswer(
            same=facts["same"],
            what=facts["what"] or "",
            where=facts["where"],
            rules=facts["rules"],
            parameters=facts["parameters"],
        ).fitted()

    def flatten(
        control: Control,
        programs: Programs = None,
        paths: Paths = None,
        main: Main = None,
        max_blocks: Blocks = 20_000,
    ) -> FlattenAnswer:
        """Write what a program executes as one program without calls, jumps and loops."""
        library = folders.library(control, programs, paths)
        try:
            flat = library.flatten(main, **limits(max_blocks, 5.0))
        except ValueError as error:
            return FlattenAnswer(text="", refusal=str(error))
        return FlattenAnswer(text=flat.text, refusal=None).fitted()

    return [check, compare, flatten]


def explain(
    asked: Annotated[
        str, Field(description="G65, PS0076, a cause, a rule, a parameter, CS201; or a question.")
    ],
    control: Annotated[str | None, Field(description="The control; all without it.")] = None,
) -> ExplainAnswer:
    """Explain a code, an alarm, a rule, a parameter or a finding of check, with its source and how
    sure it is; or find what a question is about.
    """
    among = list(cncsub.controls.values()) if control is None else [cncsub.control(control)]
    alarms, others, rule = known_facts(asked, among)
    found = [*alarms, *others, *([rule._asdict()] if rule is not None else [])]
    near = [] if found else near_facts(nearest(asked, among))
    return ExplainAnswer(found=found, nearest=near).fitted()


def controls() -> ControlsAnswer:
    """List the controls whose programs can be run."""
    rows = [{"name": name, "title": each.title} for name, each in cncsub.controls.items()]
    return ControlsAnswer(controls=rows)


def rules(
    control: Control,
    words: Annotated[
        str, Field(description="Only rules whose names or meanings hold this text.")
    ] = "",
) -> RulesAnswer:
    """Return the rules by which a control is run, each with its value, source and evidence."""
    known = cncsub.control(control)
    wanted = words.casefold()
    found = [
        rule
        for rule in control_facts(known)["rules"]
        if wanted in f"{rule['name']} {rule['group']} {rule['meaning']}".casefold()
    ]
    return RulesAnswer(control=known.name, rules=found).fitted()


def _numbered(variables: dict[str, float | None] | None) -> dict[int, float | None] | None:
    if variables is None:
        return None
    for name in variables:
        if not name.removeprefix("#").isdecimal():
            raise ValueError(f"a variable is given by its number, such as 100, not {name!r}")
    return {int(name.removeprefix("#")): value for name, value in variables.items()}


def _run_answer(library: cncsub.Library, run: cncsub.Run) -> RunAnswer:
    alarm = None if run.alarm is None else alarm_facts(run.alarm, library.control)
    tables: dict[str, Table[Any]] = {"calls": run.calls, "moves": run.moves}
    rows = {name: list(map(dict, islice(records(of), MOST_ROWS))) for name, of in tables.items()}
    answer = RunAnswer(
        stop=run.stop.value,
        waiting_for=run.waiting_for or None,
        alarm=alarm,
        endless=None if run.endless is None else endless_facts(run.endless),
        blocks=run.blocks,
        seconds=run.moves.total_time,
        length=run.moves.total_length,
        bounds={axis: list(pair) for axis, pair in run.moves.bounds.items()},
        position=dict(run.position),
        modal=dict(run.modal),
        variables={str(number): value for number, value in run.variables.items()},
        messages=run.messages,
        m_codes=run.m_codes,
        t_codes=run.t_codes,
        calls=rows["calls"],
        moves=rows["moves"],
        dropped=[asdict(word) for word in run.dropped],
        notes=[str(note) for note in library.notes],
    )
    for name, table in tables.items():
        if len(table) > MOST_ROWS:
            answer.left_out[name] = len(table) - MOST_ROWS
    return answer.fitted()
