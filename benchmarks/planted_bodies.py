"""How slips planted in bodies are told: `python benchmarks/planted_bodies.py [FOLDER ...]`.

Each slip is made in the text of a whole robot, in the inertia of one of its moving links, and told
by the text of what is found there. Robots and options are those of `planted_slips.py`; `--honest`
lists what is told of the inertias as they are, `--wrong` each slip whose cause or fix is wrong.
"""

import random
import re
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from decimal import Decimal
from math import dist, log
from typing import NamedTuple

from planted_slips import Robot, edited, run

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.text_fix import TextFix
from kindsl.judgement.diagnosis.judge import weighed, weighed_as_written
from kindsl.judgement.diagnosis.judgements import (
    Verdict,
    is_about_one_number,
    is_round,
    judgement_of,
)
from kindsl.judgement.diagnosis.slips import Hypothesis
from kindsl.judgement.diagnosis.surroundings import surroundings
from kindsl.language.semantics.declarations import Inertia, Link
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.numbers import mass_distribution
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.edits import apply_edits
from kindsl.mechanics.rigid.body import MassDistribution, shifted

HEADING = "## Slips in bodies\n"
SIGNIFICANT = 0.03
# A slip in a hundred bodies is many: numbers that are less so much likelier do not tell it.
RARE = 100.0
NO_MATTER, AS_LIKELY = "of no matter before", "as likely as written"
Body = MassDistribution
Plant = Callable[[random.Random, Body, Sequence[Body]], Body | None]


class Kind(NamedTuple):
    """A slip: how it is made, and by which words its cause is told, where one can be told."""

    plant: Plant
    words: str


def with_moments(change: Callable[[list[float]], list[float]]) -> Plant:
    def plant(_: random.Random, body: Body, __: Sequence[Body]) -> Body:
        return body._replace(moments=tuple(change(list(body.moments))))

    return plant


def scaled(*factors: float) -> Plant:
    def plant(generator: random.Random, body: Body, _: Sequence[Body]) -> Body:
        factor = generator.choice(factors)
        return body._replace(moments=tuple(m * factor for m in body.moments))

    return plant


def heavier(factor: float) -> Plant:
    return lambda _, body, __: body._replace(mass=body.mass * factor)


def moved(sign: float) -> Plant:
    return lambda _, body, __: shifted(body, sign)


def com(change: Callable[[random.Random, list[float]], list[float]]) -> Plant:
    return lambda generator, body, _: body._replace(com=tuple(change(generator, [*body.com])))


def negated(generator: random.Random, values: list[float]) -> list[float]:
    chosen = max(range(len(values)), key=lambda i: abs(values[i]))
    if generator.random() < 0.5:
        chosen = generator.randrange(len(values))
    return [-v if i == chosen else v for i, v in enumerate(values)]


def swapped(generator: random.Random, values: list[float]) -> list[float]:
    i, j = generator.sample(range(3), 2)
    values[i], values[j] = values[j], values[i]
    return values


def cyclic(m: list[float]) -> list[float]:
    return [m[1], m[2], m[0], m[5], m[3], m[4]]


def one_product(generator: random.Random, body: Body, _: Sequence[Body]) -> Body:
    i = generator.choice((3, 4, 5))
    return body._replace(moments=tuple(-m if j == i else m for j, m in enumerate(body.moments)))


def stray_minus(generator: random.Random, body: Body, _: Sequence[Body]) -> Body:
    i = generator.randrange(3)
    return body._replace(moments=tuple(-m if j == i else m for j, m in enumerate(body.moments)))


def one_scaled(factor: float) -> Plant:
    def plant(generator: random.Random, body: Body, _: Sequence[Body]) -> Body:
        i = generator.randrange(3)
        moments = (m * factor if j == i else m for j, m in enumerate(body.moments))
        return body._replace(moments=tuple(moments))

    return plant


def digit_lost(generator: random.Random, body: Body, _: Sequence[Body]) -> Body:
    """Leave out one of the first digits of one number."""
    numbers = ten(body)
    chosen = generator.choice([i for i, x in enumerate(numbers) if x])
    text = decimal(numbers[chosen])
    at = generator.choice([i for i, c in enumerate(text) if c in "123456789"][:3])
    left = text[:at] + text[at + 1 :]
    numbers[chosen] = float(left) if left.strip("-.") else 0.0
    return Body(numbers[0], tuple(numbers[1:4]), tuple(numbers[4:]))


def about_com_and_signs(_: random.Random, body: Body, __: Sequence[Body]) -> Body:
    ix, iy, iz, *products = shifted(body, -1.0).moments
    return body._replace(moments=(ix, iy, iz, *(-p for p in products)))


