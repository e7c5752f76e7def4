"""How often the cause of a wrong inertia is told rightly: `python benchmarks/inertia_causes.py`.

Rods, plates and boxes of foam to steel, along the axes, tilted or anyhow, are written with three to
six digits in two manners. One slip is planted in each, in a document of its own, and the fix that
is offered is applied: right if it gives the numbers that were meant. `--seed N` takes other bodies,
`--bodies N` another count, `--write` puts the table into the docs.
"""

import argparse
import random
import re
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from math import floor, log10
from pathlib import Path
from typing import NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tests.support.bodies import (
    Writer,
    body_of,
    document_of_bodies,
    inertia_text,
    random_rotation,
    short_decimals,
    significant,
    tilted_rotation,
)

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.text.edits import apply_edits
from kindsl.mechanics.rigid.body import MassDistribution, shifted

PAGE = Path(__file__).parents[1] / "docs" / "inertia_causes.md"
CAUSES = ("KD306", "KD307", "KD308", "KD310", "KD314")
LOOKED_AT = Settings(select=("KD3", "KD507"), ignore=("KD310",))
NUMBER = re.compile(r"(?:mass =|CoM = \(|, |I[xyz]+=)\s*(-?[\d.]+)")
Body = MassDistribution


class Kind(NamedTuple):
    """A slip: its name and how it is made; None where a body cannot show it."""

    name: str
    plant: Callable[[random.Random, Body], Body | None]


class Outcome(NamedTuple):
    """What was said of a body.

    Attributes:
        found: Whether it was found impossible or implausible.
        offered: Whether a fix was offered.
        right: Whether that fix gives the numbers that were meant.
        trips: Codes of errors and warnings that the fix leads into.
    """

    found: bool
    offered: bool
    right: bool
    trips: tuple[str, ...]


def random_body(generator: random.Random) -> Body:
    """Return a rod, a plate or a box, along the axes, tilted a little, or anyhow."""
    length = 10.0 ** generator.uniform(-1.0, 0.0)
    thin = generator.choice((0, 1, 2))
    thickness = [
        generator.uniform(0.02, 0.1) if n < thin else generator.uniform(0.15, 0.8) for n in range(2)
    ]
    sides = [length, length * thickness[0], length * thickness[1]]
    generator.shuffle(sides)
    mass = sides[0] * sides[1] * sides[2] * 10.0 ** generator.uniform(2.3, 3.9)
    com = [generator.gauss(0.0, 0.1) * length for _ in range(3)]
    com[sides.index(max(sides))] = length * generator.uniform(0.2, 0.6) * generator.choice((-1, 1))
    if generator.random() < 0.3:
        com = [c if side == max(sides) else 0.0 for c, side in zip(com, sides, strict=True)]
    lies = generator.random()
    turn = tilted_rotation(generator, 0.0 if lies < 0.4 else 0.25)
    if lies > 0.7:
        turn = random_rotation(generator)
    squares = [mass * side**2 / 12 for side in sides]
    spread = [
        [sum(turn[i][k] * turn[j][k] * squares[k] for k in range(3)) for j in range(3)]
        for i in range(3)
    ]
    return body_of(mass, com, spread)


def random_writer(generator: random.Random) -> Callable[[Body], Writer]:
    """Return a manner of writing: significant digits, or so many decimals for the whole body."""
    digits = generator.randint(3, 6)
    if generator.random() < 0.6:
        return lambda _: significant(digits)
    places = significant(digits)
    return lambda body: (
        lambda v: (
            short_decimals(max(1, digits - 1 - floor(log10(max(body.moments[:3])))))(v)
            if v in body.moments
            else places(v)
        )
    )


def about_com(_: random.Random, body: Body) -> Body | None:
    return shifted(body, -1.0) if any(body.com) else None


def with_signs(body: Body, chosen: Sequence[int]) -> Body | None:
    if not any(body.moments[i] for i in chosen):
        return None
    moments = tuple(-m if i in chosen else m for i, m in enumerate(body.moments))
    return body._replace(moments=moments)


def signs(_: random.Random, body: Body) -> Body | None:
    return with_signs(body, (3, 4, 5))


def com_and_signs(generator: random.Random, body: Body) -> Body | None:
    moved = about_com(generator, body)
    return with_signs(moved, (3, 4, 5)) if moved else None


def one_sign(generator: random.Random, body: Body) -> Body | None:
    return with_signs(body, (generator.choice((3, 4, 5)),))


