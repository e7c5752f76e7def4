"""How many slips planted in limbs are found: `python benchmarks/planted_slips.py [FOLDER ...]`.

Each slip is made in the text of a whole robot, in a joint or a body of a limb that agreed with its
twins before. Robots are those of `published.py`, and of the folders given. `--write` puts the table
into the docs, `--honest` lists what is reported of the robots as they are, `--wrong` the slips that
are not, `--seed N` and `--number N` choose other slips and how many of each kind, `--half 0` and
`--half 1` take one half of the robots: rules are tuned on the first half only.
"""

import argparse
import random
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from itertools import chain
from math import degrees, dist, pi
from pathlib import Path
from typing import NamedTuple

from published import published

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.language.semantics.declarations import Vector
from kindsl.language.semantics.kinematic_tree import Edge
from kindsl.language.semantics.numbers import mass_distribution, written_pose
from kindsl.language.semantics.places import Located, Place
from kindsl.language.text.edits import TextEdit, apply_edits
from kindsl.robots.limbs.comparison import LimbComparison
from kindsl.robots.limbs.limb import limbs_of, matched
from kindsl.robots.limbs.mirrored import PairOfLimbs, pairs_of
from kindsl.robots.limbs.names import label_of

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "seeded_defects.md"
HEADING = "## Slips in limbs\n"
CODES = ("KD208", "KD209", "KD210", "KD312", "KD313", "KD509", "KD510", "KD511")
MECHANICS = 1e-6


class Robot(NamedTuple):
    """A robot, and the links of its limbs that agree with their twins.

    Attributes:
        name: Of its file.
        analysis: Of its text.
        limbs: Names of links by how many twins they have: `three` or `pair`.
    """

    name: str
    analysis: Analysis
    limbs: dict[str, list[str]]


class Planted(NamedTuple):
    """A slip: the new text, and the names of the links that it concerns."""

    text: str
    links: tuple[str, ...]


Plant = Callable[[random.Random, Analysis, Edge], Planted | None]


def edited(analysis: Analysis, *changes: tuple[Located, str]) -> str:
    edits = (TextEdit(*analysis.resolver.span(at), text) for at, text in changes)
    return apply_edits(analysis.text, sorted(edits))


def vector_slip(vectors: Sequence[str], change: Callable[..., dict[int, str] | None]) -> Plant:
    """Return a slip that changes some of three components."""

    def plant(generator: random.Random, analysis: Analysis, edge: Edge) -> Planted | None:
        vector = _vector(edge, generator.choice(vectors))
        changed = change(generator, [e.text for e in vector.components]) if vector else None
        if not changed or vector is None:
            return None
        changes = ((vector.components[i], text) for i, text in changed.items())
        return Planted(edited(analysis, *changes), (str(edge.child.link),))

    return plant


def _vector(edge: Edge, what: str) -> Vector | None:
    if what == "com":
        return edge.link.inertia.com if edge.link and edge.link.inertia else None
    return getattr(edge.joint.pose, what) if edge.joint else None


def _one(generator: random.Random, texts: Sequence[str]) -> int | None:
    chosen = [i for i, text in enumerate(texts) if not _is_number(text) or abs(float(text)) > 1e-3]
    return generator.choice(chosen) if chosen else None


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def sign(generator: random.Random, texts: Sequence[str]) -> dict[int, str] | None:
    i = _one(generator, texts)
    return None if i is None else {i: texts[i][1:] if texts[i][0] == "-" else f"-{texts[i]}"}


def zeroed(generator: random.Random, texts: Sequence[str]) -> dict[int, str] | None:
    i = _one(generator, texts)
    return None if i is None else {i: "0.0"}


def swapped(generator: random.Random, texts: Sequence[str]) -> dict[int, str] | None:
    i, j = generator.sample(range(3), 2)
    return {i: texts[j], j: texts[i]}


def power_of_ten(generator: random.Random, texts: Sequence[str]) -> dict[int, str] | None:
    return _of_number(generator, texts, lambda x: f"{x * generator.choice((10, 0.1, 1000)):.9g}")