def signs_before_shift(_: random.Random, body: Body, __: Sequence[Body]) -> Body | None:
    ix, iy, iz, *products = shifted(body, -1.0).moments
    # Where the shift changes no product, that is another kind of slip.
    if tuple(products) == body.moments[3:]:
        return None
    return shifted(body._replace(moments=(ix, iy, iz, *(-p for p in products))))


def unit_about_com(generator: random.Random, body: Body, others: Sequence[Body]) -> Body | None:
    return scaled(1e9, 1e7, 1e6, 1e4)(generator, shifted(body, -1.0), others)


def copied(generator: random.Random, body: Body, others: Sequence[Body]) -> Body | None:
    unlike = [o for o in others if not 0.5 < o.mass / body.mass < 2.0]
    return generator.choice(unlike) if unlike else None


KINDS: dict[str, Kind] = {
    "moments in another unit": Kind(scaled(1e9, 1e7, 1e6, 1e4), r"moments were in "),
    "moments about the CoM": Kind(moved(-1.0), r"taken about the CoM"),
    "moments about the CoM, signs": Kind(about_com_and_signs, r"taken about the CoM"),
    "unit, about the CoM": Kind(unit_about_com, r"moments were in "),
    "moments shifted twice": Kind(moved(1.0), r"twice"),
    "products negated": Kind(
        with_moments(lambda m: [*m[:3], *(-x for x in m[3:])]), r"sign.* of Ix|sign.* of Iy"
    ),
    "products negated, then shifted": Kind(signs_before_shift, r"about the CoM"),
    "one product negated": Kind(one_product, r"sign.* of I"),
    "moments in row-major order": Kind(
        with_moments(lambda m: [m[0], m[3], m[4], m[1], m[5], m[2]]), r"xx xy xz"
    ),
    "Iy and Iz exchanged": Kind(
        with_moments(lambda m: [m[0], m[2], m[1], *m[3:]]), r"Iy and Iz|about the axes"
    ),
    "tensor turned to other axes": Kind(with_moments(cyclic), r"about the axes|were swapped"),
    "mass in grams": Kind(heavier(1e3), r"mass were in g|mass of .* is|mass is "),
    "mass ten times": Kind(heavier(10.0), r"mass were divided by 10\b|mass of .* is|mass is "),
    "mass a tenth": Kind(heavier(0.1), r"mass were multiplied by 10\b|mass of .* is|mass is "),
    "CoM in mm": Kind(com(lambda _, c: [1e3 * x for x in c]), r"CoM.* mm\b|millimetres"),
    "CoM in cm": Kind(com(lambda _, c: [1e2 * x for x in c]), r"CoM.* cm\b|centimetres"),
    "CoM in inches": Kind(com(lambda _, c: [x / 0.0254 for x in c]), r"CoM.* in\b|inches"),
    "sign of the CoM": Kind(com(negated), r"of the CoM|CoM is|CoM of"),
    "CoM exchanged": Kind(com(swapped), r"of the CoM|CoM is|CoM of"),
    "minus on one moment": Kind(stray_minus, r"sign of I[xyz]\b|minus"),
    "a moment ten times": Kind(one_scaled(10.0), r"I[xyz]+ (were|was|is|of)"),
    "a moment a tenth": Kind(one_scaled(0.1), r"I[xyz]+ (were|was|is|of)"),
    "a digit lost": Kind(digit_lost, r"I[xyz]+ (were|was|is|of)|mass (were|was|of|is)|CoM"),
    "placeholder 0.001": Kind(
        with_moments(lambda _: [0.001, 0.001, 0.001, 0.0, 0.0, 0.0]), r"placeholder"
    ),
    "copied from another link": Kind(copied, r"another part|share the same"),
}


def decimal(value: float) -> str:
    text = format(Decimal(f"{value:.6g}"), "f")
    return text if "." in text else f"{text}.0"


def ten(body: Body) -> list[float]:
    return [body.mass, *body.com, *body.moments]


def expressions(inertia: Inertia) -> list[Expression]:
    assert inertia.mass is not None and inertia.com is not None
    return [inertia.mass, *inertia.com.components, *(inertia.moments[name] for name in MOMENTS)]


def planted(analysis: Analysis, inertia: Inertia, old: Body, new: Body) -> str:
    """Return the text with the numbers written that a slip has changed."""
    pairs = zip(expressions(inertia), ten(old), ten(new), strict=True)
    return edited(analysis, *((at, decimal(b)) for at, a, b in pairs if a != b))


