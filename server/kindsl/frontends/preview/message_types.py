"""Writes the types of messages: `python -m kindsl.frontends.preview.message_types [--check]`."""

import dataclasses
import inspect
import re
import sys
from collections.abc import Iterator, Mapping
from enum import StrEnum
from pathlib import Path
from types import NoneType, UnionType
from typing import Any, ClassVar, Literal, Union, get_args, get_origin, get_type_hints

from kindsl.robots.scene import messages
from kindsl.robots.scene.geometry import Shape

TARGET = Path(__file__).parent / "page" / "messages.d.ts"
_HEAD = """\
// What the server tells the page. Generated from server/kindsl/robots/scene/messages.py by
// `python -m kindsl.frontends.preview.message_types`; do not edit.
//
// Lengths are in metres, angles in radians, masses in kilograms. A matrix has 16 numbers, column by
// column (three.js' order). What is no finite number may come as null in JSON.
"""
# In the form of three.js' JSON, for the viewer's own loader.
_SHAPE = """
/** A shape as three.js' ObjectLoader reads it. Equal shapes have equal identifiers. */
export interface ShapeObject {
  readonly metadata: { readonly version: number; readonly type: string };
  readonly geometries: readonly { readonly uuid: string; readonly type: string }[];
  readonly materials: readonly {
    readonly uuid: string;
    readonly type: string;
    readonly color: number;
  }[];
  readonly object: {
    readonly uuid: string;
    readonly type: string;
    readonly geometry: string;
    readonly material: string;
    readonly matrix: readonly number[];
  };
}
"""
_WORDS: Mapping[Any, str] = {
    str: "string", int: "number", float: "number", bool: "boolean", NoneType: "null",
    Shape: "ShapeObject",
}  # fmt: skip


def declarations() -> str:
    """Return the text of `messages.d.ts`."""
    interfaces = (_interface(kind) for kind in _classes())
    names = "\n  | ".join(kind.__name__ for kind in get_args(messages.Part))
    part = f"\n/** One piece of news. */\nexport type Part =\n  | {names};\n"
    return "".join((_HEAD, _SHAPE, *interfaces, part))


def main(arguments: list[str]) -> int:
    """Write the file, or say that it is not as the messages want it; return the exit status."""
    wanted = declarations()
    if "--check" in arguments:
        if TARGET.is_file() and TARGET.read_text(encoding="utf-8") == wanted:
            return 0
        print(f"{TARGET} is out of date; run python -m kindsl.frontends.preview.message_types")
        return 1
    TARGET.write_text(wanted, encoding="utf-8", newline="\n")
    return 0


def described(kind: type) -> tuple[str, dict[str, str]]:
    """Return what a message's docstring says of it, and of each of its fields."""
    text = inspect.cleandoc(kind.__doc__ or "")
    first, _, rest = text.partition("\n")
    found = re.findall(r"^ {4}(\w+): (.*(?:\n {8}.*)*)", rest, re.MULTILINE)
    return first, {name: re.sub(r"\s+", " ", line) for name, line in found}


def _classes() -> Iterator[type]:
    """Yield the messages in the order of their file."""
    for kind in vars(messages).values():
        if inspect.isclass(kind) and kind.__module__ == messages.__name__:
            yield kind


def _interface(kind: type) -> str:
    first, lines = described(kind)
    hints = get_type_hints(kind)
    rows = [f"\n/** {first} */", f"export interface {kind.__name__} {{"]
    if get_origin(hints.get("type")) is ClassVar:
        rows.append(f"  readonly type: {_type(*get_args(hints['type']))};")
    for field in dataclasses.fields(kind):
        rows.append(f"  /** {lines[field.name]} */")
        rows.append(f"  readonly {field.name}: {_type(hints[field.name])};")
    return "\n".join((*rows, "}", ""))


def _type(hint: Any) -> str:
    """Return an annotation as TypeScript."""
    if hint in _WORDS:
        return _WORDS[hint]
    if hint == messages.Part:
        return "Part"
    if inspect.isclass(hint) and issubclass(hint, StrEnum):
        return " | ".join(f'"{word}"' for word in hint)
    origin, arguments = get_origin(hint), get_args(hint)
    if origin is Literal:
        return " | ".join(f'"{word}"' for word in arguments)
    if origin in (Union, UnionType):
        return " | ".join(_type(argument) for argument in arguments)
    if origin is tuple and arguments[1:] == (...,):
        return f"readonly {_item(arguments[0])}[]"
    if origin is tuple:
        return f"readonly [{', '.join(_type(argument) for argument in arguments)}]"
    if origin is not None and issubclass(origin, Mapping):
        return f"{{ readonly [name: string]: {_type(arguments[1])} }}"
    if dataclasses.is_dataclass(hint):
        return hint.__name__  # type: ignore[union-attr]
    raise TypeError(f"a message cannot hold {hint!r}")


def _item(hint: Any) -> str:
    """Return the type of an array's items; what has several words needs parentheses there."""
    word = _type(hint)
    return f"({word})" if " " in word else word


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
