"""Fit what the judge believes: `python benchmarks/fit_judge.py [FOLDER ...] [--write]`.

Robots are the first half of `published.py`, and of the folders given; `planted_bodies.py` measures
on the other one. It takes SciPy.

Tables are counts of bodies that are possible and no placeholders, smoothed over a step, with a
twentieth for what was not seen; no family of robots counts for more than forty bodies. Then slips
are planted, and what each sort of slip weighs, and how far each part of the evidence is trusted, is
chosen so that what was done becomes likeliest (a logistic regression over the hypotheses). Robots
as they are count too: nine in ten of their odd bodies have no slip of the table. They weigh so much
that one odd body in three is such.
"""

import argparse
import random
import subprocess
import sys
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from math import exp, log
from pathlib import Path
from textwrap import TextWrapper
from typing import Any, NamedTuple

import numpy as np
from planted_bodies import KINDS, SIGNIFICANT, Body, bodies, is_near, planted
from published import Published, published
from scipy.optimize import minimize

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.diagnosis.digits import likely_half_widths, numbers_written
from kindsl.judgement.diagnosis.evidence import (
    MassShape,
    of_anything,
    of_spread,
    quantities_of,
    quantities_of_place,
    shape_of,
    ways_to_lie,
)
from kindsl.judgement.diagnosis.fitted import WEIGHTS
from kindsl.judgement.diagnosis.judge import Cause, candidates, weighed_as_written
from kindsl.judgement.diagnosis.judgements import IMPOSSIBLE, Judgement, is_round, verdict_of
from kindsl.judgement.diagnosis.slips import Slip
from kindsl.judgement.diagnosis.surroundings import (
    LinkSurroundings,
    farthest_end,
    middle_mass,
    of_counterparts,
    surroundings,
)
from kindsl.judgement.diagnosis.suspects import suspects_of
from kindsl.judgement.diagnosis.tables import LikelihoodTable
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import Vector3

Array = np.ndarray[Any, np.dtype[np.float64]]
Tables = Mapping[str, LikelihoodTable]
ROOT = Path(__file__).resolve().parents[1]
FILE = ROOT / "server" / "kindsl" / "judgement" / "diagnosis" / "fitted.py"
# From, to and by which steps each quantity is counted.
RANGES = {
    "density": (-6.0, 14.0, 1.0),
    "thickness": (-9.0, 0.0, 0.75),
    "width": (-7.5, 0.0, 0.75),
    "mass": (-6.0, 5.0, 1.0),
    "gyration": (-7.0, 3.0, 1.0),
    "distance": (-9.0, 3.0, 1.0),
    "place": (-6.0, 4.0, 1.0),
    "size": (-5.0, 4.0, 0.75),
    "reach": (-6.0, 3.0, 0.75),
    "side": (-1.0, 1.0, 0.25),
    "direction": (0.0, 1.0, 0.125),
}
UNSEEN, MOST_OF_A_FAMILY, ROUNDS = 0.05, 40.0, 200
# Each table, the spread, and whether all counterparts agree, or one but for its signs.
N_PARTS = len(RANGES) + 3
START_OF_AGREEMENT = 5.0
# Logarithm of how much likelier than a mirror image the very body is that counterparts let expect.
# One slip in a robot, as planted here, never shows that the counterparts are the wrong ones.
MOST_EXPECTED = 3.0
# How stiffly weights are held at the table of slips, and factors at one. Weights that are held less
# take the slips planted here, of each kind as many, for as common; see the evidence.
OF_SORTS, OF_PARTS = 10.0, 3.0
WEIGHT_OF_PUBLISHED, DOUBT = 8.0, 0.1
AS_WRITTEN, UNKNOWN = "as written", "unknown"
TRACELESS = (Slip.PLACEHOLDER, Slip.COPY)
OF_PLACE = [list(RANGES).index(name) for name in ("mass", "distance", "reach", "side")]
LEFT_BY = {"placeholder 0.001": Slip.PLACEHOLDER, "copied from another link": Slip.COPY}


class Seen(NamedTuple):
    """A published body that may be right."""

    family: str
    body: MassDistribution
    shape: MassShape
    end: Vector3 | None
    other_mass: float


