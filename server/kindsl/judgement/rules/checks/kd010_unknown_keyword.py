"""An unknown word in the place of a keyword.

## What it does
Reports a section or block with an unknown name, and the name that is probably meant. Its content is
read as if the name were correct. Early models have `moments = a, b, c, d, e, f` in place of six
assignments, which is one finding.

## Why is this bad?
Generators say "no viable alternative" or "missing EOF" instead.

## Example
```kindsl
f_joint flange { ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }
```
There are `r_joint` and `p_joint` only. A fixed part belongs to the link that carries it.

## Fix
Writes the keyword that is meant. Unsafe: it is a guess. Safe for `moments`, which it replaces by
`Ix`, `Iy`, `Iz`, `Ixy`, `Ixz`, `Iyz` in this order.
"""

from kindsl.judgement.rules.base import Example, Rule, Severity
from kindsl.judgement.rules.examples import link
from kindsl.language.syntax.vocabulary import MOMENTS

_LINK = link("upper", 1)
_HEAD = "inertia_params {\n        mass = 4.1\n        CoM = (0.0, 0.0, 0.0)\n        "
_SIX = "\n        ".join(f"{name} = {0.2 if len(name) < 3 else 0.0}" for name in MOMENTS)
_TODAY = link("upper", 1, inertia=f"{_HEAD}{_SIX}\n    }}")

RULE = Rule(
    __name__,
    Severity.ERROR,
    good=(_LINK,),
    bad=(
        Example(_LINK.replace("children", "childrn"), fixed=_LINK),
        Example(_TODAY.replace(_SIX, "moments = 0.2, 0.2, 0.2, 0.0, 0.0, 0.0"), fixed=_TODAY),
    ),
)
