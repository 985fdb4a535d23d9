"""Answers to the queries of trainings by kind of source; packages above register theirs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Generic, TypeVar

from loomlight.assets.sources import Source, kind_of_source
from loomlight.core.errors import InputError

AnswersT = TypeVar("AnswersT")


class QuerySources(Generic[AnswersT]):
    """Functions that make what answers the queries of a model, by kind of source."""

    def __init__(self, model: str, makers: Mapping[str, Callable[..., AnswersT]]) -> None:
        """
        Args:
            model: its name, for messages.
            makers: of the model's own package, by kind.
        """
        self._model, self._makers = model, dict(makers)

    @property
    def kinds(self) -> tuple[str, ...]:
        """Kinds of sources that are answered for."""
        return tuple(self._makers)

    def register(self, kind: str, make: Callable[..., AnswersT]) -> None:
        """Answers for a kind of source, a name of `SOURCE_KINDS`, made of a source and what `of` is given."""
        self._makers[kind] = make

    def of(self, source: Source, *arguments: Any) -> AnswersT:
        """The object that answers queries of a source.

        Raises:
            InputError: a kind of source that nobody answers for.
        """
        kind = kind_of_source(source)
        if kind not in self._makers:
            raise InputError(
                f"{source.name} is a {kind}, of which {self._model} can take no queries: it takes those of "
                f"{', '.join(sorted(self.kinds))}, and of what a renderer traces once loomlight.mitsuba is "
                "imported."
            )
        return self._makers[kind](source, *arguments)
