"""Lark's LALR automaton as tables."""

from typing import Any


class Automaton:
    """Lark's LALR states, numbered so that equal grammars give equal tables."""

    def __init__(self, lark: Any, kinds: dict[str, str], starts: list[str]) -> None:
        self.table = lark.parser.parser._parse_table
        self.kinds = kinds
        self.starts = starts
        self.rules: dict[Any, int] = {}
        self.numbers: dict[Any, int] = {}
        self.symbols: dict[tuple[str, ...], int] = {(): 0}
        self._number()

    def _number(self) -> None:
        queue = [self.table.start_states[start] for start in self.starts]
        for state in queue:
            if state in self.numbers:
                continue
            self.numbers[state] = len(self.numbers)
            for _, (action, argument) in self._row(state):
                if str(action) == "Shift":
                    queue.append(argument)
                else:
                    self.rules.setdefault(argument, len(self.rules))

    def _row(self, state: Any) -> list[tuple[str, Any]]:
        return sorted(self.table.states[state].items())

    def tables(self) -> dict[str, Any]:
        """Return the automaton's tables by name."""
        states = tuple(map(self._tabled, self.numbers))
        return {
            "STARTS": {
                start: (
                    self.numbers[self.table.start_states[start]],
                    self.numbers[self.table.end_states[start]],
                )
                for start in self.starts
            },
            "SYMBOLS": tuple(self.symbols),
            "STATES": states,
            "RULES": tuple(_rule(rule, self.kinds) for rule in self.rules),
        }

    def _tabled(self, state: Any) -> tuple[Any, ...]:
        """Return what a state is in the middle of, its actions by tokens, its targets by rules.

        Symbols are the number of their tuple; an action is written once where all are the same.
        """
        cells = {self.kinds.get(symbol, ""): cell for symbol, cell in self._row(state)}
        actions = {kind: self._code(*cell) for kind, cell in cells.items() if kind}
        targets = {
            symbol: self.numbers[argument]
            for symbol, (_, argument) in self._row(state)
            if symbol not in self.kinds
        }
        tokens, rules = (self._numbered(tuple(row)) for row in (actions, targets))
        codes = tuple(actions.values())
        code = codes[0] if len(set(codes)) == 1 else codes
        return _construct(state), tokens, code, rules, tuple(targets.values())

    def _numbered(self, symbols: tuple[str, ...]) -> int:
        return self.symbols.setdefault(symbols, len(self.symbols))

    def _code(self, action: Any, argument: Any) -> int:
        """Return a state to shift to, or the complement of the number of a rule to reduce."""
        if str(action) == "Shift":
            return self.numbers[argument]
        return ~self.rules[argument]


def _rule(rule: Any, kinds: dict[str, str]) -> tuple[int, str, str, str]:
    """Return `(size, left-hand side, action, node kind)`; `builder.py` explains the actions."""
    size, name = len(rule.expansion), str(rule.origin.name)
    if name.startswith("__"):
        action = "extend" if rule.expansion[0].name == name else "list"
    elif name in ("_name", "_parameter"):
        action = "pass" if kinds[rule.expansion[0].name] == "NAME" else "name"
    elif size == 1 and (name.startswith("_") or (rule.options.expand1 and not rule.alias)):
        action = "pass"
    else:
        lists = any(symbol.name.startswith("__") for symbol in rule.expansion)
        action = "splice" if lists else "node"
    return size, name, action, str(rule.alias or name)


def _construct(state: Any) -> str:
    """Return the kind of node that a state is in the middle of, empty where there are several."""
    kinds = {
        str(pointer.rule.alias or pointer.rule.origin.name)
        for pointer in state
        if pointer.index > 0 and not pointer.rule.origin.name.startswith(("_", "$"))
    }
    return kinds.pop() if len(kinds) == 1 else ""
