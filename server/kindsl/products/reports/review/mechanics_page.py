"""A review of two descriptions of a robot in any formats: what differs, and both pictures."""

from collections.abc import Iterator

from kindsl.products.reports.drawing.camera import camera_for
from kindsl.products.reports.drawing.robot import points_of, robot_drawing
from kindsl.products.reports.mechanics import MechanicsReport, number_cells, verdict_of
from kindsl.products.reports.page.blocks import (
    Block,
    Figure,
    Heading,
    Page,
    Paragraph,
    SideBySide,
    Table,
)
from kindsl.products.reports.review.page import HEAVIER, MOVED
from kindsl.robots.comparison.restated import restated

_LEGEND = (
    "Same camera; the second robot in the first one's names, link frames and zeros. "
    "Orange: placed otherwise; violet: other mass."
)


def mechanics_page(report: MechanicsReport, notes: tuple[str, ...] = ()) -> Page:
    """Return the page; notes are sentences on what of a robot cannot be shown."""
    old, new, found = report[:3]
    verdict = verdict_of(report)
    return (
        Heading(f"{old.name} and {new.name}", 1),
        Paragraph(f"{verdict[:1].upper()}{verdict[1:]}."),
        *(Paragraph(f"{note}.") for note in notes),
        *(Paragraph(f"{sentence[:1].upper()}{sentence[1:]}.") for sentence in found.structure),
        *_numbers(report),
        *_pictures(report),
        *_conventions(found.conventions),
    )


def _numbers(report: MechanicsReport) -> Iterator[Block]:
    rows = tuple(number_cells(report))
    if rows:
        yield Heading("Numbers")
        header = ("what", "name", "number", report.old.name, report.new.name, "torque / N m, N")
        yield Table(header, rows)


def _pictures(report: MechanicsReport) -> Iterator[Block]:
    ours = report.old.skeleton
    theirs = restated(ours, report.new.skeleton, report.found)
    sides = (("before", report.old.name, ours), ("after", report.new.name, theirs))
    camera = camera_for([point for _, _, skeleton in sides for point in points_of(skeleton)])
    colors = _colors(report)
    yield Heading("Pictures")
    yield Paragraph(_LEGEND)
    yield SideBySide(
        tuple(Figure(key, robot_drawing(s, camera, colors), name) for key, name, s in sides)
    )


def _colors(report: MechanicsReport) -> dict[str, str]:
    names = report.old.skeleton.body_names
    frames = {n.owner: MOVED for n in report.found.numbers if n.kind == "frame"}
    heavy = {names[n.body]: HEAVIER for n in report.found.numbers if n.kind == "link"}
    moved = {names[n.body]: MOVED for n in report.found.numbers if n.kind == "joint"}
    return frames | heavy | moved


def _conventions(sentences: tuple[str, ...]) -> Iterator[Block]:
    if sentences:
        yield Heading("Conventions")
        yield Table(("what is only a convention",), tuple((each,) for each in sentences))
