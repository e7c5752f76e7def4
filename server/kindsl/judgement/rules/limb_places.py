"""Places of the numbers of a limb, and their names."""

from kindsl.judgement.diagnosis.judgements import TEN, keyword
from kindsl.language.semantics.declarations import Child, Joint, Vector
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Located, has_problem_within
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.robots.limbs.weighing import Suspect

# Places in the inertia of a link, by which of its ten numbers they have.
PARTS = {"mass": slice(1), "com": slice(1, 4), "moments": slice(4, 10), "inertia": slice(10)}
OF_A_LINK = tuple(PARTS)
_WORDS = {"translation": "translation", "angles": "rotation", "com": "CoM"}


def told(place: Suspect) -> str:
    """Return the numbers at a place: `translation of 'RF_HFE'`, `CoM of 'RF_upperleg'`."""
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


def numbers_at(model: Model, place: Suspect) -> tuple[Expression, ...]:
    """Return the numbers of a place; none where some are missing, or are those of another frame."""
    vector, inertia = vector_at(model, place), model.body_named[place.link].inertia
    if place.what not in OF_A_LINK:
        return vector.components if vector is not None else ()
    if inertia is None or inertia.frame is not None or inertia.mass is None or inertia.com is None:
        return ()
    moments = (inertia.moments.get(name) for name in MOMENTS)
    ten = (inertia.mass, *inertia.com.components, *(m for m in moments if m is not None))
    return ten[PARTS[place.what]] if len(ten) == len(TEN) else ()


def is_broken(model: Model, place: Suspect) -> bool:
    """Return whether something is not in the language among, or right beside, these numbers."""
    inertia = model.body_named[place.link].inertia
    whole = inertia if place.what in OF_A_LINK and place.what != "com" else vector_at(model, place)
    return whole is not None and has_problem_within(whole)


def located(model: Model, place: Suspect) -> Located:
    """Return where a finding is shown."""
    inertia, joint = model.body_named[place.link].inertia, joint_of(model, place.link)
    if place.what in OF_A_LINK and place.what != "com" and inertia is not None:
        return keyword(inertia)
    name = joint.name if joint is not None else model.body_named[place.link].name
    return vector_at(model, place) or name
