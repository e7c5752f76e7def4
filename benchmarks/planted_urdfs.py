"""The same slips in a document and in a URDF: `python benchmarks/planted_urdfs.py [FOLDER ...]`.

Each kind of slip is made in the same link of a robot, in the text of its document and in that of
the URDF which it was converted from. The numbers are those that stand there, so that a centre of
mass is wrong beside moments about it in the one, and about the origin in the other. Kinds and
options are those of `planted_bodies.py` and `planted_slips.py`; `--wrong` lists the slips that only
one of the two tells.
"""

import argparse
import random
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from math import dist
from pathlib import Path
from typing import Any, NamedTuple

import planted_bodies
import planted_slips
from planted_bodies import Body, decimal, is_near, ten
from planted_slips import edited
from published import Published, published

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.rules.xml_bodies import xml_bodies
from kindsl.language.semantics.declarations import Joint, Link
from kindsl.language.semantics.numbers import mass_distribution
from kindsl.language.semantics.places import Place
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.edits import apply_edits
from kindsl.mechanics.rigid.body import shifted
from kindsl.robots.limbs.names import label_of

SAME = 1e-4


class Moved(NamedTuple):
    """A link that a joint of a URDF moves.

    Attributes:
        name: Of the link.
        link: The link.
        joint: The joint.
        parent: The name of the link that it is attached to.
    """

    name: str
    link: Link
    joint: Joint
    parent: str


class Pair(NamedTuple):
    """A robot as its document and as its URDF.

    Attributes:
        robot: The robot.
        urdf: Of its URDF.
        moved: The links of the URDF that move and are in the document, by name.
    """

    robot: Published
    urdf: Analysis
    moved: dict[str, Moved]


class Told(NamedTuple):
    """What comes of one slip in one text.

    Attributes:
        told: Whether something is told at the link or joint.
        fix: Whether a fix is offered, or several to choose from.
        is_right: Whether one of them restores the robot.
        is_exact: Whether it restores the text, to the byte.
        elsewhere: Whether something is reported elsewhere alone.
        codes: Of what is told.
    """

    told: bool
    fix: bool
    is_right: bool
    is_exact: bool
    elsewhere: bool
    codes: tuple[str, ...]


Planted = tuple[tuple[str, ...], str]
Plant = Callable[[random.Random, Analysis, Mapping[str, Moved], Moved], Planted | None]


def pairs(folders: Sequence[Path], half: int | None) -> list[Pair]:
    """Return the robots of URDFs that are read both ways."""
    found = []
    for robot in published(folders, half, urdf_only=True):
        urdf, tree = robot.in_place, robot.analysis.model
        if urdf is None:
            continue
        there = {str(b.name) for b in tree.bodies if tree.tree.above.get(b)}
        moved = {m.name: m for m in moved_links(urdf) if m.name in there}
        if moved:
            found.append(Pair(robot, urdf, moved))
    return found


def moved_links(urdf: Analysis) -> Iterator[Moved]:
    """Yield the links that joints move."""
    document: Any = urdf.model.document
    links = {str(link.name): link for link in urdf.model.links}
    for each in document.connections:
        if not each.is_fixed and each.child in links:
            yield Moved(each.child, links[each.child], each.joint, each.parent)


def body_of(link: Link) -> Body | None:
    """Return ten numbers as a URDF has them: moments about the CoM, signs as in a document."""
    written = mass_distribution(link.inertia, {}) if link.inertia is not None else None
    com = link.frames[0].pose.translation if link.frames else None
    if written is None or com is None or written.mass <= 0.0 or not any(written.moments[:3]):
        return None
    x, y, z = (component.literal or 0.0 for component in com.components)
    return written._replace(com=(x, y, z))


def with_body(urdf: Analysis, link: Link, old: Body, new: Body) -> str | None:
    """Return a URDF with the numbers written that a slip has changed, None where one is implied."""
    inertia, com = link.inertia, link.frames[0].pose.translation
    assert inertia is not None and inertia.mass is not None and com is not None
    places = [inertia.mass, *com.components, *(inertia.moments[name] for name in MOMENTS)]
    if len({(at.start, at.end) for at in places}) < len(places):
        return None
    negated: Any = link.island
    changes = []
    for at, a, b in zip(places, ten(old), ten(new), strict=True):
        if a != b:
            changes.append((at, decimal(-b if at.start in negated.negated else b)))
    return edited(urdf, *changes)