def is_near(one: Body, other: Body, within: float = 0.02) -> bool:
    groups = (([one.mass], [other.mass]), (one.com, other.com), (one.moments, other.moments))
    return all(dist(a, b) <= within * max(map(abs, (*a, *b))) for a, b in groups)


def bodies(analysis: Analysis) -> list[tuple[Link, Inertia, Body]]:
    """Return the moving links whose inertia is ten numbers."""
    found = []
    for link in analysis.model.bodies:
        inertia = link.inertia
        if inertia is None or (link.is_base and not link.is_floating):
            continue
        body = mass_distribution(inertia, {})
        if body is not None and body.mass > 0.0 and any(body.moments[:3]):
            found.append((link, inertia, body))
    return found


class Outcome(NamedTuple):
    """What comes of a slip.

    Attributes:
        codes: Of what is found in the link besides.
        has_cause: Whether a cause is told, rightly or not.
        is_first: Whether the right one is told first.
        is_told: Whether it is told at all.
        has_fix: Whether a fix is offered.
        is_right: Whether it restores the numbers.
        told: What is found.
        hidden: Why nobody could be sure of it, empty where that is not so.
    """

    codes: tuple[str, ...]
    has_cause: bool
    is_first: bool
    is_told: bool
    has_fix: bool
    is_right: bool
    told: tuple[str, ...]
    hidden: str


def outcome(robot: Robot, link: Link, text: str, meant: Body, words: str) -> Outcome:
    analysis = analyse(text)
    before = {(f.code, f.message) for f in robot.analysis.findings}
    place = next(b for b in analysis.model.bodies if b.name == link.name)
    start, end = analysis.resolver.span(place)
    new = [f for f in analysis.findings if (f.code, f.message) not in before]
    found = [f for f in new if f.code.startswith(LOOKED_AT) and _is_at(f, start, end)]
    sentences = list(_sentences(found))
    fixes = [f.fix for f in found if f.fix is not None]
    mended = [each for fix in fixes for each in _in_rounds(text, fix, link)]
    return Outcome(
        tuple(f.code for f in found),
        bool(sentences),
        bool(sentences) and re.search(words, sentences[0]) is not None,
        any(re.search(words, sentence) for sentence in sentences),
        bool(fixes),
        any(is_near(_body(each, link), meant) for each in mended),
        tuple(f"{f.code} {f.message}" for f in found)
        + tuple(f"  {r.message}" for f in found for r in f.related)
        + tuple(f"  fix {fix.title}" for fix in fixes),
        _hidden(analysis, place, meant),
    )


def _hidden(analysis: Analysis, link: Link, meant: Body) -> str:
    """Return why nobody could be sure of a slip: of numbers that were nobody's, or may be meant."""
    assert link.inertia is not None
    values = analysis.context.values
    before = judgement_of(link, link.inertia, meant, values)
    about_com = shifted(meant, -1.0).moments
    is_odd = any(is_round(m) or is_about_one_number(m) for m in (meant.moments, about_com))
    if is_odd or before.verdict is not Verdict.POSSIBLE:
        return NO_MATTER
    body = mass_distribution(link.inertia, values)
    if body is None or body.mass <= 0.0:
        return ""
    found = judgement_of(link, link.inertia, body, values)
    around = surroundings(analysis.model, values, found)
    if found.verdict is not Verdict.POSSIBLE or around.peers:
        return ""
    as_meant = weighed(Hypothesis((), meant, found.half, 1.0), found, around)
    as_written = weighed_as_written(found, around)
    if as_meant is None or as_written is None:
        return ""
    gain = as_meant.log_likelihood - as_written.log_likelihood
    return AS_LIKELY if gain < log(RARE) else ""


def _is_at(finding: Diagnostic, start: int, end: int) -> bool:
    """Return whether a finding is in a link, or of a pair of which this is one."""
    related = finding.related if finding.code in PAIRS else ()
    return any(start <= each.start < end for each in (finding, *related))


def _in_rounds(text: str, fix: TextFix, link: Link) -> Iterator[Analysis]:
    """Yield the robot after a fix, and after the one that is offered then."""
    once = analyse(apply_edits(text, fix.edits))
    yield once
    place = next(b for b in once.model.bodies if b.name == link.name)
    start, end = once.resolver.span(place)
    for finding in once.findings:
        if finding.code in CAUSES and start <= finding.start < end and finding.fix is not None:
            yield analyse(apply_edits(once.text, finding.fix.edits))


