"""A supporting joint does not exist.

## What it does
Reports a `link via joint` whose joint is nowhere declared.

## Why is this bad?
Nobody knows how the link moves, and both generators reject the document.

## Example
```kindsl
children { forearm via elbwo }
```
where the joint is called `elbow`.

## Fix
Writes the name that is probably meant if no other pair has it (of equally near names one is to be
chosen), or else adds a revolute joint of that name. Unsafe: each is a guess.
"""

from collections.abc import Iterator

from kindsl.rules.base import Change, Example, Finding, Fix, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import link, robot
from kindsl.rules.new_blocks import new_joint
from kindsl.rules.reference_defects import reference_defects, suggestions
from kindsl.semantics.declarations import Child
from kindsl.semantics.model import Model
from kindsl.text.nearest import hint


def check_document(model: Model, _: Context) -> Iterator[Finding]:
    """Yield a finding for each reference to a joint that does not exist."""
    defects = reference_defects(model)
    idle = [str(joint.name) for joint in defects.idle_joints]
    free = set(idle)
    for number, edge in enumerate(defects.undefined_joints):
        name = edge.child.joint
        meant = suggestions(name, number, idle, (str(joint.name) for joint in model.joints))
        message = f"joint '{name}' does not exist{hint(meant)}"
        choices = tuple(_rename(edge.child, each) for each in meant)
        if len(choices) > 1:
            yield Finding(name, message, choices=choices)
        else:
            is_free = bool(meant) and meant[0] in free
            free.discard(meant[0] if meant else "")
            yield Finding(name, message, fix=choices[0] if is_free else new_joint(model, name))


def _rename(child: Child, meant: str) -> Fix:
    return Fix(f"Replace '{child.joint}' with '{meant}'", (Change(child.joint, meant),))


def _arm(joint: str, joints: str) -> str:
    links = link("upper", 1, f"forearm via {joint}"), link("forearm", 2)
    return robot(*links, base="upper via shoulder", joints=joints)


_ELBOW = """

r_joint elbow {
    ref_frame {
        translation = (0.0, 0.0, 0.0)
        rotation = (0.0, 0.0, 0.0)
    }
}
}
"""

RULE = Rule(
    "KD106",
    "undefined-joint",
    Severity.ERROR,
    check_document=check_document,
    good=(_arm("elbow", "shoulder elbow"),),
    bad=(
        Example(_arm("elbow", "shoulder elbwo"), fixed=_arm("elbwo", "shoulder elbwo")),
        Example(
            _arm("elbow", "shoulder"),
            fixed=_arm("elbow", "shoulder").removesuffix("\n}\n") + _ELBOW,
        ),
    ),
)
