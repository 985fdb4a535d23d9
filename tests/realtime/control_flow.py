"""How many ways lead through the loops of a shader in WGSL, as `slangc` writes it.

Compilers may walk all of them: SwiftShader's analysis of control flow takes twice as long for each diamond of
a loop, an `if` whose sides meet again. What a function does counts wherever it is called: calls are inlined.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from math import log2

_TOKENS = re.compile(r"\b(?:if|else|for|while|loop|switch|break|continue|return)\b|\w+(?=\s*\()|[{}();]")


def diamonds_in_loops(code: str) -> float:
    """Logarithm to base 2 of the ways through a turn of the loop that has most of them; 0 without loops."""
    shader = _Shader(code)
    for name in shader.bodies:
        shader.factor(name)
    return log2(shader.most)


@dataclass
class _Ways:
    """Numbers of ways out of a piece of code, of one into it."""

    on: int = 0  # to what follows
    broken: int = 0  # out of the loop
    again: int = 0  # to its next turn
    returned: int = 0

    def then(self, following: _Ways) -> _Ways:
        on = self.on
        return _Ways(
            on * following.on,
            self.broken + on * following.broken,
            self.again + on * following.again,
            self.returned + on * following.returned,
        )

    def beside(self, other: _Ways) -> _Ways:
        return _Ways(
            self.on + other.on,
            self.broken + other.broken,
            self.again + other.again,
            self.returned + other.returned,
        )


class _Shader:
    def __init__(self, code: str) -> None:
        starts = [*re.finditer(r"\bfn\s+(\w+)[^{]*", code)]
        self.bodies = {start[1]: code[start.end() :] for start in starts}
        self.most = 1
        self._factors: dict[str, int] = {}

    def factor(self, name: str) -> int:
        """Ways through a call; 1 of what is built in."""
        if name not in self.bodies:
            return 1
        if name not in self._factors:
            ways = _Body(self, self.bodies[name]).statement()
            self._factors[name] = ways.on + ways.returned
        return self._factors[name]


class _Body:
    """Reads the statements of one function."""

    def __init__(self, shader: _Shader, code: str) -> None:
        self._shader = shader
        self._tokens = (match[0] for match in _TOKENS.finditer(code))
        self._ahead = next(self._tokens)

    def _next(self) -> str:
        token, self._ahead = self._ahead, next(self._tokens, "")
        return token

    def statement(self) -> _Ways:
        token = self._next()
        if token == "{":
            ways = _Ways(on=1)
            while self._ahead != "}":
                ways = ways.then(self.statement())
            self._next()
            return ways
        if token == "if":
            head = _Ways(on=self._calls_in_brackets())
            ways = self.statement()
            if self._ahead == "else":
                self._next()
                return head.then(ways.beside(self.statement()))
            return head.then(ways.beside(_Ways(on=1)))
        if token in ("for", "while", "loop"):
            head = _Ways(on=1 if token == "loop" else self._calls_in_brackets())
            turn = head.then(self.statement())
            self._shader.most = max(self._shader.most, turn.on + turn.broken + turn.again + turn.returned)
            return _Ways(on=max(turn.broken, 1), returned=turn.returned)
        assert token != "switch"  # slangc writes none for these shaders
        calls = self._calls_up_to_semicolon(token)
        if token == "return":
            return _Ways(returned=calls)
        return {"break": _Ways(broken=1), "continue": _Ways(again=1)}.get(token, _Ways(on=calls))

    def _calls_in_brackets(self) -> int:
        factor, depth = 1, 0
        while True:
            token = self._next()
            depth += {"(": 1, ")": -1}.get(token, 0)
            factor *= self._shader.factor(token)
            if depth == 0:
                return factor

    def _calls_up_to_semicolon(self, token: str) -> int:
        factor = 1
        while token != ";":
            factor *= self._shader.factor(token)
            token = self._next()
        return factor
