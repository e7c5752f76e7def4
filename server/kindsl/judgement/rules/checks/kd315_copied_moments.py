"""A moment of inertia was copied into another attribute.

## What it does
Reports an inertia in a URDF or SDF whose product `ixy` equals its moment `ixx` in three digits or
more, or whose six numbers are all the same.

## Why is this bad?
One number was copied over another that is lost: no body has six equal ones, and two agree in so
many digits hardly ever by chance.

## Example
```xml
<inertia ixx="0.0123" ixy="0.0123" ixz="0" iyy="0.025" iyz="0" izz="0.025"/>
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.xml_elements import elements
from kindsl.language.semantics.model import Model
from kindsl.language.text.decimals import significant_digits

# Two digits agree by chance in one of a hundred bodies.
_LEAST_DIGITS = 3
_TENSOR = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for island, link in elements(model, "link"):
        inertia = link.find("inertial/inertia")
        numbers = [] if inertia is None else [island.value(inertia, name) for name in _TENSOR]
        if inertia is None or None in numbers[:2] or not numbers[0]:
            continue
        are_equal = len(set(numbers)) == 1
        is_precise = significant_digits(island.held(inertia, "ixx") or "") >= _LEAST_DIGITS
        if are_equal or (is_precise and numbers[1] == numbers[0]):
            which = "all six moments are" if are_equal else "'ixy' is the same as 'ixx':"
            message = f"moments of '{island.full_name}' were copied: {which} {numbers[0]:g} kg·m²"
            yield Finding(island.place(inertia, "ixy"), message)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document)