def digit(generator: random.Random, texts: Sequence[str]) -> dict[int, str] | None:
    def change(_: float) -> str:
        at = generator.choice([i for i, c in enumerate(texts[chosen]) if c in "123456789"][:3])
        others = [d for d in "123456789" if d != texts[chosen][at]]
        return texts[chosen][:at] + generator.choice(others) + texts[chosen][at + 1 :]

    chosen = generator.randrange(3)
    if not _is_number(texts[chosen]) or abs(float(texts[chosen])) <= 1e-3:
        return None
    return {chosen: change(0.0)}


def in_degrees(generator: random.Random, texts: Sequence[str]) -> dict[int, str] | None:
    # With fewer decimals nothing could restore a robot to 1e-6.
    return _of_number(generator, texts, lambda x: f"{degrees(x):.6f}")


def quarter_turn(generator: random.Random, texts: Sequence[str]) -> dict[int, str] | None:
    i = generator.randrange(3)
    turn = generator.choice((1, -1)) * pi / 2
    return {i: f"{float(texts[i]) + turn:.6f}"} if _is_number(texts[i]) else None


def _of_number(
    generator: random.Random, texts: Sequence[str], made: Callable[[float], str]
) -> dict[int, str] | None:
    i = _one(generator, texts)
    if i is None or not _is_number(texts[i]):
        return None
    text = made(float(texts[i]))
    return {i: text if "." in text or "e" in text else f"{text}.0"}


def wrong_parent(generator: random.Random, analysis: Analysis, edge: Edge) -> Planted | None:
    """Move a pair of link and joint to the body that carries a twin."""
    twins = [e for e in _twins(analysis, edge) if e.predecessor is not edge.predecessor]
    if not twins:
        return None
    child = generator.choice(twins).child
    entry = f"{edge.child.link} via {edge.child.joint}"
    changes = ((edge.child, ""), (child, f"{child.link} via {child.joint} {entry}"))
    return Planted(edited(analysis, *changes), (str(edge.child.link),))


def other_parent(generator: random.Random, analysis: Analysis, edge: Edge) -> Planted | None:
    """Move a pair of link and joint to any other body that it does not carry."""
    tree = analysis.model.tree
    carried = [edge.link]
    for link in carried:
        carried += [e.link for e in tree.successor_edges(link)] if link is not None else []
    others = [e for e in tree.edges if e.predecessor not in (*carried, edge.predecessor)]
    if not others:
        return None
    child = generator.choice(others).child
    entry = f"{edge.child.link} via {edge.child.joint}"
    changes = ((edge.child, ""), (child, f"{child.link} via {child.joint} {entry}"))
    return Planted(edited(analysis, *changes), (str(edge.child.link),))


def exchanged(generator: random.Random, analysis: Analysis, edge: Edge) -> Planted | None:
    """Exchange the joints of a link and of what it carries, or of its twin."""
    edges = analysis.model.tree.successor_edges(edge.link) if edge.link else []
    others = [e for e in (*edges, *_twins(analysis, edge)) if e.joint is not None]
    if not others:
        return None
    other = generator.choice(others)
    changes = (
        (edge.child.joint, str(other.child.joint)),
        (other.child.joint, str(edge.child.joint)),
    )
    return Planted(edited(analysis, *changes), (str(edge.child.link), str(other.child.link)))


def other_kind(_: random.Random, analysis: Analysis, edge: Edge) -> Planted | None:
    if edge.joint is None:
        return None
    word = next(edge.joint.node.tokens())
    at = Place(edge.joint.island, word.start, word.start + 1)
    text = edited(analysis, (at, "p" if edge.joint.kind == "revolute" else "r"))
    return Planted(text, (str(edge.child.link),))


def inertia_copied(generator: random.Random, analysis: Analysis, edge: Edge) -> Planted | None:
    """Write the inertia of what a link carries in place of its own."""
    below = analysis.model.tree.successor_edges(edge.link) if edge.link else []
    others = [e.link.inertia for e in below if e.link and e.link.inertia]
    if edge.link is None or edge.link.inertia is None or not others:
        return None
    other = generator.choice(others)
    text = other.island.text[other.start : other.end]
    return Planted(edited(analysis, (edge.link.inertia, text)), (str(edge.child.link),))