def seen_in(robots: Sequence[Published]) -> Iterator[Seen]:
    """Yield the bodies that are possible and no placeholders, equal ones of a family once."""
    known: set[tuple[str, MassDistribution]] = set()
    for robot in robots:
        model, values = robot.analysis.model, robot.analysis.context.values
        for link, inertia, body in bodies(robot.analysis):
            half = likely_half_widths(numbers_written(inertia, values))
            shape = shape_of(body, half)
            key = robot.family, body
            if shape is None or key in known or is_round(body.moments) or inertia.frame is not None:
                continue
            known.add(key)
            if verdict_of(body, half, shape.pairs) not in IMPOSSIBLE:
                end = farthest_end(model, values, link)
                yield Seen(robot.family, body, shape, end, middle_mass(model))


def weights_of(seen: Sequence[Seen]) -> list[float]:
    numbers = Counter(each.family for each in seen)
    return [min(1.0, MOST_OF_A_FAMILY / numbers[each.family]) for each in seen]


def tables(seen: Sequence[Seen]) -> dict[str, LikelihoodTable]:
    counted: dict[str, list[tuple[float, float]]] = defaultdict(list)
    for each, weight in zip(seen, weights_of(seen), strict=True):
        for name, value in quantities_of(*each[1:]):
            counted[name].append((value, weight))
    return {name: table(*limits, counted[name]) for name, limits in RANGES.items()}


def table(
    low: float, high: float, step: float, counted: Sequence[tuple[float, float]]
) -> LikelihoodTable:
    """Return the ratio of the density counted and the uniform one at each step."""
    places = [low + i * step for i in range(round((high - low) / step) + 1)]
    sums = [
        sum(weight * exp(-0.5 * ((value - place) / (0.6 * step)) ** 2) for value, weight in counted)
        for place in places
    ]
    whole = sum(sums) or 1.0
    shares = [(1.0 - UNSEEN) * each / whole + UNSEEN / len(places) for each in sums]
    return LikelihoodTable(low, step, tuple(round(log(share * len(places)), 2) for share in shares))


def lies(seen: Sequence[Seen]) -> tuple[float, ...]:
    """Return how often bodies lie each way, by expectation and maximisation."""
    densities = [ways_to_lie(each.shape) for each in seen]
    weights, shares = weights_of(seen), [0.25] * 4
    for _ in range(ROUNDS):
        sums = [0.0] * 4
        for given, weight in zip(densities, weights, strict=True):
            parts = [share * density for share, density in zip(shares, given, strict=True)]
            whole = sum(parts)
            sums = [s + weight * part / whole for s, part in zip(sums, parts, strict=True)]
        shares = [s / sum(sums) for s in sums]
    return tuple(round(share, 3) for share in shares)


class Parts(NamedTuple):
    """What speaks for a hypothesis, in parts that are weighed by the fit.

    Attributes:
        sort: Of its slips.
        weight: The logarithm of its weight in the table of slips.
        parts: Of each table, of the spread, and whether counterparts agree, twofold.
        is_right: Whether it gives the numbers that were meant.
    """

    sort: str
    weight: float
    parts: list[float]
    is_right: bool


class Row(NamedTuple):
    """A suspect.

    Attributes:
        tried: What may have been.
        traceless: What leaves no trace of the numbers that were meant.
        place: The parts of mass and CoM as written.
        weight: How much it counts.
    """

    tried: list[Parts]
    traceless: list[Parts]
    place: list[float]
    weight: float


def parts_of(
    cause: Cause, found: Judgement, around: LinkSurroundings, known: Tables
) -> list[float]:
    h, shape = cause.hypothesis, cause.shape
    quantities = dict(quantities_of(h.body, shape, around.end, around.mass))
    told = [known[name].at(quantities[name]) if name in quantities else 0.0 for name in RANGES]
    spread = of_spread(shape) + h.log_change - of_anything(found.body.moments)
    agreement = of_counterparts(h.body, around).agreement
    return [*told, spread, float(agreement == 2), float(agreement == 1)]


