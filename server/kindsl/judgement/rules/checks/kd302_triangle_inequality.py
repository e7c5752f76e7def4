"""Principal moments violate the triangle inequality.

## What it does
Reports a moving link with principal moments `a + b < c` about its centre of mass: an error if that
holds for every choice of the numbers within their own last digits, rounded or cut off, a warning if
only zeros dropped at the end could explain it, else a hint, as for honest rods and plates. A link
of KD301 is not reported again.

## Why is this bad?
`c = a + b` is a plate without thickness; nothing is flatter than that. Simulators such as MuJoCo
and Drake refuse the model, estimators and optimisers that rely on possible bodies fail. Published
models have it.

## Example
```kindsl
inertia_params {
    mass = 1.8
    CoM = (0.0, 0.0, 0.0)
    Ix=0.0005 Iy=0.0005 Iz=0.009 Ixy=0.0 Ixz=0.0 Iyz=0.0
}
```

## How it is decided
With `S = tr(I)/2 1 - I` about the CoM, the body is possible if the smallest eigenvalue of `S` is
not negative; it is `(a + b - c) / 2`. Let `v` be its axis. `v' S v` is linear in the moments and
falls with `m (c.v)^2`, so its greatest value over all numbers that are written so, rounded or cut
off, is known in closed form. Where that is negative, `v` proves that no body has these numbers. A
body that was possible before its numbers were shortened, each to however many digits, is therefore
never an error.
"""

from collections.abc import Iterator

from kindsl.judgement.diagnosis.judgements import Verdict, judgements
from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.inertia.impossible import impossible
from kindsl.language.semantics.declarations import Declarations
from kindsl.language.text.quantities import sum_below


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    for found in judgements(declared, context.values):
        if found.verdict in (Verdict.TRIANGLE, Verdict.WITHIN_ROUNDING):
            small, middle, large = found.moments
            message = f"inertia of '{found.link.name}' violates the triangle inequality: principal "
            message += f"moments about the CoM {sum_below((small, middle), large)} kg·m²"
            finding = impossible(found, message, context.values)
            if found.verdict is Verdict.WITHIN_ROUNDING:
                told = f"{finding.message}, though not beyond rounding"
                finding = finding._replace(message=told, severity=Severity.HINT)
            yield finding


RULE = Rule(__name__, Severity.ERROR, check_island=check_island)