def copied_unmirrored(generator: random.Random, analysis: Analysis, edge: Edge) -> Planted | None:
    """Write the joints, and mostly the bodies, of a left limb for those of the right one."""
    carried = limbs_of(analysis.model, {}).values()
    pairs = pairs_of(carried, {})
    for limbs in chain(*carried):
        heads = dict(limbs.heads)
        for one, other in (sorted(p[:2], key=repr) for p in limbs.pairs() if p[2] == "LR"):
            rows = matched(heads[one], heads[other]) or ()
            names = [[body.name for body in side] for _, *side in rows]
            others = [p for p in pairs if [p.left.name, p.right.name] != names[0]] if rows else []
            if len(rows) > 1 and edge.child.link in chain(*names) and _is_usual(others):
                changes = list(_copies(analysis, names, generator.randrange(3)))
                return Planted(edited(analysis, *changes), tuple(chain(*names)))
    return None


def _is_usual(others: Sequence[PairOfLimbs]) -> bool:
    """Return whether the other limbs of a robot are mirrored."""
    return any(p.is_mirrored for p in others) and not any(p.is_copied for p in others)


def _copies(
    analysis: Analysis, names: Sequence[Sequence[str]], how: int
) -> Iterator[tuple[Located, str]]:
    """Yield what writes one limb for another but for where the head is, and how it is turned."""
    for row, both in enumerate(names):
        here, there = (analysis.model.tree.above[analysis.model.body_named[n]][0] for n in both)
        for what in ("translation", "rotation"):
            if row or (what == "rotation" and how == 0):
                old, new = _vector(there, what), _vector(here, what)
                pairs = zip(old.components, new.components, strict=True) if old and new else ()
                yield from ((place, meant.text) for place, meant in pairs)
        bodies = [e.link.inertia for e in (here, there) if e.link and e.link.inertia]
        if len(bodies) == 2 and how < 2:
            yield bodies[1], bodies[0].island.text[bodies[0].start : bodies[0].end]


def _twins(analysis: Analysis, edge: Edge) -> list[Edge]:
    words = label_of(str(edge.child.link)).words
    edges = analysis.model.tree.edges
    return [e for e in edges if e is not edge and label_of(str(e.child.link)).words == words]


BOTH = ("translation", "rotation")
KINDS: dict[str, Plant] = {
    "sign": vector_slip(BOTH, sign),
    "zeroed": vector_slip(BOTH, zeroed),
    "two components swapped": vector_slip(BOTH, swapped),
    "power of ten": vector_slip(("translation",), power_of_ten),
    "one digit": vector_slip(BOTH, digit),
    "angle in degrees": vector_slip(("rotation",), in_degrees),
    "quarter turn": vector_slip(("rotation",), quarter_turn),
    "wrong parent": wrong_parent,
    "any other parent": other_parent,
    "two joints exchanged": exchanged,
    "other kind of joint": other_kind,
    "sign of the CoM": vector_slip(("com",), sign),
    "inertia copied": inertia_copied,
    "limb copied unmirrored": copied_unmirrored,
}
NUMBERS_OF_JOINTS = frozenset(list(KINDS)[:7])


def robots(folders: Sequence[Path], half: int | None) -> Iterator[Robot]:
    """Yield the robots of others with what agrees in their limbs."""
    for each in published(folders, half):
        if each.analysis.model.base is not None:
            yield Robot(each.name, each.analysis, agreeing(each.analysis))


