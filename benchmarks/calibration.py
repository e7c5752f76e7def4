"""How often a cause holds that is claimed with a probability: `make calibration`.

Slips are planted in robots as by `planted_bodies.py` and `planted_slips.py`. Each new finding makes
a claim: with the probability that it carries, or with none. A claim holds if it names what was
planted: about the planted body by the words of its cause, about a limb by the place, or by a fix
that restores the robot. What was a placeholder before is one with a slip, too. What is told of
other bodies counts only where nothing was before: the truth about an odd body of somebody else's is
not known, in whatever words it is told.

`--number N` slips of a kind are planted, `--half 1` (as usual) in robots that nothing was fitted
on, `--seed N` chooses others, `--write` puts the table into the docs.
"""

import argparse
import random
import re
from collections.abc import Iterator, Sequence
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import planted_bodies
import planted_slips
from planted_slips import Robot, is_same, robots, write_section

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.fixing import announced
from kindsl.judgement.diagnosis.judgements import is_round
from kindsl.judgement.rules.subject import SubjectKind
from kindsl.language.text.edits import apply_edits
from kindsl.mechanics.rigid.body import MassDistribution, shifted

HEADING = "## Claimed against true\n"
BINS = (0.0, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99, 1.0)
# The rules that say what is wrong; the others say what follows from it.
CAUSES = (*planted_bodies.CAUSES, *planted_slips.CODES)


class Claim(NamedTuple):
    """What a finding claims of a robot with a slip.

    Attributes:
        code: Of its rule.
        probability: With which it names a cause, None where it names none.
        holds: Whether that was planted.
    """

    code: str
    probability: float | None
    holds: bool


def new_findings(
    robot: Robot, analysis: Analysis, links: Sequence[str]
) -> Iterator[tuple[Diagnostic, bool]]:
    """Yield what is told of causes that was not told before the slip, but for the density.

    With each whether it is about one of the links with the slip; of others only where it is the
    first cause that is told.
    """
    before = set(map(_claim, robot.analysis.findings))
    odd = {f.subject for f in robot.analysis.findings if f.probability is not None}
    for finding in announced(analysis):
        is_cause = finding.probability is not None or finding.code in CAUSES
        is_there = _is_about(finding, links, analysis)
        if is_cause and _claim(finding) not in before and (is_there or finding.subject not in odd):
            yield finding, is_there


def _claim(finding: Diagnostic) -> tuple[object, ...]:
    """Return what a finding says, apart from how dense the body is."""
    message = re.sub(r" implies a density of .*? kg/m³ and| \(density .*\)", "", finding.message)
    return finding.code, finding.subject, message


def of_bodies(pool: Sequence[Robot], number: int, seed: int) -> Iterator[Claim]:
    """Plant slips in bodies; a claim holds if it is about that body, and names its slip first."""
    fitting = [robot for robot in pool if planted_bodies.bodies(robot.analysis)]
    for kind, (plant, words) in planted_bodies.KINDS.items():
        generator = random.Random(f"{seed} {kind}")
        n_planted = 0
        for _ in range(20 * number):
            if n_planted == number:
                break
            robot = generator.choice(fitting)
            every = planted_bodies.bodies(robot.analysis)
            link, inertia, meant = generator.choice(every)
            others = [body for other, _, body in every if other is not link]
            wrong = plant(generator, meant, others)
            if wrong is None or planted_bodies.is_near(wrong, meant, planted_bodies.SIGNIFICANT):
                continue
            n_planted += 1
            text = planted_bodies.planted(robot.analysis, inertia, meant, wrong)
            copied = (other for other in others if other == wrong)
            was_placeholder = any(map(_is_placeholder, (meant, *copied)))
            expected = f"{words}|is a placeholder" if was_placeholder else words
            for finding, is_there in new_findings(robot, analyse(text), [str(link.name)]):
                sentence = re.split(r"; or if ", finding.message)[0]
                holds = is_there and re.search(expected, sentence) is not None
                yield Claim(finding.code, finding.probability, holds)