def row_of(
    found: Judgement, analysis: Analysis, known: Tables, meant: Body | None, slip: Slip | None
) -> Row:
    """Return a suspect, `meant` being its numbers and `slip` what was done without a trace."""
    around = surroundings(analysis.model, analysis.context.values, found)
    tried: list[Parts] = []
    traceless: list[Parts] = []
    for cause in candidates(found, around):
        h, sort = cause.hypothesis, cause.hypothesis.sort
        weight = log(h.weight) - WEIGHTS.get(sort, 0.0)
        if h.slips[0] in TRACELESS:
            is_right = h.slips[0] is slip
            traceless.append(Parts(sort, weight + WEIGHTS.get(sort, 0.0), [], is_right))
        else:
            is_right = meant is not None and slip is None and is_near(h.body, meant)
            told = parts_of(cause, found, around, known)
            tried.append(Parts(sort, weight, told, is_right))
    is_unknown = slip is None and not any(each.is_right for each in tried)
    as_written = weighed_as_written(found, around)
    if as_written is not None:
        told = parts_of(as_written, found, around, known)
        tried.append(Parts(AS_WRITTEN, 0.0, told, is_unknown))
    tried.append(Parts(UNKNOWN, 0.0, [0.0] * N_PARTS, is_unknown))
    written = dict(quantities_of_place(found.body, around.end, around.mass))
    names = [list(RANGES)[i] for i in OF_PLACE]
    place = [known[name].at(written[name]) if name in written else 0.0 for name in names]
    return Row(tried, traceless, place, 1.0 if meant is not None else WEIGHT_OF_PUBLISHED)


def rows(robots: Sequence[Published], known: Tables, number: int) -> list[Row]:
    """Return the suspects of robots as they are, and with slips planted."""
    found: list[Row] = []
    seen: set[object] = set()
    for robot in robots:
        for each in suspects_of(robot.analysis.model, robot.analysis.context.values):
            if (robot.family, each.body) not in seen:
                seen.add((robot.family, each.body))
                row = row_of(each, robot.analysis, known, None, None)
                found += [] if row.traceless else [row]
    generator = random.Random("fit")
    families: dict[str, list[Published]] = defaultdict(list)
    for robot in robots:
        if bodies(robot.analysis):
            families[robot.family].append(robot)
    for kind in (kind for kind in KINDS for _ in range(number)):
        robot = generator.choice(families[generator.choice(sorted(families))])
        every = bodies(robot.analysis)
        link, inertia, meant = generator.choice(every)
        others = [body for other, _, body in every if other is not link]
        wrong = KINDS[kind].plant(generator, meant, others)
        if wrong is not None and not is_near(wrong, meant, SIGNIFICANT):
            analysis = analyse(planted(robot.analysis, inertia, meant, wrong))
            suspects = suspects_of(analysis.model, analysis.context.values)
            own = (each for each in suspects if each.link.name == link.name)
            found += [row_of(s, analysis, known, meant, LEFT_BY.get(kind)) for s in own]
    return found


def _with_place(parts: Array, place: Sequence[float]) -> Array:
    """Return parts of hypotheses beside the mass and CoM as written, without counterparts."""
    placed = parts.copy()
    placed[:-1, OF_PLACE] = place
    placed[:, -2:] = 0.0
    return placed