def agreeing(analysis: Analysis) -> dict[str, list[str]]:
    """Return the links of limbs that agree with two twins or more, and with the other side's."""
    model, values = analysis.model, analysis.context.values
    found: dict[str, set[str]] = {"three": set(), "pair": set()}
    for groups in limbs_of(model, values).values():
        for limbs in groups:
            alike: dict[object, list[tuple[str, list[str]]]] = {}
            heads = dict(limbs.heads)
            for one, other, how in limbs.pairs():
                rows = matched(heads[one], heads[other])
                if rows is not None and any(
                    r.slip is None for r in LimbComparison(rows, how).readings()
                ):
                    alike.setdefault(one, []).append((how, [row.one.name for row in rows]))
                    alike.setdefault(other, []).append((how, [row.other.name for row in rows]))
            for pairs in alike.values():
                for how, names in pairs:
                    if len(pairs) > 1 or how == "LR":
                        found["three" if len(pairs) > 1 else "pair"].update(names)
    return {kind: sorted(names) for kind, names in found.items()}


def mechanics(analysis: Analysis) -> list[tuple[object, list[float]]]:
    """Return what a robot is: its tree and its numbers, each link by itself."""
    model, values = analysis.model, analysis.context.values
    found: list[tuple[object, list[float]]] = []
    for edge in model.tree.edges:
        pose = written_pose(edge.joint.pose, values) if edge.joint else None
        inertia = edge.link.inertia if edge.link else None
        body = mass_distribution(inertia, values) if inertia else None
        numbers = [x for row in pose.rotation for x in row] + [*pose.translation] if pose else []
        numbers += [body.mass, *body.com, *body.moments] if body else []
        names = str(edge.child.link), str(edge.predecessor.name)
        found.append(((*names, edge.joint.kind if edge.joint else ""), numbers))
    return sorted(found, key=lambda each: str(each[0]))


def is_same(one: Analysis, other: Analysis) -> bool:
    here, there = mechanics(one), mechanics(other)
    return [names for names, _ in here] == [names for names, _ in there] and all(
        len(a) == len(b) and dist(a, b) <= MECHANICS
        for (_, a), (_, b) in zip(here, there, strict=True)
    )


class Outcome(NamedTuple):
    """What comes of a slip.

    Attributes:
        codes: Of what is reported besides, in its place.
        is_elsewhere: Whether something is reported, and nothing in its place.
        has_fix: Whether a fix is offered, or several to choose from.
        is_right: Whether one of them restores the robot.
    """

    codes: tuple[str, ...]
    is_elsewhere: bool
    has_fix: bool
    is_right: bool


def outcome(robot: Robot, planted: Planted) -> Outcome:
    analysis = analyse(planted.text)
    before = {f.message for f in robot.analysis.findings}
    new = [f for f in analysis.findings if f.message not in before]
    new = [f for f in new if f.severity in ("error", "warning")]
    spans = list(_spans(analysis, planted.links))
    first = [f for f in new if any(a <= f.start < b for a, b in spans)]
    in_place = [f for f in new if f in first or _is_related(f, spans)]
    fixes = [fix for f in in_place for fix in (f.fix, *f.choices) if fix is not None]
    mended = (analyse(apply_edits(planted.text, fix.edits)) for fix in fixes)
    return Outcome(
        tuple(f.code for f in in_place),
        bool(new) and not in_place,
        bool(fixes),
        any(is_same(each, robot.analysis) for each in mended),
    )


def _is_related(finding: Diagnostic, spans: Sequence[tuple[int, int]]) -> bool:
    is_pair = finding.code == "KD510" or finding.choices or finding.code in ("KD208", "KD209")
    related = (r for r in finding.related if is_pair or r.message.startswith("or "))
    starts = [each.start for each in related]
    return any(a <= start < b for a, b in spans for start in starts)


def _spans(analysis: Analysis, links: Sequence[str]) -> Iterator[tuple[int, int]]:
    for edge in analysis.model.tree.edges:
        if edge.child.link in links:
            yield analysis.resolver.span(edge.child)
            yield from (analysis.resolver.span(each) for each in (edge.joint, edge.link) if each)


