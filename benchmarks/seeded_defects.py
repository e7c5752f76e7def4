"""How many planted mistakes are found, and named rightly: `python benchmarks/seeded_defects.py`.

Each of 1,000 possible bodies is the link of a small robot. It is a box of the density of hollow
to solid metal, about as long as the link, tilted a little against the link frame, and written with
five significant digits. One mistake is planted in each; `--write` puts the table into the docs.
"""

import random
import sys
from collections import Counter
from collections.abc import Callable
from math import degrees, pi
from pathlib import Path
from typing import NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tests.support.bodies import body_of, inertia_text, significant, tilted_rotation

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.mechanics.rigid.body import MassDistribution, shifted

BODIES = 1000
PAGE = Path(__file__).parents[1] / "docs" / "seeded_defects.md"
LOOKED_AT = Settings(select=("KD3", "KD5"), ignore=("KD507",))
WRITE = significant(5)


class Sample(NamedTuple):
    """A link's body, with the pose of the joint that it carries."""

    body: MassDistribution
    translation: tuple[float, float, float]
    rotation: tuple[float, float, float]


class Kind(NamedTuple):
    """A kind of mistake: how it is made, and the codes that name it."""

    name: str
    plant: Callable[[random.Random, Sample], Sample]
    causes: frozenset[str]


def random_sample(generator: random.Random) -> Sample:
    length = 10.0 ** generator.uniform(-1.2, -0.1)
    sides = [length * generator.uniform(0.15, 0.6) for _ in range(3)]
    long_axis = generator.randrange(3)
    sides[long_axis] = length
    mass = sides[0] * sides[1] * sides[2] * 10.0 ** generator.uniform(2.5, 3.6)
    com = [generator.gauss(0.0, 0.1) * side for side in sides]
    com[long_axis] = length * generator.uniform(0.3, 0.6) * generator.choice((-1, 1))
    turn = tilted_rotation(generator, 0.25)
    spread = [
        [
            sum(turn[i][k] * turn[j][k] * mass * sides[k] ** 2 / 12 for k in range(3))
            for j in range(3)
        ]
        for i in range(3)
    ]
    end = [0.0, 0.0, 0.0]
    end[long_axis] = 2.0 * com[long_axis]
    angles = [generator.choice((0.0, pi / 2, -pi / 2, pi / 4, pi, pi / 6)) for _ in range(3)]
    angles[generator.randrange(3)] = generator.choice((pi / 2, -pi / 2, pi / 3, pi))
    return Sample(body_of(mass, com, spread), tuple(end), tuple(angles))


def about_com(_: random.Random, sample: Sample) -> Sample:
    return sample._replace(body=shifted(sample.body, -1.0))


def signs(generator: random.Random, sample: Sample) -> Sample:
    chosen = generator.choice(((3, 4, 5), (3, 4, 5), (3,), (4,), (5,)))
    moments = tuple(-m if i in chosen else m for i, m in enumerate(sample.body.moments))
    return sample._replace(body=sample.body._replace(moments=moments))


def scale(generator: random.Random, sample: Sample) -> Sample:
    factor = generator.choice((1e9, 1e7, 1e6, 1e4, 1e3))
    moments = tuple(m * factor for m in sample.body.moments)
    return sample._replace(body=sample.body._replace(moments=moments))


def in_degrees(_: random.Random, sample: Sample) -> Sample:
    return sample._replace(rotation=tuple(degrees(angle) for angle in sample.rotation))


def in_millimetres(generator: random.Random, sample: Sample) -> Sample:
    if generator.random() < 0.5:
        return sample._replace(translation=tuple(1e3 * x for x in sample.translation))
    com = tuple(1e3 * x for x in sample.body.com)
    return sample._replace(body=sample.body._replace(com=com))


def swapped(generator: random.Random, sample: Sample) -> Sample:
    moments = list(sample.body.moments)
    one, other = generator.choice(((0, 1), (0, 2), (1, 2)))
    moments[one], moments[other] = moments[other], moments[one]
    return sample._replace(body=sample.body._replace(moments=tuple(moments)))