def _about_origin_and_signs(_: random.Random, body: Body, __: Sequence[Body]) -> Body:
    ix, iy, iz, *products = shifted(body).moments
    return body._replace(moments=(ix, iy, iz, *(-p for p in products)))


def _unit_about_origin(generator: random.Random, body: Body, others: Sequence[Body]) -> Body | None:
    return planted_bodies.scaled(1e9, 1e7, 1e6, 1e4)(generator, shifted(body), others)


# Slips that a URDF has the other way round; twice about a point there is none.
OF_URDF: dict[str, planted_bodies.Plant | None] = {
    "moments about the CoM": planted_bodies.moved(1.0),
    "moments about the CoM, signs": _about_origin_and_signs,
    "unit, about the CoM": _unit_about_origin,
    "moments shifted twice": None,
    "moments in row-major order": None,
}


def in_vector(vectors: Sequence[str], change: Callable[..., dict[int, str] | None]) -> Plant:
    """Return a slip that changes some of three components."""

    def plant(
        generator: random.Random, urdf: Analysis, _: Mapping[str, Moved], at: Moved
    ) -> Planted | None:
        what = generator.choice(vectors)
        frame = next(iter(at.link.frames), None)
        pose = at.joint.pose if what != "com" else frame.pose if frame is not None else None
        vector = getattr(pose, "translation" if what == "com" else what, None)
        places = vector.components if vector is not None else ()
        if len({(e.start, e.end) for e in places}) < 3:
            return None
        changed = change(generator, [e.island.text[e.start : e.end] for e in places])
        if not changed:
            return None
        return (at.name,), edited(urdf, *((places[i], text) for i, text in changed.items()))

    return plant


def _reference(at: Moved, end: str) -> Place:
    island: Any = at.joint.island
    place: Place = island.reference(end)
    return place


def wrong_parent(
    generator: random.Random, urdf: Analysis, moved: Mapping[str, Moved], at: Moved
) -> Planted | None:
    parents = sorted({m.parent for m in _twins(moved, at)} - {at.parent})
    if not parents:
        return None
    return (at.name,), edited(urdf, (_reference(at, "parent"), generator.choice(parents)))


def other_parent(
    generator: random.Random, urdf: Analysis, moved: Mapping[str, Moved], at: Moved
) -> Planted | None:
    below = {at.name}
    for _ in moved:
        below |= {m.name for m in moved.values() if m.parent in below}
    parents = sorted({m.parent for m in moved.values()} - below - {at.parent})
    if not parents:
        return None
    return (at.name,), edited(urdf, (_reference(at, "parent"), generator.choice(parents)))


def other_kind(
    _: random.Random, urdf: Analysis, __: Mapping[str, Moved], at: Moved
) -> Planted | None:
    island: Any = at.joint.island
    kind = "revolute" if at.joint.kind == "prismatic" else "prismatic"
    return (at.name,), edited(urdf, (island.place(island.element, "type"), kind))


def inertia_copied(
    generator: random.Random, urdf: Analysis, moved: Mapping[str, Moved], at: Moved
) -> Planted | None:
    below = [m.link.inertia for m in moved.values() if m.parent == at.name and m.link.inertia]
    if at.link.inertia is None or not below:
        return None
    other = generator.choice(below)
    return (at.name,), edited(urdf, (at.link.inertia, other.island.text[other.start : other.end]))


def _twins(moved: Mapping[str, Moved], at: Moved) -> list[Moved]:
    words = label_of(at.name).words
    return [m for m in moved.values() if m is not at and label_of(m.name).words == words]


