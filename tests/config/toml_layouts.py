"""Random configuration files: every way to write the same tables down."""

from collections.abc import Callable
from typing import NamedTuple

from hypothesis import strategies as st

DOCUMENT = "robots/arm.kindsl"
PATTERNS = ("robots/arm.kindsl", "arm.kindsl", "*.kindsl", "robots/", "other.kindsl", "arms/*")
NAMES = ("a", "b", "l2", "ärm", "value", "path")

Draw = Callable[[st.SearchStrategy], object]


class Layout(NamedTuple):
    """A file."""

    name: str
    text: str


@st.composite
def layouts(draw: st.DrawFn) -> Layout:
    """A `kindsl.toml` or `pyproject.toml` that is right, with comments and blanks anywhere."""
    is_own = draw(st.booleans())
    prefix = () if is_own else ("tool", "kindsl")
    blocks = draw(_blocks(prefix))
    if not is_own:
        blocks = _shuffled_in(draw, blocks, draw(st.lists(st.sampled_from(_OTHERS), unique=True)))
    text = "".join(blocks)
    if draw(st.booleans()):
        text = text.rstrip("\n")
    if draw(st.booleans()):
        text = text.replace("\n", "\r\n")
    return Layout("kindsl.toml" if is_own else "pyproject.toml", text)


_OTHERS = (
    "[project]\nname = 'x' # [tool.kindsl]\n",
    "[tool.other]\nparameters = { a = 1 }\n",
    "[tool.other.parameters]\na = 1\n",
    "[tool.parameters]\na = 1\n",
    "[parameters]\na = 'not ours'\n",
    "[[tool.other.document]]\npath = 'robots/arm.kindsl'\nparameters.a = nan\n",
    '[tool.text]\nlong = """\n[tool.kindsl.parameters]\na = 1.0\n"""\n',
    "[document]\nwhen = 2001-02-03\n",
)


@st.composite
def _blocks(draw: st.DrawFn, prefix: tuple[str, ...]) -> list[str]:
    """Our tables as blocks of lines; the first holds the keys before any other header."""
    style = draw(st.sampled_from(["headers", "headers", "dotted", "inline"])) if prefix else "own"
    parameters = draw(_parameters())
    documents = draw(st.lists(st.tuples(st.sampled_from(PATTERNS), _parameters()), max_size=3))
    keys = draw(_plain_keys())
    if style == "inline":
        inside = [*keys, *_inline_parameters(parameters), *_inline_documents(documents)]
        head, key = draw(st.sampled_from([("", "tool.kindsl"), ("[tool]\n", "kindsl")]))
        return [f"{head}{key} = {{ {', '.join(inside)} }}\n"]
    lines, blocks = [*keys], []
    _add_parameters(draw, lines, blocks, prefix, parameters)
    if documents and draw(st.booleans()):
        lines += _inline_documents(documents)
    else:
        for pattern, own in documents:
            blocks.append(_document(draw, prefix, pattern, own))
    if style == "dotted":
        return [_noisy(draw, [f"tool.kindsl.{line}" for line in lines]), *blocks]
    head = _header(draw, prefix) if style == "headers" and (lines or not blocks) else ""
    first = _noisy(draw, lines, head)
    return [first, *blocks] if style == "own" else _shuffled_in(draw, blocks, [first])


@st.composite
def _plain_keys(draw: st.DrawFn) -> list[str]:
    found = ['target = ["robcogen"]', 'ignore = ["KD7"]', 'severity = { KD401 = "error" }']
    return draw(st.lists(st.sampled_from(found), unique=True))


@st.composite
def _parameters(draw: st.DrawFn) -> list[tuple[str, str]]:
    """Names and values, also tables with ranges."""
    values = st.sampled_from(["1.0", "2", "-1e-3", "{ value = 1.0, min = 0 }", "{value=2.0}"])
    return list(draw(st.dictionaries(st.sampled_from(NAMES), values, max_size=3)).items())


def _add_parameters(
    draw: st.DrawFn,
    lines: list[str],
    blocks: list[str],
    path: tuple[str, ...],
    parameters: list[tuple[str, str]],
) -> None:
    """Write a table of parameters into the lines of the table that it is in, or as a block."""
    style = draw(st.sampled_from(["absent", "header", "inline", "dotted", "tables"]))
    if style == "inline":
        lines += _inline_parameters(parameters)
    elif style == "dotted":
        for name, value in parameters:
            if value.startswith("{"):
                lines += [f"parameters.{_key(name)}.{each}" for each in _members(value)]
            else:
                lines.append(f"parameters . {_key(name)} = {value}")
    elif style == "header":
        head = _header(draw, (*path, "parameters"))
        blocks.append(_noisy(draw, [f"{_key(n)} = {v}" for n, v in parameters], head))
    elif style == "tables":
        for name, value in parameters:
            head = _header(draw, (*path, "parameters", name))
            members = _members(value) if value.startswith("{") else [f"value = {value}"]
            blocks.append(_noisy(draw, members, head))


def _document(
    draw: st.DrawFn, prefix: tuple[str, ...], pattern: str, parameters: list[tuple[str, str]]
) -> str:
    path = (*prefix, "document")
    lines, blocks = [f"path = '{pattern}'", *draw(_plain_keys())], []
    _add_parameters(draw, lines, blocks, path, parameters)
    head = f"[{_header(draw, path).strip()}]\n"
    return "".join((_noisy(draw, draw(st.permutations(lines)), head), *blocks))


def _inline_parameters(parameters: list[tuple[str, str]]) -> list[str]:
    inside = ", ".join(f"{_key(name)} = {value}" for name, value in parameters)
    return [f"parameters = {{ {inside} }}" if inside else "parameters = {}"]


def _inline_documents(documents: list[tuple[str, list[tuple[str, str]]]]) -> list[str]:
    tables = [
        f"{{ path = '{pattern}', {_inline_parameters(own)[0]} }}"
        if own
        else f"{{path='{pattern}'}}"
        for pattern, own in documents
    ]
    return [f"document = [{', '.join(tables)}]"]


def _members(value: str) -> list[str]:
    return [each.strip() for each in value.strip("{} ").split(",")]


def _key(name: str) -> str:
    return name if name.isascii() else f'"{name}"'


def _header(draw: st.DrawFn, path: tuple[str, ...]) -> str:
    parts = [_key(part) for part in path]
    quoted = [f'"{part}"' for part in path]
    texts = [".".join(parts), " . ".join(parts), ".".join(quoted)] if path else [""]
    text = draw(st.sampled_from(texts))
    pad = draw(st.sampled_from(["", " "]))
    return f"[{pad}{text}{pad}]\n"


def _noisy(draw: st.DrawFn, lines: list[str], head: str = "") -> str:
    noise = st.sampled_from(["", "", "", "\n", "# a note\n", "\n# x = 1.0\n", "\n\n"])
    ends = st.sampled_from(["", "", " # why", "   "])
    text = draw(noise) + head.rstrip("\n") + (draw(ends) + "\n" if head else "")
    for line in lines:
        text += f"{draw(st.sampled_from(['', '', '  ']))}{line}{draw(ends)}\n{draw(noise)}"
    return text


def _shuffled_in(draw: st.DrawFn, blocks: list[str], others: list[str]) -> list[str]:
    """Return blocks with others between them, which keep no order."""
    mixed = list(blocks)
    for other in others:
        mixed.insert(draw(st.integers(0, len(mixed))), other)
    return mixed
