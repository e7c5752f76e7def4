"""Whether a server's message is what the protocol's specification says it may be.

`lsprotocol.types` is generated from the specification's own meta-model; this reads those types
strictly: nothing that is not named there, nothing missing, null only where null may be.
"""

import enum
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import Any, Literal, Union, get_args, get_origin

import attrs
from lsprotocol import types

# What is no part of the specification.
_OURS = ("kindsl/", "test/")


def faults(message: Mapping[str, Any], asked: Mapping[Any, str]) -> Iterator[str]:
    """Yield what is wrong with a message from a server.

    Args:
        message: As it came.
        asked: The methods of requests to the server, by id.
    """
    method = message.get("method", asked.get(message.get("id")))
    if "error" in message:
        if message.get("id", 0) is None:  # where the request could not be read
            message = {**message, "id": 0}
        yield from _faults(message, types.ResponseErrorMessage, "message")
    elif method is None:
        yield "answers no request"
    elif method in types.METHOD_TO_TYPES:
        is_call = "method" in message
        form = types.METHOD_TO_TYPES[method][0 if is_call else 1]
        yield from _faults(message, form, method)
        if is_call and types.message_direction(method) == "clientToServer":
            yield f"{method} is for clients to send"
    elif not method.startswith(_OURS):
        yield f"{method} is not specified"


def _faults(value: Any, form: Any, place: str) -> Iterator[str]:
    origin, parts = get_origin(form), get_args(form)
    if origin is Union:
        yield from _nearest([list(_faults(value, part, place)) for part in parts], place)
    elif origin is tuple and isinstance(value, list) and len(value) == len(parts):
        for number, (item, part) in enumerate(zip(value, parts, strict=True)):
            yield from _faults(item, part, f"{place}[{number}]")
    elif isinstance(value, list) and isinstance(origin, type) and issubclass(list, origin):
        for number, item in enumerate(value):
            yield from _faults(item, parts[0], f"{place}[{number}]")
    elif isinstance(value, dict) and isinstance(origin, type) and issubclass(dict, origin):
        for key, item in value.items():
            yield from _faults(key, parts[0], f"the key {key!r} of {place}")
            yield from _faults(item, parts[1], f"{place}.{key}")
    elif isinstance(form, type) and attrs.has(form) and isinstance(value, dict):
        yield from _faults_of_object(value, form, place)
    elif not _is_simple(value, form, origin, parts):
        yield f"{place} is {value!r}, not {form}"


def _nearest(alternatives: Sequence[list[str]], place: str) -> list[str]:
    """Return what is wrong with the likeliest form: best one that is wrong only inside."""
    is_another_form = f"{place} is "
    return min(
        alternatives, key=lambda all_: (any(f.startswith(is_another_form) for f in all_), len(all_))
    )


def _faults_of_object(value: dict[str, Any], form: type, place: str) -> Iterator[str]:
    fields = _fields(form)
    for key in value.keys() - fields.keys():
        yield f"{place}.{key} is not specified"
    for key, (field, is_required) in fields.items():
        if key in value and (value[key] is not None or is_required):
            yield from _faults(value[key], field.type, f"{place}.{key}")
            yield from _refusals(value[key], field, f"{place}.{key}")
        elif key in value:
            yield f"{place}.{key} is null"
        elif is_required:
            yield f"{place}.{key} is missing"


def _refusals(value: Any, field: "attrs.Attribute[Any]", place: str) -> Iterator[str]:
    """Yield what the type itself refuses: numbers out of range, other words than some."""
    if isinstance(value, str | int) and field.validator is not None:
        try:
            field.validator(None, field, value)
        except ValueError as error:
            yield f"{place} is {value!r}: {error.args[0]}"
        except TypeError:
            return  # it has another form altogether, which is told already


def _is_simple(value: Any, form: Any, origin: Any, parts: Sequence[Any]) -> bool:
    if form is Any or form is object:
        return True
    if origin is Literal:
        return value in parts
    if isinstance(value, bool) or form is bool:
        return isinstance(value, bool) and form is bool
    if isinstance(form, type) and issubclass(form, enum.Enum):
        return value in [member.value for member in form]
    if form is float:
        return isinstance(value, int | float)
    return isinstance(form, type) and isinstance(value, form)


@cache
def _fields(form: type) -> "dict[str, tuple[attrs.Attribute[Any], bool]]":
    """Return the members of an object in JSON's names, and whether they must be there."""
    attrs.resolve_types(form, vars(types), vars(types))  # type: ignore[type-var]
    return {
        _camel_case(field.name): (
            field,
            field.default is attrs.NOTHING or types.is_special_property(form, field.name),
        )
        for field in attrs.fields(form)  # type: ignore[arg-type]
    }


def _camel_case(name: str) -> str:
    first, *rest = name.rstrip("_").split("_")
    return first + "".join(map(str.capitalize, rest))