LIMBS: dict[str, Plant] = {
    "sign": in_vector(planted_slips.BOTH, planted_slips.sign),
    "zeroed": in_vector(planted_slips.BOTH, planted_slips.zeroed),
    "two components swapped": in_vector(planted_slips.BOTH, planted_slips.swapped),
    "power of ten": in_vector(("translation",), planted_slips.power_of_ten),
    "one digit": in_vector(planted_slips.BOTH, planted_slips.digit),
    "angle in degrees": in_vector(("rotation",), planted_slips.in_degrees),
    "quarter turn": in_vector(("rotation",), planted_slips.quarter_turn),
    "wrong parent": wrong_parent,
    "any other parent": other_parent,
    "other kind of joint": other_kind,
    "sign of the CoM": in_vector(("com",), planted_slips.sign),
    "inertia copied": inertia_copied,
}


def mechanics(urdf: Analysis) -> list[tuple[str, list[float]]]:
    """Return what a robot is: its bodies, who carries them, where, and how heavy they are."""
    bodies, found = xml_bodies(urdf.model), []
    for body in bodies:
        parent = "" if body.parent is None else str(bodies[body.parent].link.name)
        kind = body.joint.kind if body.joint is not None else ""
        numbers = [x for row in body.placement.rotation for x in row]
        numbers += body.placement.translation
        if body.mass is not None:
            numbers += [body.mass.mass, *body.mass.com, *body.mass.moments]
        found.append((f"{body.link.name} {parent} {kind}", numbers))
    return sorted(found, key=lambda each: each[0])


def is_same(one: Analysis, other: Analysis) -> bool:
    here, there = mechanics(one), mechanics(other)
    return [name for name, _ in here] == [name for name, _ in there] and all(
        len(a) == len(b) and dist(a, b) <= SAME for (_, a), (_, b) in zip(here, there, strict=True)
    )


def has_body(analysis: Analysis, name: str, meant: Body) -> bool:
    """Return whether a link has the ten numbers that were meant."""
    link = next((m.link for m in moved_links(analysis) if m.name == name), None)
    body = body_of(link) if link is not None else None
    return body is not None and is_near(body, meant)


def told(
    before: Analysis, links: Sequence[str], text: str, is_meant: Callable[[Analysis], bool]
) -> Told:
    """Return what is told of a URDF with a slip, besides what was told before."""
    analysis = analyse(text)
    known = {f.message for f in before.findings}
    new = [f for f in analysis.findings if f.message not in known and f.severity != "hint"]
    # One sentence for all densities names others once there is one more.
    new = [f for f in new if "more links have an implausible density" not in f.message]
    spans = []
    for at in moved_links(analysis):
        if at.name in links:
            spans += [analysis.resolver.span(at.joint), analysis.resolver.span(at.link)]

    def is_there(start: int) -> bool:
        return any(a <= start < b for a, b in spans)

    here = [
        f
        for f in new
        if is_there(f.start) or (f.code in PAIRS and any(is_there(r.start) for r in f.related))
    ]
    fixes = [fix for f in here for fix in (f.fix, *f.choices) if fix is not None]
    mended = [analyse(apply_edits(text, fix.edits)) for fix in fixes]
    return Told(
        bool(here),
        bool(fixes),
        any(map(is_meant, mended)),
        any(each.text == before.text for each in mended),
        any(f.severity in ("error", "warning") for f in new if f not in here) and not here,
        tuple(f.code for f in here),
    )


PAIRS = ("KD208", "KD209", "KD210", "KD312", "KD509", "KD510")


def of_bodies(
    pool: Sequence[Pair], kind: str, number: int, seed: int
) -> Iterator[tuple[str, Told, Told]]:
    """Yield what comes of a slip in inertias, in the document and in the URDF."""
    generator = random.Random(f"{seed} {kind}")
    plant, words = planted_bodies.KINDS[kind]
    in_urdf = OF_URDF.get(kind, plant)
    n_planted = 0
    for _ in range(20 * number if in_urdf is not None else 0):
        pair = generator.choice(pool)
        documents = {
            str(link.name): (link, *rest)
            for link, *rest in planted_bodies.bodies(pair.robot.analysis)
        }
        known = {n: b for n, m in pair.moved.items() if n in documents and (b := body_of(m.link))}
        if n_planted == number or not known:
            continue
        name, chance = generator.choice(sorted(known)), generator.random()
        link, inertia, meant = documents[name]
        own = known[name]
        wrong = plant(
            random.Random(chance), meant, [b for n, (*_, b) in documents.items() if n != name]
        )
        other = in_urdf(random.Random(chance), own, [b for n, b in known.items() if n != name])
        if wrong is None or other is None or _is_small(wrong, meant) or _is_small(other, own):
            continue
        text = with_body(pair.urdf, pair.moved[name].link, own, other)
        if text is None:
            continue
        n_planted += 1
        analysis = pair.robot.analysis
        of_text = planted_bodies.planted(analysis, inertia, meant, wrong)
        robot = planted_slips.Robot(pair.robot.name, analysis, {})
        found = planted_bodies.outcome(robot, link, of_text, meant, words)
        here = Told(bool(found.codes), found.has_fix, found.is_right, False, False, found.codes)
        is_meant = partial(has_body, name=name, meant=own)
        yield f"{pair.robot.name} {name}", here, told(pair.urdf, (name,), text, is_meant)