def heavy(generator: random.Random, sample: Sample) -> Sample:
    factor = generator.choice((10.0, 0.1))
    return sample._replace(body=sample.body._replace(mass=sample.body.mass * factor))


KINDS = (
    Kind("moments about the CoM", about_com, frozenset({"KD306"})),
    Kind("signs of products", signs, frozenset({"KD307"})),
    Kind("moments in another unit", scale, frozenset({"KD308"})),
    Kind("angles in degrees", in_degrees, frozenset({"KD501"})),
    Kind("lengths in millimetres", in_millimetres, frozenset({"KD502"})),
    Kind("two moments swapped", swapped, frozenset({"KD307"})),
    Kind("mass ten times too great or small", heavy, frozenset({"KD314"})),
)


def document(sample: Sample) -> str:
    translation, rotation = (
        ", ".join(f"{x:.6f}" for x in vector) for vector in (sample.translation, sample.rotation)
    )
    link = f"link link1 {{ id = 1 {inertia_text(sample.body, WRITE)}"
    pose = "ref_frame { translation = (%s) rotation = (%s) }"
    hand = "mass = 0.5 CoM = (0.0, 0.0, 0.02) Ix=0.0006 Iy=0.0006 Iz=0.0003 Ixy=0.0 Ixz=0.0 Iyz=0.0"
    return (
        "Robot Sample {\nRobotBase ground { children { link1 via joint1 } }\n"
        f"{link} children {{ hand via joint2 }} }}\n"
        f"link hand {{ id = 2 inertia_params {{ {hand} }} children {{}} }}\n"
        f"r_joint joint1 {{ {pose % ('0.0, 0.0, 0.1', '0.0, 0.0, 0.0')} }}\n"
        f"r_joint joint2 {{ {pose % (translation, rotation)} }}\n}}\n"
    )


def codes(sample: Sample) -> list[str]:
    """Return the codes of what is found, but for hints, the first cause first."""
    found = analyse(document(sample), LOOKED_AT).findings
    return [f.code for f in found if f.severity in ("error", "warning") or f.code in CAUSES]


CAUSES = frozenset({"KD306", "KD307", "KD308", "KD310", "KD314"})


def measure(kind: Kind, seed: int = 2018) -> tuple[int, int, Counter[str]]:
    """Return how many of the mistakes are found, how many are named, and what was named instead."""
    generator = random.Random(f"{seed} {kind.name}")
    detected = named = 0
    others: Counter[str] = Counter()
    for _ in range(BODIES):
        sample = random_sample(generator)
        assert not codes(sample), document(sample)
        found = codes(kind.plant(generator, sample))
        detected += bool(found)
        if kind.causes & set(found):
            named += 1
        else:
            others.update(code for code in set(found) if code in CAUSES or code > "KD5")
    return detected, named, others


def table() -> str:
    lines = [
        "# Planted mistakes",
        "",
        f"Each kind of mistake is planted in {BODIES:,} possible bodies; `python"
        " benchmarks/seeded_defects.py --write` makes this table.",
        "The second figure is the share of the found ones whose cause is named rightly. Without",
        "the mistake, not one of the bodies is reported. How often a fix is offered, and right, is",
        "told in [Causes](inertia_causes.md).",
        "",
        "| mistake | found | cause named | named instead |",
        "|---|---|---|---|",
    ]
    for kind in KINDS:
        detected, named, others = measure(kind)
        share = f"{100 * named / detected:.1f} %" if kind.causes and detected else "-"
        instead = ", ".join(f"{code} {count}" for code, count in others.most_common(3)) or "-"
        lines.append(f"| {kind.name} | {100 * detected / BODIES:.1f} % | {share} | {instead} |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    text = table()
    print(text)
    if "--write" in sys.argv:
        # What `planted_slips.py` writes stands behind.
        _, heading, rest = PAGE.read_text("utf-8").partition("\n## ")
        PAGE.write_text(text + heading + rest, encoding="utf-8")
