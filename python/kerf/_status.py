"""What became of a call."""

from __future__ import annotations

import enum

from . import _core


class Status(str, enum.Enum):
    """What became of a cut or a section. Equal to its word: ``cut.status == "missed"``."""

    DONE = "done"
    #: The plane does not go through the object, which is as it was.
    MISSED = "missed"
    #: Done, but the mesh has holes where it was cut, and these stay open.
    OPEN_SECTION = "open_section"
    INVALID_ARGUMENT = "invalid_argument"
    INVALID_MESH = "invalid_mesh"
    OUT_OF_MEMORY = "out_of_memory"
    CANCELLED = "cancelled"
    UNUSABLE_FILE = "unusable_file"
    #: What ``only`` has chosen does not part the object, which is as it was.
    NOT_SEPARATED = "not_separated"

    @property
    def ok(self) -> bool:
        """Whether the call did what was asked for.

        >>> kerf.Status.OPEN_SECTION.ok, kerf.Status.MISSED.ok
        (True, False)
        """
        return self in (Status.DONE, Status.OPEN_SECTION)

    def __str__(self) -> str:
        return self.value


_NAMES = _core.status_names()


def status_of(number: int) -> Status:
    """The status of that number in kerf/status.h."""
    return Status(_NAMES[number].replace(" ", "_"))
