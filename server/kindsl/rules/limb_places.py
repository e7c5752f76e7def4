"""Places of the numbers of a limb, and their names."""

from kindsl.limbs.comparison import Suspect
from kindsl.rules.inertia.judgements import keyword
from kindsl.semantics.declarations import Child, Joint, Vector
from kindsl.semantics.model import Model
from kindsl.semantics.places import Located

OF_A_LINK = ("com", "moments", "inertia")
_WORDS = {"translation": "translation", "angles": "rotation", "com": "CoM"}


def told(place: Suspect) -> str:
    """Return what stands at a place: `translation of 'RF_HFE'`, `CoM of 'RF_upperleg'`."""
    name = place.link if place.what in OF_A_LINK else place.joint
    return f"{_WORDS.get(place.what, place.what)} of '{name}'"


def place_at(model: Model, link: str, what: str) -> Suspect:
    """Return the same place of a twin."""
    joint = joint_of(model, link)
    return Suspect(link, str(joint.name) if joint is not None else "", what)


def joint_of(model: Model, link: str) -> Joint | None:
    """Return the joint that supports a link."""
    edge = model.tree.supporting_edge(model.body_named[link])
    return edge.joint if edge is not None else None


def child_of(model: Model, link: str) -> Child:
    """Return the pair that attaches a link."""
    return model.tree.above[model.body_named[link]][0].child


def vector_at(model: Model, place: Suspect) -> Vector | None:
    """Return three numbers, None where others are meant."""
    inertia, joint = model.body_named[place.link].inertia, joint_of(model, place.link)
    if place.what == "com":
        return inertia.com if inertia is not None else None
    if joint is None or place.what not in ("translation", "angles"):
        return None
    return joint.pose.translation if place.what == "translation" else joint.pose.rotation


def located(model: Model, place: Suspect) -> Located:
    """Return where a finding is shown."""
    inertia, joint = model.body_named[place.link].inertia, joint_of(model, place.link)
    if place.what in ("moments", "inertia") and inertia is not None:
        return keyword(inertia)
    name = joint.name if joint is not None else model.body_named[place.link].name
    return vector_at(model, place) or name
