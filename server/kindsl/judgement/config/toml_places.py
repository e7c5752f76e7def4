"""Places of the keys of a TOML text, which tomllib does not give.

The text has to be valid: `tomllib` has read it before.
"""

import re

KeyPath = tuple[str | int, ...]
Span = tuple[int, int]
Places = dict[KeyPath, Span]

_BLANK = re.compile(r"(?:[ \t\r\n]|#[^\n]*)*")
_STRING = re.compile(
    r'"""(?:\\.|[^\\])*?"{3,5}|\'\'\'.*?\'{3,5}|"(?:\\.|[^"\\])*"|\'[^\']*\'', re.DOTALL
)
BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")
_SCALAR = re.compile(r"[^,\]}#\r\n]+")


def toml_places(text: str) -> Places:
    """Return the span of each key, table header and list element by its path.

    A key's span is that of its last part; a list element's that of its value.
    """
    return {path: spans[0] for path, spans in _scanned(text).items()}


def spans_of(text: str, path: KeyPath) -> list[Span]:
    """Return all spans of a key: dotted keys and headers may repeat it."""
    return _scanned(text).get(path, [])


def _scanned(text: str) -> dict[KeyPath, list[Span]]:
    scan = _Scan(text)
    scan.document()
    return scan.places


class _Scan:
    """A position in the text and the places found so far."""

    __slots__ = ("_counts", "places", "position", "text")

    def __init__(self, text: str) -> None:
        self.text = text
        self.position = 0
        self.places: dict[KeyPath, list[Span]] = {}
        self._counts: dict[KeyPath, int] = {}

    def document(self) -> None:
        """Read everything."""
        table: KeyPath = ()
        while self._skip_blank() < len(self.text):
            if self.text[self.position] == "[":
                table = self._header()
            else:
                self._pair(table)

    def _note(self, path: KeyPath, span: Span) -> None:
        self.places.setdefault(path, []).append(span)

    def _header(self) -> KeyPath:
        is_list = self.text.startswith("[[", self.position)
        self.position += 2 if is_list else 1
        path: KeyPath = ()
        parts = self._key()
        for number, (part, span) in enumerate(parts, 1):
            path = (*path, part)
            if number == len(parts) and is_list:
                self._counts[path] = self._counts.get(path, -1) + 1
            self._note(path, span)
            if path in self._counts:
                path = (*path, self._counts[path])
                self._note(path, span)
        self._skip_blank()
        self.position += 2 if is_list else 1
        return path

    def _pair(self, table: KeyPath) -> None:
        path = table
        for part, span in self._key():
            path = (*path, part)
            self._note(path, span)
        self._skip_blank()
        self.position += 1
        self._value(path)

    def _key(self) -> list[tuple[str, Span]]:
        parts: list[tuple[str, Span]] = []
        while True:
            start = self._skip_blank()
            quoted = _STRING.match(self.text, start)
            match = quoted or BARE_KEY.match(self.text, start)
            if match is None:
                raise ValueError(f"no key at offset {start}")
            self.position = match.end()
            parts.append((_unquoted(match[0]) if quoted else match[0], match.span()))
            self._skip_blank()
            if not self.text.startswith(".", self.position):
                return parts
            self.position += 1

    def _value(self, path: KeyPath) -> None:
        start = self._skip_blank()
        first = self.text[start]
        if first == "{":
            self._inline_table(path)
        elif first == "[":
            self._list(path)
        else:
            match = _STRING.match(self.text, start) or _SCALAR.match(self.text, start)
            if match is None:
                raise ValueError(f"no value at offset {start}")
            self.position = match.start() + len(match[0].rstrip())

    def _inline_table(self, path: KeyPath) -> None:
        self.position += 1
        while self._skip_separators() != "}":
            self._pair(path)
        self.position += 1

    def _list(self, path: KeyPath) -> None:
        self.position += 1
        number = 0
        while self._skip_separators() != "]":
            start = self.position
            self._value((*path, number))
            self._note((*path, number), (start, self.position))
            number += 1
        self.position += 1

    def _skip_separators(self) -> str:
        while self._skip_blank() < len(self.text) and self.text[self.position] == ",":
            self.position += 1
        return self.text[self.position]

    def _skip_blank(self) -> int:
        match = _BLANK.match(self.text, self.position)
        assert match is not None
        self.position = match.end()
        return self.position


def _unquoted(key: str) -> str:
    import tomllib

    return str(tomllib.loads(f"key = {key}")["key"])
