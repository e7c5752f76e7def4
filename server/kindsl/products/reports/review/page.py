"""A review of a change: tables and pictures, before and after."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from math import dist, isclose

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.body_doubts import body_doubts
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.lines import LineIndex
from kindsl.language.text.phrases import counted
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.products.reports.card import shown_skeleton, triple
from kindsl.products.reports.columns import number
from kindsl.products.reports.comparison import Comparison, compared
from kindsl.products.reports.difference_text import ChangeRow, change_rows
from kindsl.products.reports.drawing.camera import camera_for
from kindsl.products.reports.drawing.robot import points_of, robot_drawing
from kindsl.products.reports.page.blocks import (
    Block,
    Figure,
    Heading,
    Page,
    Paragraph,
    SideBySide,
    Table,
)
from kindsl.products.reports.review.written_numbers import written_changes
from kindsl.products.reports.robot_facts import branches, robot_facts
from kindsl.robots.comparison.difference import Difference

MOVED, HEAVIER, ADDED, REMOVED = "d9730d", "8e44ad", "2e8b57", "c0392b"
_LEGEND = "Same camera. Orange: moved; violet: other mass; green: new; red: gone."
_NO_TREE = "does not describe a tree of links"


def review_page(before: Analysis | None, after: Analysis | None, names: tuple[str, str]) -> Page:
    """Return the page about two documents, None for one that is not there."""
    if before is not None and after is not None and before.text == after.text:
        return (Paragraph(f"{names[0]} and {names[1]}: nothing changed."),)
    found = compared(before, after)
    old, new = before or analyse(""), after or analyse("")
    joints = _renamed_joints(old, new, found.difference)
    return (
        Heading(f"{new.model.name or old.model.name or '(unnamed)'}: {names[0]} to {names[1]}", 1),
        *([Paragraph(f"The document is not in {names[0]}: it is new.")] if before is None else []),
        *([Paragraph(f"The document is no longer in {names[1]}.")] if after is None else []),
        *_notes(old, new, names, found),
        *_changes(found.difference, joints),
        *_numbers(old, new, found.difference, joints),
        *_pictures(old, new, found.difference),
        *_tree(old, new, found.difference),
        *_masses(old, new, found.difference),
        *(_balance(old.mechanism(), new.mechanism()) if found.is_of_whole else ()),
        *_findings(old, new),
    )


def _renamed_joints(old: Analysis, new: Analysis, found: Difference | None) -> dict[str, str]:
    """Return new names of joints that carry the same link as before, by the old names."""
    links = _renamed_links(found)
    carriers = _carriers(new)
    gone = {str(j.name) for j in old.model.joints} - {str(j.name) for j in new.model.joints}
    come = {str(j.name) for j in new.model.joints} - {str(j.name) for j in old.model.joints}
    pairs = ((joint, carriers.get(links.get(n, n), "")) for n, joint in _carriers(old).items())
    return {before: after for before, after in pairs if before in gone and after in come}


def _carriers(analysis: Analysis) -> dict[str, str]:
    edges = analysis.model.tree.edges
    return {str(edge.child.link): str(edge.child.joint) for edge in edges}


def _renamed_links(found: Difference | None) -> dict[str, str]:
    return {pair.old: pair.new for pair in found.renamed_links} if found else {}


def _notes(
    old: Analysis, new: Analysis, names: tuple[str, str], found: Comparison
) -> Iterator[Block]:
    for name, analysis in zip(names, (old, new), strict=True):
        n = sum(finding.severity is Severity.ERROR for finding in analysis.findings)
        if n:
            yield Paragraph(f"{name} has {counted(n, 'error')}: showing the rest.")
    if found.treeless is not None:
        yield Paragraph(f"{names[found.treeless]} {_NO_TREE}.")
    for note in found.notes:
        yield Paragraph(f"{note[:1].upper()}{note[1:]}.")


def _changes(found: Difference | None, joints: Mapping[str, str]) -> Iterator[Block]:
    if found is None:
        return
    yield Heading("What changed")
    rows = [row for row in change_rows(found) if not _is_half_of_a_renaming(row, joints)]
    renamed = [ChangeRow("joint", b, f"renamed, was '{a}'") for a, b in joints.items()]
    cells = (*renamed, *rows)
    yield (
        Table(("what", "name", "change"), cells)
        if cells
        else Paragraph("Nothing changed mechanically.")
    )


def _is_half_of_a_renaming(row: ChangeRow, joints: Mapping[str, str]) -> bool:
    is_half = row.change == "removed" and row.name in joints
    return row.kind == "joint" and (
        is_half or (row.change == "added" and row.name in joints.values())
    )


def _numbers(
    old: Analysis, new: Analysis, found: Difference | None, joints: Mapping[str, str]
) -> Iterator[Block]:
    changes = tuple(written_changes(old, new, _renamed_links(found), joints))
    if changes:
        yield Heading("Numbers")
        header = ("what", "name", "number", "before", "after", "remark")
        yield Table(header, changes, frozenset((3, 4)))


def _pictures(old: Analysis, new: Analysis, found: Difference | None) -> Iterator[Block]:
    sides = [(shown_skeleton(each), body_doubts(each, each.findings)) for each in (old, new)]
    shown = [skeleton for skeleton, _ in sides if skeleton is not None]
    if not shown:
        return
    camera = camera_for([point for skeleton in shown for point in points_of(skeleton)])
    pictures = tuple(
        Figure(name, robot_drawing(skeleton, camera, colors, doubts=doubts), name.capitalize())
        for name, (skeleton, doubts), colors in zip(
            ("before", "after"), sides, _colors(found), strict=True
        )
        if skeleton is not None
    )
    yield Heading("Pictures")
    yield Paragraph(_LEGEND)
    yield SideBySide(pictures)


def _colors(found: Difference | None) -> tuple[dict[str, str], dict[str, str]]:
    if found is None:
        return {}, {}
    shared = dict.fromkeys((change.link for change in found.masses), HEAVIER)
    shared |= dict.fromkeys((move.name for move in found.zero_poses), MOVED)
    old_name = {pair.new: pair.old for pair in found.renamed_links}
    before = {old_name.get(name, name): color for name, color in shared.items()}
    before |= dict.fromkeys((*found.removed_links, *found.removed_frames), REMOVED)
    return before, shared | dict.fromkeys((*found.added_links, *found.added_frames), ADDED)


def _tree(old: Analysis, new: Analysis, found: Difference | None) -> Iterator[Block]:
    """Yield the changed tree beside each link's former parent; removed links last."""
    links = _renamed_links(found)
    before = {links.get(name, name): text for name, text in _hangs_on(old, links).items()}
    after = _hangs_on(new, {})
    rows = []
    for are_last, body in branches(robot_facts(new)):
        name = body["name"]
        rows.append(("  " * len(are_last) + name, before.pop(name, "-"), after.get(name, "-")))
    rows += [(name, text, "-") for name, text in before.items()]
    if all(row[1] == row[2] for row in rows):
        return
    yield Heading("Tree")
    marked = tuple((*row, "" if row[1] == row[2] else "changed") for row in rows)
    yield Table(("link", "before", "after", ""), marked)