class Fit:
    """A logarithm to add for each sort, and a factor for each part of the evidence."""

    def __init__(self, given: Sequence[Row]) -> None:
        self.rows = given
        sorts = {each.sort for row in given for each in (*row.tried, *row.traceless)}
        self.sorts = sorted(sorts)
        place = {sort: i for i, sort in enumerate(self.sorts)}
        self.start = np.array([0.0] * len(sorts) + [1.0] * (N_PARTS - 2) + [START_OF_AGREEMENT] * 2)
        self.is_free = np.array([sort in (AS_WRITTEN, UNKNOWN) for sort in self.sorts])
        self.known = [
            (
                np.array([place[each.sort] for each in row.tried]),
                np.array([each.weight for each in row.tried]),
                np.array([each.parts for each in row.tried]),
                _with_place(np.array([each.parts for each in row.tried]), row.place),
                np.array([place[each.sort] for each in row.traceless], int),
                np.array([each.weight for each in row.traceless]),
                np.array([each.is_right for each in (*row.tried, *row.traceless)]),
                row.weight,
            )
            for row in given
        ]

    def cost(self, at: Array) -> tuple[float, Array]:
        """Return what is left to gain, and its gradient."""
        total, slope, n = 0.0, np.zeros_like(at), len(self.sorts)
        for sorts, weights, parts, placed, traceless, others, is_right, weight in self.known:
            logs = weights + parts @ at[n:] + at[sorts]
            # What leaves no trace is as likely as the likeliest moments, and as all else.
            is_rest = self.is_free[sorts]
            alone = placed @ at[n:] + np.where(is_rest, at[sorts], 0.0)
            best = int(np.argmax(alone))
            logs = np.concatenate([logs, alone[best] + others + at[traceless]])
            shares = np.exp(logs - logs.max())
            shares /= shares.sum()
            doubt = DOUBT if weight != 1.0 else 1e-6
            right = shares * is_right
            gain = right.sum() * (1.0 - doubt) + doubt
            change = weight * (1.0 - doubt) * (right - right.sum() * shares) / gain
            total += weight * log(gain)
            np.add.at(slope, sorts, change[: len(sorts)])
            np.add.at(slope, traceless, change[len(sorts) :])
            left = change[len(sorts) :].sum()
            slope[sorts[best]] += left * is_rest[best]
            slope[n:] += change[: len(sorts)] @ parts + left * placed[best]
        held = at - self.start
        stiff = np.where(self.is_free, 0.0, OF_SORTS)
        stiff = np.concatenate([stiff, [OF_PARTS] * (N_PARTS - 2), [0.0] * 2])
        return -total + float(stiff @ held**2), -slope + 2.0 * stiff * held

    def fitted(self) -> tuple[dict[str, float], list[float]]:
        result = minimize(self.cost, self.start, jac=True, method="L-BFGS-B")
        n = len(self.sorts)
        return dict(zip(self.sorts, result.x[:n], strict=True)), list(result.x[n:])


_ROW = TextWrapper(100, " " * 4, " " * 8, break_on_hyphens=False)


def text_of(
    known: Tables, shares: Sequence[float], sorts: Mapping[str, float], factors: Sequence[float]
) -> str:
    lines = [
        '"""Written by `benchmarks/fit_judge.py`, which says of what and how."""\n',
        "# fmt: off\nfrom kindsl.judgement.diagnosis.tables import LikelihoodTable\n",
        "TABLES = {",
    ]
    for factor, (name, each) in zip(factors, known.items(), strict=False):
        values = ", ".join(f"{factor * value:.2f}" for value in each.values)
        table = f'"{name}": LikelihoodTable({each.low}, {each.step}, ({values})),'
        lines.append(_ROW.fill(table))
    trust, expected, mirrored = factors[len(known) :]
    expected = min(expected, mirrored + MOST_EXPECTED)
    lines += ["}", "# Along the axes, turned about one, tilted a little, anyhow."]
    lines.append(f"LIES = ({', '.join(map(str, shares))})")
    lines.append(f"TRUST, EXPECTED, MIRRORED = {trust:.2f}, {expected:.2f}, {mirrored:.2f}")
    lines.append(f"AS_WRITTEN, UNKNOWN = {sorts[AS_WRITTEN]:.2f}, {sorts[UNKNOWN]:.2f}")
    lines.append("WEIGHTS = {")
    named = (sort for sort in sorts if sort not in (AS_WRITTEN, UNKNOWN))
    lines += [f'    "{sort}": {sorts[sort]:.2f},' for sort in named]
    return "\n".join([*lines, "}"]) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", nargs="*", type=Path)
    parser.add_argument("--number", type=int, default=60)
    parser.add_argument("--write", action="store_true")
    given = parser.parse_args()
    robots = published(given.folders, half=0)
    seen = list(seen_in(robots))
    known = tables(seen)
    fit = Fit(rows(robots, known, given.number))
    print(f"{len(seen)} bodies of {len({each.family for each in seen})} families,", end=" ")
    print(f"{len(fit.rows)} suspects")
    text = text_of(known, lies(seen), *fit.fitted())
    print(text)
    if given.write:
        FILE.write_text(text, "utf-8")
        subprocess.run([sys.executable, "-m", "ruff", "format", "-q", FILE], check=True)


if __name__ == "__main__":
    main()
