"""Writes the types of messages: `python -m generating.message_types [--check]`."""

import inspect
import sys
from collections.abc import Iterator, Mapping
from enum import StrEnum
from pathlib import Path
from types import NoneType, UnionType
from typing import (
    Annotated,
    Any,
    ClassVar,
    Literal,
    NewType,
    Union,
    get_args,
    get_origin,
    get_type_hints,
)

from kindsl.frontends.preview.requests import Request, type_of
from kindsl.robots.scene.geometry import Shape
from kindsl.robots.scene.messages import Change, Part

_PREVIEW = Path(__file__).parents[1] / "server" / "kindsl" / "frontends" / "preview"
TARGET = _PREVIEW / "page" / "messages.d.ts"
_HEAD = """\
// Messages between server and page. Generated from server/kindsl/robots/scene/messages.py and
// server/kindsl/frontends/preview/requests.py by
// `python -m generating.message_types`; do not edit.
//
// Numbers that are not finite may come as null in JSON.
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
    kinds = dict.fromkeys(_referenced((Part, Change, Request)))
    unions = "".join(
        f"\n/** {line} */\nexport type {name} =\n  | {members};\n"
        for name, line, union in (
            ("Part", "One piece of news.", Part), ("Request", "What the page asks for.", Request),
        )
        for members in ["\n  | ".join(kind.__name__ for kind in get_args(union))]
    )  # fmt: skip
    return "".join((_HEAD, _SHAPE, *map(interface, kinds), unions))


def main(arguments: list[str]) -> int:
    """Write the file, or check that it is up to date; return the exit status."""
    wanted = declarations()
    if "--check" in arguments:
        if TARGET.is_file() and TARGET.read_text(encoding="utf-8") == wanted:
            return 0
        print(f"{TARGET} is out of date; run python -m generating.message_types")
        return 1
    TARGET.write_text(wanted, encoding="utf-8", newline="\n")
    return 0


def interface(kind: type) -> str:
    """Return a message, or what one is made of, as an interface of TypeScript."""
    rows = [f"\n/** {(inspect.getdoc(kind) or '').partition(chr(10))[0]} */"]
    rows.append(f"export interface {kind.__name__} {{")
    is_request = kind in get_args(Request)
    word = type_of(kind) if is_request else getattr(kind, "type", "")
    rows += [f'  readonly type: "{word}";'] if word else []
    optional = getattr(kind, "_field_defaults", ()) if is_request else ()
    for name, hint in get_type_hints(kind, include_extras=True).items():
        notes = ", ".join(reversed(getattr(hint, "__metadata__", ())))
        rows += [f"  /** {notes[:1].upper()}{notes[1:]}. */"] if notes else []
        if get_origin(hint) is not ClassVar:
            rows.append(f"  readonly {name}{'?' if name in optional else ''}: {_type(hint)};")
    return "\n".join((*rows, "}", ""))


def _referenced(hints: tuple[Any, ...]) -> Iterator[type]:
    """Yield the classes that hints name, each after those that it is made of."""
    for hint in hints:
        if _is_record(hint):
            yield from _referenced(tuple(get_type_hints(hint).values()))
            yield hint
        else:
            yield from _referenced(get_args(hint) if get_origin(hint) is not Literal else ())


def _is_record(hint: Any) -> bool:
    return inspect.isclass(hint) and hint is not Shape and bool(get_type_hints(hint))


def _type(hint: Any) -> str:
    """Return an annotation as TypeScript."""
    if hint in _WORDS:
        return _WORDS[hint]
    if hint == Part:
        return "Part"
    if isinstance(hint, NewType):
        return _type(hint.__supertype__)
    if inspect.isclass(hint) and issubclass(hint, StrEnum):
        return " | ".join(f'"{word}"' for word in hint)
    origin, arguments = get_origin(hint), get_args(hint)
    if origin in (Annotated, ClassVar):
        return _type(arguments[0])
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
    if _is_record(hint):
        return str(hint.__name__)
    raise TypeError(f"a message cannot hold {hint!r}")


def _item(hint: Any) -> str:
    """Return the type of an array's items; what has several words needs parentheses there."""
    word = _type(hint)
    return f"({word})" if " " in word else word


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