def _sentences(found: Sequence[Diagnostic]) -> Iterator[str]:
    """Yield what is told of causes, the first that is told first."""
    for finding in found:
        if finding.code in CAUSES:
            yield from re.split(r"; or if ", finding.message)
            yield from (related.message for related in finding.related)


PAIRS = ("KD312", "KD510")
LOOKED_AT = ("KD3", "KD502", "KD509", "KD510", "KD511")
CAUSES = ("KD306", "KD307", "KD308", "KD310", "KD314", "KD502", "KD509", "KD510", "KD312", "KD511")


def _body(analysis: Analysis, link: Link) -> Body:
    at = next(b for b in analysis.model.bodies if b.name == link.name)
    body = mass_distribution(at.inertia, {}) if at.inertia else None
    assert body is not None
    return body


def measure(
    pool: Sequence[Robot], kind: str, number: int, seed: int, show: bool = False
) -> list[Outcome]:
    """Plant a kind of slip so often, and tell what came of it."""
    generator = random.Random(f"{seed} {kind}")
    outcomes: list[Outcome] = []
    fitting = [robot for robot in pool if bodies(robot.analysis)]
    for _ in range(20 * number):
        if len(outcomes) == number:
            break
        robot = generator.choice(fitting)
        every = bodies(robot.analysis)
        link, inertia, meant = generator.choice(every)
        others = [body for other, _, body in every if other is not link]
        wrong = KINDS[kind].plant(generator, meant, others)
        if wrong is None or is_near(wrong, meant, SIGNIFICANT):
            continue
        text = planted(robot.analysis, inertia, meant, wrong)
        outcomes.append(outcome(robot, link, text, meant, KINDS[kind].words))
        last = outcomes[-1]
        if show and last.codes and not (last.is_first and (last.is_right or not last.has_fix)):
            print(f"--- {kind}: {robot.name} {link.name}\n    meant {ten(meant)}")
            print(f"    wrong {ten(wrong)}")
            print(*(f"    {each}" for each in last.told), sep="\n")
    return outcomes


def table(pool: Sequence[Robot], number: int, seed: int, show: bool = False) -> str:
    head = (
        *("slip", "planted", "found", "a cause told", "the cause told", "told first"),
        *("fix", "fix right", "codes"),
    )
    lines = [f"| {' | '.join(head)} |", "|---" * len(head) + "|"]
    print(lines[0])
    total: list[Outcome] = []
    for kind in KINDS:
        outcomes = measure(pool, kind, number, seed, show)
        total += outcomes
        lines.append(_row(kind, outcomes))
        print(lines[-1], flush=True)
    lines.append(_row("*all*", total))
    print(lines[-1])
    first, fixes = sum(e.is_first for e in total), [e for e in total if e.has_fix]
    print(
        f"told {sum(bool(e.codes) for e in total) / len(total):.1%}, first {first / len(total):.1%}"
        f", fixes right {sum(e.is_right for e in fixes)} of {len(fixes)}"
    )
    for why in (NO_MATTER, AS_LIKELY):
        missed = [e for e in total if e.hidden == why and not e.is_first]
        silent = sum(not e.codes for e in missed)
        print(
            f"{why}: {silent / len(total):.1%} not told, {len(missed) / len(total):.1%} not first"
        )
    return "\n".join(lines) + "\n"


def _row(kind: str, outcomes: Sequence[Outcome]) -> str:
    codes = Counter(code for each in outcomes for code in each.codes).most_common(3)
    numbers = (
        len(outcomes),
        sum(bool(each.codes) for each in outcomes),
        sum(each.has_cause for each in outcomes),
        sum(each.is_told for each in outcomes),
        sum(each.is_first for each in outcomes),
        sum(each.has_fix for each in outcomes),
        sum(each.is_right for each in outcomes),
    )
    told = ", ".join(f"{code} {count}" for code, count in codes)
    return f"| {kind} | {' | '.join(map(str, numbers))} | {told} |"


def main() -> None:
    run(__doc__ or "", ("KD3",), table, HEADING, INTRODUCTION)


INTRODUCTION = """\
Each slip is made in the inertia of one moving link in the text of a whole robot, whatever was odd
there before. `found` counts findings in that link, of pairs at either side, that were not there
before, `a cause told` those that say what was done, `the cause told` those of them that name the
slip, first or among rivals, `fix right` fixes that restore the numbers within 2 %, at once or with
the one that is offered then. What leaves a possible body is seldom found without a twin. Robots and
halves are those of the limbs below:
`python benchmarks/planted_bodies.py --half 1 --number 40 --seed 7 --write FOLDER` makes the table.
"""


if __name__ == "__main__":
    main()
