"""Documents for the preview's tests."""

from collections.abc import Mapping
from pathlib import Path

from tests.support import robots
from tests.support.models import Style, random_model

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.robots.mechanism.bodies import bodies_of
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.mechanism.reading import reachable_linkage

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"

PLAIN = Style(has_expressions=False)

ARM = robots.LIFT

PARAMETRIC_ARM = ARM.replace("translation = (0.4, 0.0, 0.0)", "translation = (reach, 0.0, 0.0)")
BROKEN_ARM = ARM.replace("slider via lift", "slider via", 1)


def skeleton_of(text: str) -> Linkage:
    """Return what there is to draw of a document without unbound parameters."""
    return skeleton_in(analyse(text))


def skeleton_in(analysis: Analysis, values: Mapping[str, float] | None = None) -> Linkage:
    """Return what there is to draw of a document, some parameters at given values."""
    return reachable_linkage(analysis.model, {**analysis.context.values, **(values or {})})


def mechanics_of(skeleton: Linkage) -> Mechanics:
    """Return the mechanics of what is drawn."""
    return Mechanics(bodies_of(skeleton))


def plain_robot(links: int, seed: int = 0) -> Analysis:
    """Return a random robot without parameters."""
    return analyse(random_model(links, seed, PLAIN))