def measure(
    pool: Sequence[Robot], twins: str, kind: str, number: int, seed: int, show: bool = False
) -> list[Outcome]:
    """Plant a kind of slip so often, and tell what came of it."""
    generator = random.Random(f"{seed} {twins} {kind}")
    fitting = [robot for robot in pool if robot.limbs[twins]]
    outcomes: list[Outcome] = []
    for _ in range(20 * number):
        if not fitting or len(outcomes) == number:
            break
        robot = generator.choice(fitting)
        name = generator.choice(robot.limbs[twins])
        edge = robot.analysis.model.tree.above[robot.analysis.model.body_named[name]][0]
        planted = KINDS[kind](generator, robot.analysis, edge)
        if planted and not is_same(analyse(planted.text), robot.analysis):
            outcomes.append(outcome(robot, planted))
            if show and not outcomes[-1].codes:
                print(f"--- {kind}: {robot.name} {', '.join(planted.links)}")
    return outcomes


def table(pool: Sequence[Robot], number: int, seed: int, show: bool = False) -> str:
    head = ("slip", "twins", "planted", "in place", "elsewhere only", "fix", "fix right", "codes")
    lines = [f"| {' | '.join(head)} |", "|---" * len(head) + "|"]
    print(lines[0])
    for twins in ("three", "pair"):
        total: list[Outcome] = []
        for kind in KINDS:
            outcomes = measure(pool, twins, kind, number, seed, show)
            total += outcomes if kind in NUMBERS_OF_JOINTS else []
            lines.append(_row(kind, twins, outcomes))
            print(lines[-1], flush=True)
        lines.append(_row("*all numbers of joints*", twins, total))
        print(lines[-1], flush=True)
    return "\n".join(lines) + "\n"


def _row(kind: str, twins: str, outcomes: Sequence[Outcome]) -> str:
    codes = Counter(code for each in outcomes for code in each.codes).most_common(3)
    numbers = (
        len(outcomes),
        sum(bool(each.codes) for each in outcomes),
        sum(each.is_elsewhere for each in outcomes),
        sum(each.has_fix for each in outcomes),
        sum(each.is_right for each in outcomes),
    )
    told = ", ".join(f"{code} {count}" for code, count in codes)
    return f"| {kind} | {twins} | {' | '.join(map(str, numbers))} | {told} |"


def main() -> None:
    run(__doc__ or "", CODES, table, HEADING, INTRODUCTION)


def run(
    about: str,
    codes: tuple[str, ...],
    tabled: Callable[[Sequence[Robot], int, int, bool], str],
    heading: str,
    introduction: str,
) -> None:
    """Plant slips as the command line says, or list what has these codes in honest robots."""
    parser = argparse.ArgumentParser(
        description=about, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folders", nargs="*", type=Path)
    parser.add_argument("--number", type=int, default=40)
    parser.add_argument("--seed", type=int, default=2018)
    parser.add_argument("--half", type=int)
    for option in ("--honest", "--wrong", "--write"):
        parser.add_argument(option, action="store_true")
    given = parser.parse_args()
    pool = list(robots(given.folders, given.half))
    if given.honest:
        for robot in pool:
            for finding in robot.analysis.findings:
                if finding.code.startswith(codes):
                    print(f"{robot.name}: {finding.code} {finding.message}")
        print(f"{len(pool)} robots")
        return
    text = tabled(pool, given.number, given.seed, given.wrong)
    if given.write:
        write_section(heading, f"{introduction}\n{text}")


def write_section(heading: str, text: str) -> None:
    """Put a section in the place of the one that the page has."""
    before, _, rest = PAGE.read_text("utf-8").partition(heading)
    after = "".join(rest.partition("\n## ")[1:])
    PAGE.write_text(f"{before}{heading}\n{text}{after}", encoding="utf-8")


INTRODUCTION = """\
Each slip is made in the text of a whole robot, in a limb that agreed with its twins before: with
two or more (`three`), or with the one on the other side (`pair`). A slip that changes nothing, such
as the sign of a half turn, is none. `in place` counts findings at the joint, link or pair of the
slip, of pairs at either side; `fix right` counts fixes, or one of two choices, that restore the
robot. The robots are some that the rules were not tuned on, among them converted URDF files:
`python benchmarks/planted_slips.py --half 1 --number 20 --seed 7 --write FOLDER` makes the table,
of the examples, the published models and what is in a folder.
"""

if __name__ == "__main__":
    main()