def _hangs_on(analysis: Analysis, links: Mapping[str, str]) -> dict[str, str]:
    facts = robot_facts(analysis)
    base = {facts["base"]["name"]: "base"} if facts["base"] else {}
    carried = {
        body["name"]: f"{links.get(body['parent'], body['parent'])} via {body['joint']}"
        if body["joint"]
        else "nothing"
        for body in facts["links"]
    }
    return {**base, **carried}


def _masses(old: Analysis, new: Analysis, found: Difference | None) -> Iterator[Block]:
    links = _renamed_links(found)
    before, after = (
        {b["name"]: b["mass"] for _, b in branches(robot_facts(a))} for a in (old, new)
    )
    before = {links.get(name, name): mass for name, mass in before.items()}
    rows = tuple(
        (name, number(before.get(name)), number(after.get(name)), _change(before, after, name))
        for name in dict.fromkeys((*after, *before))
    )
    if before != after:
        yield Heading("Masses")
        yield Table(("link", "before / kg", "after / kg", "change"), rows, frozenset((1, 2, 3)))


def _change(
    before: Mapping[str, float | None], after: Mapping[str, float | None], name: str
) -> str:
    a, b = before.get(name), after.get(name)
    if a is None or b is None or a == b:
        return ""
    return f"{100.0 * (b - a) / a:+.3g} %" if a else f"{b:+.6g} kg"