def _is_small(wrong: Body, meant: Body) -> bool:
    return is_near(wrong, meant, planted_bodies.SIGNIFICANT)


def of_limbs(
    pool: Sequence[Pair], kind: str, number: int, seed: int
) -> Iterator[tuple[str, Told, Told]]:
    """Yield what comes of a slip in limbs that agree with their twins."""
    generator = random.Random(f"{seed} {kind}")
    limbs = []
    for pair in pool:
        agreeing = planted_slips.agreeing(pair.robot.analysis)
        names = sorted({n for names in agreeing.values() for n in names} & set(pair.moved))
        limbs += [(pair, names)] if names else []
    n_planted = 0
    for _ in range(20 * number if limbs else 0):
        if n_planted == number:
            break
        pair, names = generator.choice(limbs)
        name, chance = generator.choice(names), generator.random()
        analysis = pair.robot.analysis
        edge = analysis.model.tree.above[analysis.model.body_named[name]][0]
        there = planted_slips.KINDS[kind](random.Random(chance), analysis, edge)
        here = LIMBS[kind](random.Random(chance), pair.urdf, pair.moved, pair.moved[name])
        if there is None or here is None or is_same(analyse(here[1]), pair.urdf):
            continue
        if planted_slips.is_same(analyse(there.text), analysis):
            continue
        n_planted += 1
        found = planted_slips.outcome(planted_slips.Robot(name, analysis, {}), there)
        in_text = Told(
            *(bool(found.codes), found.has_fix, found.is_right, False, found.is_elsewhere),
            found.codes,
        )
        yield (
            f"{pair.robot.name} {name}",
            in_text,
            told(pair.urdf, *here, partial(is_same, pair.urdf)),
        )


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folders", nargs="*", type=Path)
    parser.add_argument("--number", type=int, default=20)
    parser.add_argument("--seed", type=int, default=2018)
    parser.add_argument("--half", type=int)
    parser.add_argument("--wrong", action="store_true")
    given = parser.parse_args()
    pool = pairs(given.folders, given.half)
    head = "| slip | planted | told as text | in place | fix as text | in place "
    head += "| right as text | in place | exact | elsewhere only | codes |"
    print(f"{len(pool)} robots\n{head}\n{'|---' * 11}|")
    for kinds, measured in ((planted_bodies.KINDS, of_bodies), (LIMBS, of_limbs)):
        every: list[tuple[str, Told, Told]] = []
        for kind in kinds:
            found = list(measured(pool, kind, given.number, given.seed))
            every += found
            if found:
                print(_row(kind, found), flush=True)
            for where, here, there in found if given.wrong else ():
                if here.told != there.told:
                    print(f"    {'document' if here.told else 'URDF'} only: {where}")
        print(_row("*all*", every), flush=True)


def _row(kind: str, found: Sequence[tuple[str, Told, Told]]) -> str:
    numbers = [len(found)]
    for what in ("told", "fix", "is_right"):
        numbers += [sum(getattr(each[i], what) for each in found) for i in (1, 2)]
    numbers += [sum(each[2].is_exact for each in found), sum(each[2].elsewhere for each in found)]
    codes = Counter(code for *_, there in found for code in there.codes).most_common(3)
    return (
        f"| {kind} | {' | '.join(map(str, numbers))} | {', '.join(f'{c} {n}' for c, n in codes)} |"
    )


if __name__ == "__main__":
    main()
