"""Errors caused by a user's input, file or machine, as opposed to defects of this project.

Every message is one sentence that names the file, the field, the value and what would be right.
The command line prints it and exits with 2; nothing else is caught there.
"""

from __future__ import annotations


class LoomlightError(Exception):
    """A user's input, machine or file is at fault; ``str(error)`` is one sentence for a person."""


class InputError(LoomlightError):
    """A value or file from a user cannot be used."""


class MissingDependencyError(LoomlightError):
    """Something outside the package is missing or too old (a system library, a device)."""


class LoomlightWarning(UserWarning):
    """Input that is used all the same, after a change that the message names."""
