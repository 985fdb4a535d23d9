"""Help that cuts no line short and lists the models."""

from __future__ import annotations

import re
from typing import Any

from typer.core import TyperCommand, TyperGroup

# Contexts and formatters have no type to name: Typer brings its own copy of Click or uses an installed one.
_FIRST_SENTENCE = re.compile(r"(?s)(.*?[.?!])(?:\s|$)")


class WholeSentences(TyperGroup):
    """A group of commands that lists each with its whole first sentence; Click ends them in three dots."""

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """Writes the commands and what they do."""
        rows = []
        for name in self.list_commands(ctx):
            command = self.get_command(ctx, name)
            text = " ".join((command.help or "").split()) if command is not None else ""
            match = _FIRST_SENTENCE.match(text)
            rows.append((name, match[1] if match else text))
        with formatter.section("Commands"):
            formatter.write_dl(rows)


class ListsModels(TyperCommand):
    """A command with a model among its options: its help ends with all models, a line each."""

    def format_epilog(self, ctx: Any, formatter: Any) -> None:
        """Writes the models, then the example."""
        # Imported here: help of other commands is there at once.
        from loomlight.models.registry import MODELS

        with formatter.section("Models"):
            formatter.write_dl([(name, entry.summary) for name, entry in MODELS.items()])
        super().format_epilog(ctx, formatter)