def of_limbs(pool: Sequence[Robot], number: int, seed: int) -> Iterator[Claim]:
    """Plant slips in limbs; a claim holds if it is about that place, or its fix restores all."""
    for twins in ("three", "pair"):
        fitting = [robot for robot in pool if robot.limbs[twins]]
        for kind, plant in planted_slips.KINDS.items():
            generator = random.Random(f"{seed} {twins} {kind}")
            n_planted = 0
            for _ in range(20 * number if fitting else 0):
                if n_planted == number:
                    break
                robot = generator.choice(fitting)
                tree = robot.analysis.model.tree
                name = generator.choice(robot.limbs[twins])
                edge = tree.above[robot.analysis.model.body_named[name]][0]
                slip = plant(generator, robot.analysis, edge)
                analysis = analyse(slip.text) if slip is not None else robot.analysis
                if slip is None or is_same(analysis, robot.analysis):
                    continue
                n_planted += 1
                for finding, is_there in new_findings(robot, analysis, slip.links):
                    fixes = [fix for fix in (finding.fix, *finding.choices) if fix is not None]
                    mended = (analyse(apply_edits(slip.text, fix.edits)) for fix in fixes)
                    holds = is_there or any(is_same(each, robot.analysis) for each in mended)
                    yield Claim(finding.code, finding.probability, holds)


def _is_placeholder(body: MassDistribution) -> bool:
    return any(is_round(each.moments) for each in (body, shifted(body, -1.0)))


def _is_about(finding: Diagnostic, links: Sequence[str], analysis: Analysis) -> bool:
    """Return whether a finding is about one of some links, or its joint."""
    kind, name = finding.subject
    if kind is SubjectKind.JOINT:
        edges = analysis.model.tree.edges
        return any(e.child.joint == name and e.child.link in links for e in edges)
    return name in links


def table(claims: Sequence[Claim]) -> str:
    """Return the table: what is claimed, and how much of it holds."""
    lines = ["| claimed | claims | mean claim | hold | share |", "|---|---|---|---|---|"]
    for low, high in pairwise(BINS):
        within = [
            (c.probability, c.holds)
            for c in claims
            if c.probability is not None
            and (low <= c.probability < high or c.probability == high == 1.0)
        ]
        if within:
            mean = sum(p for p, _ in within) / len(within)
            lines.append(_row(f"{low:.0%} to {high:.0%}", f"{mean:.1%}", [h for _, h in within]))
    silent = [c for c in claims if c.probability is None]
    for code in sorted({c.code for c in silent}):
        lines.append(_row(f"{code}, none", "", [c.holds for c in silent if c.code == code]))
    return "\n".join(lines) + "\n"


def _row(name: str, mean: str, holding: Sequence[bool]) -> str:
    n = sum(holding)
    return f"| {name} | {len(holding)} | {mean} | {n} | {n / len(holding):.1%} |"


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folders", nargs="*", type=Path)
    parser.add_argument("--number", type=int, default=20)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--half", type=int, default=1)
    parser.add_argument("--write", action="store_true")
    given = parser.parse_args()
    pool = list(robots(given.folders, given.half))
    chosen = pool, given.number, given.seed
    text = table([*of_bodies(*chosen), *of_limbs(*chosen)])
    print(text)
    if given.write:
        write_section(HEADING, f"{INTRODUCTION}\n{text}")


INTRODUCTION = """\
A finding that weighs causes carries the probability of the one that it names (`probability` in
JSON). Of what is claimed at 90 %, 90 % should hold: that is measured on slips planted as below, in
robots that nothing was fitted on. What carries no probability is counted by its rule. A claim holds
if it names the slip that was planted, in the place where it was planted, or a placeholder where
there was one before. What is told of a body that was odd before, and has no slip, is left out.
`make calibration` prints the table, `python benchmarks/calibration.py --write FOLDER` makes it.
"""

if __name__ == "__main__":
    main()
