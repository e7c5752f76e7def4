"""A joint slides where those of its twins turn.

## What it does
Reports a joint of a limb that is prismatic where its twins in the like limbs are revolute, or the
reverse. Limbs are told by their names: sides, rows or numbers.

## Why is this bad?
The kind is one letter (`r_joint`, `p_joint`), and the robot is drawn the same either way.

## Example
```kindsl
r_joint LF_KFE { ... }
p_joint RF_KFE { ... }
r_joint LH_KFE { ... }
r_joint RH_KFE { ... }
```

## Fix
Writes the kind of the twins, where three limbs or more leave one odd. The fix is unsafe: it changes
the robot.
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Fix, Related, Replacement, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.limb_places import joint_of
from kindsl.judgement.rules.limb_verdicts import limb_slips
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Joint
from kindsl.language.semantics.lowering import OtherIsland
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Place

_OTHER = {"revolute": "prismatic", "prismatic": "revolute"}


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    for verdict in limb_slips(model, context).verdicts:
        if verdict.places[0].what == "kind":
            names = [place.link for place in verdict.places] + list(verdict.peers)
            odd, *others = [j for j in (joint_of(model, name) for name in names) if j is not None]
            related = tuple(Related(j.name, f"joint '{j.name}' is {j.kind}") for j in others)
            message = f"joint '{odd.name}' is {odd.kind}, "
            if verdict.is_convicted:
                message += f"its twins are {_OTHER[odd.kind]}"
                yield Finding(odd.name, message, related, _as_other(odd, others[0]))
            else:
                message += f"its twin '{others[0].name}' is {others[0].kind}"
                choices = _as_other(odd, others[0]), _as_other(others[0], odd)
                yield Finding(odd.name, message, related, choices=choices)


def _as_other(joint: Joint, peer: Joint) -> Fix:
    written = _type(peer)
    word = next(joint.node.tokens())
    place = _type(joint) or Place(joint.island, word.start, word.end)
    kind = f"{peer.kind[0]}_joint"
    if written is not None:
        kind = peer.island.text[written.start : written.end]
    return Fix(f"Make joint '{joint.name}' {peer.kind}", (Replacement(place, kind),))


def _type(joint: Joint) -> Place | None:
    """Return where the type of a joint in XML is written."""
    if not isinstance(joint.island, OtherIsland):
        return None
    from kindsl.robots.interchange.robot_island import RobotIsland

    island = joint.island
    return island.place(island.element, "type") if isinstance(island, RobotIsland) else None


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.NUMBERS)
