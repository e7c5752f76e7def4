"""Drags of the picture: each writes one number that reads as the dragged value, or is refused.

Input: one drag a line: kind, name, component, value, step; each goes on from the last text.
"""

import math

from tests.support import robots

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.frontends.features.manipulation.set_component import set_component
from kindsl.frontends.features.manipulation.things import Thing, component
from kindsl.judgement.analysis.analysis import Analysis, analyse

_ARM = analyse(robots.LIFT)
_MOST_DRAGS = 20


def one_input(data: bytes) -> None:
    """Drag things of a robot that has numbers alone."""
    analysis = _ARM
    for line in data.decode("utf-8", "replace").split("\n")[:_MOST_DRAGS]:
        words = line.split(" ")
        if len(words) == 5:
            analysis = _dragged(analysis, Thing(words[0], words[1]), *words[2:])


def _dragged(analysis: Analysis, thing: Thing, name: str, value: str, step: str) -> Analysis:
    try:
        wanted, multiple = float(value), float(step) if step != "-" else None
    except ValueError:
        return analysis
    change = set_component(analysis, thing, name, wanted, multiple)
    if isinstance(change, Refusal):
        assert change.reason and not change.reason.endswith(".")
        return analysis
    assert len(change.edits) <= 1 and change.bindings == change.preview == ()
    after = analysis.edited(change.edits)
    written = component(after.model, thing, name)
    assert not isinstance(written, Refusal)
    found = written.expression.value(after.context.values)
    assert found is not None and math.isclose(found, change.value, rel_tol=1e-9, abs_tol=1e-9)
    assert [f.code for f in after.syntax.problems] == []
    return after