def unit(factor: float) -> Callable[[random.Random, Body], Body]:
    return lambda _, body: body._replace(moments=tuple(m * factor for m in body.moments))


KINDS = (
    Kind("units: g·mm²", unit(1e9)),
    Kind("units: g·cm²", unit(1e7)),
    Kind("units: kg·mm²", unit(1e6)),
    Kind("units: kg·cm²", unit(1e4)),
    Kind("about the CoM", about_com),
    Kind("signs", signs),
    Kind("CoM and signs", com_and_signs),
    Kind("one sign", one_sign),
)


def numbers(text: str) -> list[float]:
    return [float(number) for number in NUMBER.findall(text[text.index("inertia_params") :])][:10]


def is_meant(text: str, body: Body) -> bool:
    """Return whether the text has the body's numbers: within 2 % of the largest of their kind."""
    meant = [body.mass, *body.com, *body.moments]
    told = numbers(text)
    sizes = [body.mass, *[max(map(abs, body.com)) or 1.0] * 3, *[max(map(abs, body.moments))] * 6]
    return all(abs(a - b) <= 0.02 * size for a, b, size in zip(told, meant, sizes, strict=True))


def outcome(body: Body, wrong: Body, write: Callable[[Body], Writer]) -> Outcome:
    text = document_of_bodies([inertia_text(wrong, write(wrong))])
    found = analyse(text, LOOKED_AT).findings
    fixes = [f.fix for f in found if f.code in CAUSES and f.fix is not None]
    is_found = any(f.severity in ("error", "warning") for f in found if f.code != "KD507")
    if not fixes:
        return Outcome(is_found, False, False, ())
    after = apply_edits(text, fixes[0].edits)
    rest = analyse(after, LOOKED_AT).findings
    meant = analyse(document_of_bodies([inertia_text(body, write(body))]), LOOKED_AT).findings
    known = {f.code for f in (*meant, *found)}
    trips = tuple(
        f.code for f in rest if f.severity in ("error", "warning") and f.code not in known
    )
    return Outcome(is_found, True, is_meant(after, body), trips)


def measure(kind: Kind, seed: str, bodies: int) -> list[Outcome]:
    generator = random.Random(f"{seed} {kind.name}")
    outcomes: list[Outcome] = []
    while len(outcomes) < bodies:
        body = random_body(generator)
        write = random_writer(generator)
        wrong = kind.plant(generator, body)
        if wrong is not None:
            outcomes.append(outcome(body, wrong, write))
    return outcomes


def row(name: str, outcomes: Sequence[Outcome]) -> str:
    """Return a row: bodies, found, fixes offered, of these right, codes that they lead into."""
    found = sum(o.found for o in outcomes)
    offered = sum(o.offered for o in outcomes)
    right = sum(o.right for o in outcomes)
    trips = Counter(code for o in outcomes for code in o.trips)
    told = ", ".join(f"{code} {count}" for code, count in trips.items()) or "-"
    return (
        f"| {name} | {found} | {offered} | {100 * offered / max(found, 1):.1f} % |"
        f" {100 * right / max(offered, 1):.1f} % | {told} |"
    )


def table(seed: str, bodies: int) -> Iterator[str]:
    """Yield the lines of the page."""
    yield "# Causes of impossible inertias\n"
    yield f"Each slip is planted in {bodies} rods, plates and boxes, written with three to six"
    yield "digits; `python benchmarks/inertia_causes.py --write` makes this table. A fix is offered"
    yield "only where one cause is left, and right if it gives the numbers that were meant. Of"
    yield "moments about the CoM the signs can often not be told: then both readings are listed."
    yield "A light body's true moments may be so small that robcogen2 treats them as zero: then"
    yield "KD507 says so of right numbers too. All mistakes: [Planted](seeded_defects.md).\n"
    yield "| slip | found | fix offered | share | of these right | leads into |"
    yield "|---|---|---|---|---|---|"
    total: list[Outcome] = []
    for kind in KINDS:
        outcomes = measure(kind, seed, bodies)
        total += outcomes
        yield row(kind.name, outcomes)
    yield row("all", total)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--seed", default="2018")
    parser.add_argument("--bodies", type=int, default=150)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    lines = []
    for line in table(options.seed, options.bodies):
        print(line, flush=True)
        lines.append(line)
    if options.write:
        PAGE.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
