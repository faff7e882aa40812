"""Starting again in the middle of a run: its state there, and a restart program that is proved."""

from __future__ import annotations

from cncsub.resume.errors import ResumeError, WholeRunError
from cncsub.resume.resumed import Resume, resume
from cncsub.resume.state import RestartState

__all__ = ["RestartState", "Resume", "ResumeError", "WholeRunError", "resume"]