def _balance(old: Mechanics, new: Mechanics) -> Iterator[Block]:
    """Yield the shift of the centre of mass and of the gravity torques at zero."""
    before, after = _com(old), _com(new)
    held, now = _gravity_torques(old), _gravity_torques(new)
    rows = tuple(
        (name, number(held.get(name)), number(now.get(name)), _shift(held, now, name))
        for name in dict.fromkeys((*now, *held))
    )
    if before == after and held.keys() == now.keys() and not any(row[-1] for row in rows):
        return
    yield Heading("Balance at zero")
    if before is not None and after is not None:
        shift = f"{dist(before, after) * 1e3:.4g} mm"
        texts = (triple(before), triple(after))
        yield Paragraph(f"The centre of mass shifts by {shift}: {texts[0]} m to {texts[1]} m.")
    header = ("joint", "gravity before / N m, N", "after", "shift")
    yield Table(header, rows, frozenset((1, 2, 3)))


def _com(mechanics: Mechanics) -> tuple[float, ...] | None:
    if not mechanics.total_mass() > 0.0:
        return None
    return tuple(mechanics.center_of_mass([0.0] * mechanics.n_joints).tolist())


def _gravity_torques(mechanics: Mechanics) -> dict[str, float]:
    torques = mechanics.gravity_torque([0.0] * mechanics.n_joints)[-mechanics.n_joints :].tolist()
    return {name: round(t, 12) for name, t in zip(mechanics.joint_names, torques, strict=True)}


def _shift(old: Mapping[str, float], new: Mapping[str, float], name: str) -> str:
    if name not in old or name not in new:
        return ""
    is_same = isclose(old[name], new[name], rel_tol=1e-9, abs_tol=1e-9)
    return "" if is_same else f"{new[name] - old[name]:+.4g}"


def _findings(old: Analysis, new: Analysis) -> Iterator[Block]:
    yield Heading("Findings")
    # Matched by rule and message, wherever they moved to.
    before, after = ([f for f in a.findings if f.severity is not Severity.HINT] for a in (old, new))
    (come, kept), (gone, _) = _split(after, before), _split(before, after)
    yield Paragraph(f"{len(come)} new, {len(gone)} gone, {len(kept)} kept")
    lines_before, lines_after = LineIndex(old.text), LineIndex(new.text)
    for title, findings, lines in (
        ("New", come, lines_after),
        ("Gone", gone, lines_before),
        ("Kept", kept, lines_after),
    ):
        if findings:
            yield Heading(title, 3)
            rows = tuple((_place(lines, f), f.severity.value, f.code, f.message) for f in findings)
            yield Table(("place", "severity", "rule", "finding"), rows)


def _split(
    findings: Sequence[Diagnostic], others: Sequence[Diagnostic]
) -> tuple[list[Diagnostic], list[Diagnostic]]:
    """Return the findings that are not among others, and those that are."""
    left = Counter((f.code, f.message) for f in others)
    alone: list[Diagnostic] = []
    shared: list[Diagnostic] = []
    for finding in findings:
        key = finding.code, finding.message
        (shared if left[key] else alone).append(finding)
        left[key] -= bool(left[key])
    return alone, shared


def _place(lines: LineIndex, finding: Diagnostic) -> str:
    line, column = lines.place(finding.start)
    return f"{line}:{column}"
