"""What opens over the screen: questions with fields, a choice of rows, a text to read."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import ClassVar, NamedTuple

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical, VerticalScroll
from textual.content import Content
from textual.screen import ModalScreen
from textual.suggester import Suggester
from textual.widgets import Input, Label, OptionList, Static

from cncsub.escapes import shown
from cncsub.terminal.panes import Pane


class Field(NamedTuple):
    """A line to be typed: what stands before it, what it holds, and an example of what it takes."""

    label: str
    value: str = ""
    example: str = ""


class Answer(NamedTuple):
    """What a question is answered with. `closes`: whether the question is done with."""

    text: str = ""
    closes: bool = True
    wrong: bool = False


Put = Callable[[list[str]], Answer]


class Completing(Suggester):
    """Completes the end of what is typed, by what the control and the program know."""

    def __init__(self, complete: Callable[[str], str | None]) -> None:
        super().__init__(use_cache=False, case_sensitive=True)
        self._complete = complete

    async def get_suggestion(self, value: str) -> str | None:
        return self._complete(value)


class Ask(ModalScreen[str]):
    """Asks for some texts. What was wrong with them is told below, and they can be mended. The
    result is what came of them.
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "leave", "Leave"),
        Binding("down", "app.focus_next", show=False),
        Binding("up", "app.focus_previous", show=False),
    ]

    AUTO_FOCUS = "Input"

    def __init__(
        self,
        title: str,
        fields: Sequence[Field],
        put: Put,
        complete: Callable[[str], str | None] | None = None,
    ) -> None:
        super().__init__()
        self._heading, self._fields, self._put = title, fields, put
        self._completing = None if complete is None else Completing(complete)

    def compose(self) -> ComposeResult:
        with Vertical(id="dialog") as dialog:
            dialog.border_title = Content(self._heading)
            dialog.border_subtitle = "Enter does it, Esc leaves"
            with VerticalScroll(id="fields", can_focus=False):
                for field in self._fields:
                    yield Label(field.label, markup=False)
                    yield Input(
                        shown(field.value),
                        placeholder=field.example,
                        suggester=self._completing,
                        select_on_focus=False,
                        compact=True,
                    )
            yield Static("", id="answer", markup=False)

    def on_input_submitted(self) -> None:
        answer = self._put([field.value for field in self.query(Input)])
        if answer.closes and not answer.wrong:
            self.dismiss(answer.text)
            return
        told = self.query_one("#answer", Static)
        told.set_class(answer.wrong, "-wrong")
        told.update(Content("\n".join(map(shown, answer.text.splitlines()))))

    def action_leave(self) -> None:
        self.dismiss("")


class Choose(ModalScreen[str]):
    """Offers rows; the one that is chosen with Enter is handed on."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape,q", "leave", "Leave")]

    def __init__(
        self,
        title: str,
        rows: Iterable[tuple[Content, object]],
        take: Callable[[object], None],
    ) -> None:
        super().__init__()
        self._heading, self._rows, self._take = title, rows, take

    def compose(self) -> ComposeResult:
        pane = Pane(id="dialog", title="")
        pane.border_title = Content(self._heading)
        pane.border_subtitle = "Enter goes there, Esc leaves"
        yield pane

    def on_mount(self) -> None:
        pane = self.query_one(Pane)
        pane.fill(self._rows)
        pane.action_first()

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        chosen = self.query_one(Pane).chosen
        self.dismiss("")
        if chosen is not None:
            self._take(chosen)

    def action_leave(self) -> None:
        self.dismiss("")


class Tell(ModalScreen[None]):
    """Shows a text to read."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,q,enter,question_mark,f1,i", "leave", "Leave")
    ]

    def __init__(self, title: str, text: str) -> None:
        super().__init__()
        self._heading, self._text = title, text

    def compose(self) -> ComposeResult:
        with VerticalScroll(id="dialog") as dialog:
            dialog.border_title = Content(self._heading)
            dialog.border_subtitle = "Esc leaves"
            lines = map(shown, self._text.splitlines())
            yield Static(Content("\n".join(lines)), markup=False)

    def action_leave(self) -> None:
        self.dismiss()
