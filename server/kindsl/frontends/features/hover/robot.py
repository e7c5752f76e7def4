"""The hover of the robot as a whole."""

from collections.abc import Iterator

from kindsl.frontends.features.quantity_text import KILOGRAMS, number
from kindsl.frontends.features.wording import paragraph
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.text.phrases import counted, listed
from kindsl.robots.mechanism.total_mass import Weight, total_mass


def robot_hover(analysis: Analysis, name: str) -> str:
    """Return what there is to tell of the robot."""
    return paragraph(f"**robot `{name}`**", _lines(analysis))


def _lines(analysis: Analysis) -> Iterator[str]:
    model = analysis.model
    kinds = [joint.kind for joint in model.joints]
    parts = [
        counted(count, f"{kind} joint")
        for kind in ("revolute", "prismatic")
        if (count := kinds.count(kind))
    ]
    base = "floating base" if model.floating else "fixed base"
    yield f"{base}, {counted(len(model.links), 'link')}" + (f", {listed(parts)}" if parts else "")
    if model.links or model.floating:
        yield _mass(total_mass(model, analysis.context.values))
    names = [f"`{parameter.name}`" for parameter in model.parameters]
    if names:
        yield f"parameters {listed(names)}"


def _mass(weight: Weight) -> str:
    mass = weight.told(f"{number(weight.known)} {KILOGRAMS}")
    return f"total mass {mass}" + ("" if weight.is_whole else f" ({weight.reason_text})")
