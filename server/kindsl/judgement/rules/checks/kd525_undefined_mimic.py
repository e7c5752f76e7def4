"""A joint mimics a joint that is not there, or itself, perhaps through others.

## What it does
Looks at the `<mimic>` of each joint in a URDF or SDF.

## Why is this bad?
Programs refuse the file, or leave the joint where it is.

## Example
```xml
<mimic joint="elbwo"/>
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.xml_elements import elements
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Place
from kindsl.language.text.nearest import hint, nearest_name


def check_document(model: Model, _: object) -> Iterator[Finding]:
    joints = list(elements(model, "joint"))
    names = {island.full_name for island, _ in joints}
    follows: dict[str, str] = {}
    places: dict[str, Place] = {}
    for island, joint in joints:
        mimic = joint.find("mimic" if island.has_attributes else "axis/mimic")
        other = None if mimic is None else mimic.get("joint")
        if mimic is None:
            continue
        name, followed = island.full_name, f"{island.prefix}{other}"
        if other is None:
            yield Finding(island.place(mimic), f"joint '{name}' mimics a joint that is not named")
        elif followed not in names:
            close = hint(nearest_name(other, names - {name}))
            message = f"joint '{name}' mimics a joint '{other}' that does not exist"
            yield Finding(island.place(mimic, "joint"), f"{message}{close}")
        else:
            follows[name], places[name] = followed, island.place(mimic, "joint")
    told: set[str] = set()
    for name in follows:
        chain = [name]
        while (followed := follows.get(chain[-1], "")) and followed not in chain:
            chain.append(followed)
        if followed == name and name not in told:
            told.update(chain)
            through = f": {' -> '.join([*chain, name])}" if len(chain) > 1 else ""
            yield Finding(places[name], f"joint '{name}' mimics itself{through}")


RULE = Rule(__name__, Severity.ERROR, check_document=check_document)
