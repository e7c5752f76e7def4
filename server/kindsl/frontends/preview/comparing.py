"""A document beside another description of its robot: the other as a ghost, and the differences."""

from collections.abc import Callable, Iterable
from functools import partial
from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.compared_document import compared_document
from kindsl.judgement.analysis.twins import read_file, read_twin
from kindsl.language.semantics.expressions import Values
from kindsl.robots.comparison.mechanical import compared_mechanics
from kindsl.robots.comparison.number_differences import NumberDifference
from kindsl.robots.comparison.restated import restated
from kindsl.robots.comparison.sentences import sentence_of, verdict
from kindsl.robots.comparison.side import ComparedSide
from kindsl.robots.mechanism.errors import ModelError, UnboundParameterError
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.mechanism.reading import partial_linkage, reachable_linkage
from kindsl.robots.scene.messages import ComparisonMessage, DifferenceRow, OtherMessage, path_of

LAST_SAVED = "last saved"


class OtherRobot(NamedTuple):
    """Another description of a document's robot.

    Attributes:
        name: Of its file, as people know it.
        read: Returns it, given whether the document's base floats, or why it cannot be read.
        joints: Pairs of our joints and its, where names and axes do not tell.
        tolerance: Relative, of what counts as equal besides what the digits leave open.
    """

    name: str
    read: Callable[[bool], ComparedSide | str]
    joints: tuple[tuple[str, str], ...] = ()
    tolerance: float = 0.0


class ShownComparison(NamedTuple):
    """The result of comparing.

    Attributes:
        message: For the page.
        ghost: The other robot in our conventions; None if it cannot be read.
    """

    message: ComparisonMessage
    ghost: Linkage | None


def document_robot(name: str, read: Callable[[], Analysis | str]) -> OtherRobot:
    """Return another document, which is read anew each time that it is compared."""

    def robot(_floating: bool) -> ComparedSide | str:
        analysis = read()
        return analysis if isinstance(analysis, str) else _as_far_as_known(name, analysis)

    return OtherRobot(name, robot)


def _as_far_as_known(name: str, analysis: Analysis) -> ComparedSide | str:
    model, values = analysis.model, analysis.context.values
    try:
        skeleton = reachable_linkage(model, values)
    except ModelError as error:
        is_unbound = isinstance(error, UnboundParameterError)
        found = None if is_unbound else partial_linkage(model, values)
        if found is None:
            return str(error)
        skeleton = found
    return compared_document(name, analysis, values, skeleton)


def file_robot(name: str, path: str) -> OtherRobot:
    """Return a file of another format or a folder of generated code, read anew when it changes."""
    return OtherRobot(name, partial(_of_file, lambda base: read_file(path, name, base)))


def twin_robots(analysis: Analysis) -> list[OtherRobot]:
    """Return the twins that the configuration names for a document."""
    return [
        OtherRobot(t.label, partial(_of_file, partial(read_twin, t)), t.joints, t.tolerance)
        for t in analysis.settings.twins
    ]


def _of_file(read: Callable[[bool], ComparedSide | str], floating: bool) -> ComparedSide | str:
    side = read(floating)
    return f"cannot be read: {side}" if isinstance(side, str) else side


def other_messages(others: Iterable[OtherRobot], chosen: str) -> list[OtherMessage]:
    """Return what can be compared."""
    return [
        OtherMessage(path_of("others", other.name), index, other.name, other.name == chosen)
        for index, other in enumerate(others)
    ]


def compared(
    label: str, analysis: Analysis, values: Values, skeleton: Linkage, other: OtherRobot
) -> ShownComparison:
    """Compare a document with another description."""
    theirs = other.read(skeleton.is_floating)
    if isinstance(theirs, str):
        told_why = f"{other.name}: {theirs}"
        return ShownComparison(
            ComparisonMessage(label, other.name, told_why, False, (), (), ()), None
        )
    ours = compared_document(label, analysis, values, skeleton)
    found = compared_mechanics(ours, theirs, dict(other.joints), other.tolerance)
    message = ComparisonMessage(
        own=label,
        other=other.name,
        verdict=verdict(found.is_equal, None),
        is_equal=found.is_equal,
        rows=tuple(_row(ours, theirs, number) for number in found.numbers),
        structure=found.structure,
        conventions=found.conventions,
    )
    return ShownComparison(message, restated(skeleton, theirs.skeleton, found))


def _row(ours: ComparedSide, theirs: ComparedSide, number: NumberDifference) -> DifferenceRow:
    here, there = number.places
    kind, name = _thing(ours.skeleton, number)
    return DifferenceRow(
        kind=kind,
        name=name,
        owner=number.owner,
        quantity=number.quantity,
        unit=number.unit,
        here=number.here,
        there=number.there,
        message=sentence_of(number, ours.place(here), theirs.place(there)),
        line=ours.line(here) or 0,
    )


def _thing(skeleton: Linkage, number: NumberDifference) -> tuple[str, str]:
    """Return the kind and name of the drawn thing that a number belongs to."""
    names = {
        "link": skeleton.body_names,
        "joint": skeleton.joint_names,
        "frame": tuple(frame.name for frame in skeleton.frames),
    }[number.kind]
    if number.owner in names:
        return number.kind, number.owner
    return "link", skeleton.body_names[number.body]
