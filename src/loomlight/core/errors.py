"""What goes wrong because of what a user gave, as opposed to a defect of ours.

Every message is one sentence that names the file, the field, the value and what would be right.
The command line prints it and exits with 2; nothing else is caught there.
"""

from __future__ import annotations


class LoomlightError(Exception):
    """A user's input, machine or file is at fault; ``str(error)`` is one sentence for a person."""


class InputError(LoomlightError):
    """A value or file that a user gave cannot be used."""


class MissingDependencyError(LoomlightError):
    """Something outside the package is missing or too old (a system library, a device)."""


class LoomlightWarning(UserWarning):
    """Input that is used all the same, after a change that the message names."""
