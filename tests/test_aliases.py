"""Other names of controls: found everywhere a control is named, and told."""

from __future__ import annotations

from pathlib import Path

import pytest
from test_cli import Done

import cncsub
from cncsub import _core
from cncsub.controls import EVIDENCE, alias_named, aliases_of

ASKED = [
    "fanuc-31i",
    "fanuc-32i",
    "fanuc-35i",
    "fanuc-18i",
    "fanuc-21i",
    "fanuc-0i-mate",
    "fanuc-0i-mf",
    "fanuc-0i-tf",
    "mitsubishi-m80",
    "mitsubishi-e80",
    "mitsubishi-c80",
    "sinumerik-one",
    "sinumerik-840d-sl",
    "siemens-840dsl",
    "hnc-22m",
    "emc2",
]


def test_an_alias_is_of_a_control_and_no_control_itself() -> None:
    assert set(ASKED) <= set(cncsub.aliases)
    for alias in cncsub.aliases.values():
        assert alias.control in list(cncsub.controls)
        assert alias.name not in list(cncsub.controls)
        assert alias.source
        strongest = _core.strongest(alias.source, alias.control)
        assert EVIDENCE.index(alias.evidence) >= EVIDENCE.index(strongest), alias


@pytest.mark.parametrize("name", ASKED)
def test_an_alias_gives_its_control(name: str) -> None:
    control = cncsub.aliases[name].control
    assert name in cncsub.controls
    assert name not in list(cncsub.controls)
    assert cncsub.controls[name] == cncsub.controls[control]
    for spelled in (name, name.upper(), name.replace("-", " ")):
        assert cncsub.control(spelled).name == control
    assert cncsub.loads("O1\nM30\n", control=name).control.name == control
    assert name in aliases_of(cncsub.controls[control])


def test_a_control_is_meant_before_an_alias() -> None:
    assert alias_named("fanuc-0i-f") is None
    assert alias_named("0i-f") is None
    alias = alias_named("31i")
    assert alias is not None
    assert alias.control == "fanuc-30i"
    with pytest.raises(ValueError, match="may be fanuc-0i-d or fanuc-0i-f"):
        cncsub.control("0i")


@pytest.mark.parametrize(
    ("wrong", "near"),
    [("fanuc-33i", "fanuc-32i"), ("mitsubishi-m90", "mitsubishi-m80"), ("fanuc-31", "fanuc-31i")],
)
def test_a_wrong_name_is_answered_with_the_nearest(wrong: str, near: str) -> None:
    with pytest.raises(ValueError, match=f"did you mean.*{near}"):
        cncsub.loads("O1", control=wrong)
    with pytest.raises(KeyError, match=f"did you mean.*{near}"):
        cncsub.controls[wrong]


def test_an_older_series_is_no_alias() -> None:
    """The FANUC 0-MD is no 0i-MD: nobody is given the one for the other."""
    with pytest.raises(ValueError, match="there is no control 'fanuc-0-md'"):
        cncsub.control("fanuc-0-md")


def test_the_screen_says_which_control_an_alias_is() -> None:
    done = Done("controls", "fanuc-31i")
    assert "fanuc-31i is taken as fanuc-30i, FANUC Series 30i/31i/32i [" in done.error
    assert "Also fanuc-31i, " in " ".join(done.out.split())
    assert "is taken as" not in Done("controls", "fanuc-30i").error
    (listed,) = (c for c in Done("controls", "--format", "json").json if c["name"] == "fanuc-30i")
    assert "fanuc-31i" in listed["aliases"]
    assert listed["inferred"] < listed["rules"]


def test_a_project_and_a_control_of_ones_own_may_name_an_alias(tmp_path: Path) -> None:
    (tmp_path / "cncsub.toml").write_text('control = "fanuc-31i"\n')
    (tmp_path / "part.nc").write_text("O1\nN1 M30\n")
    done = Done("run", tmp_path / "part.nc")
    assert done.status == 0
    assert "on FANUC Series 30i" in done.out
    own = tmp_path / "own.toml"
    own.write_text('name = "our-mill"\nbase = "fanuc-31i"\n')
    assert cncsub.Control.from_toml(own).base == "fanuc-30i"


def test_a_control_of_ones_own_cannot_have_the_name_of_an_alias(tmp_path: Path) -> None:
    own = tmp_path / "own.toml"
    own.write_text('name = "fanuc-31i"\nbase = "fanuc-0i-f"\n')
    with pytest.raises(ValueError, match="fanuc-31i is a built-in control: give yours another"):
        cncsub.Control.from_toml(own)
