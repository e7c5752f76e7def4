"""The numbering of links as bodies."""

from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.kinematic_tree import Edge
from kindsl.language.semantics.model import Model
from kindsl.robots.mechanism.errors import ModelError


def numbered_by_id(model: Model) -> list[Edge]:
    """Return the supporting edge of each link 1 to n; the body index is the id.

    Raises:
        ModelError: The tree has a defect, or the ids are no regular numbering of it.
    """
    base = require_base(model)
    for other in model.bases[1:]:
        raise ModelError(f"there is a second base, '{other.name}'", other.name)
    _check_edges(model)
    by_id: dict[int, Link] = {}
    for link in model.links:
        _check_id(link, by_id)
    if sorted(by_id) != list(range(1, len(model.links) + 1)):
        gap = next(i for i in range(1, len(by_id) + 1) if i not in by_id)
        raise ModelError(f"no link has the id {gap}, though the ids go up to {max(by_id)}", base)
    edges = [_supporting_edge(model, by_id[i]) for i in sorted(by_id)]
    for edge in edges:
        _check_order(edge)
    return edges


def numbered_by_tree(model: Model) -> list[Edge]:
    """Return the supporting edges of the links that the base carries, parents first.

    Needs no ids, and passes over what is not connected: for drawing what is there.

    Raises:
        ModelError: There is no base.
    """
    edges: list[Edge] = []
    known: set[Link] = set()
    for link in model.tree.in_topological_order(require_base(model)):
        edge = model.tree.supporting_edge(link)
        if edge is None or edge.joint is None or link.is_base:
            continue
        if edge.predecessor.is_base or edge.predecessor in known:
            known.add(link)
            edges.append(edge)
    return edges


def require_base(model: Model) -> Link:
    """Return the base.

    Raises:
        ModelError: There is none.
    """
    if model.base is None:
        raise ModelError("the document has no 'RobotBase'")
    return model.base


def _check_edges(model: Model) -> None:
    tree = model.tree
    if tree.loops:
        around = [*(str(edge.predecessor.name) for edge in tree.loops[0])]
        loop = " -> ".join([*around, around[0]])
        raise ModelError(f"the links form a kinematic loop: {loop}", tree.loops[0][0].child)
    for edge in tree.edges:
        if edge.link is None:
            raise ModelError(f"there is no link '{edge.child.link}'", edge.child.link)
        if edge.joint is None:
            raise ModelError(f"there is no joint '{edge.child.joint}'", edge.child.joint)
        if edge.link.is_base:
            raise ModelError(f"the base '{edge.link.name}' cannot be a child", edge.child)
        if len(tree.joint_uses[edge.joint]) > 1:
            raise ModelError(f"the joint '{edge.joint.name}' is used twice", edge.child.joint)


def _check_id(link: Link, by_id: dict[int, Link]) -> None:
    if link.id is None:
        raise ModelError(f"the link '{link.name}' has no id", link.name)
    if link.id in by_id:
        other = by_id[link.id].name
        raise ModelError(
            f"the links '{other}' and '{link.name}' have the same id {link.id}", link.id_place
        )
    by_id[link.id] = link


def _supporting_edge(model: Model, link: Link) -> Edge:
    edges = model.tree.above.get(link, [])
    if len(edges) == 1:
        return edges[0]
    if edges:
        raise ModelError(f"the link '{link.name}' has {len(edges)} parents", edges[1].child.link)
    if model.body_named.get(link.name) is not link:
        raise ModelError(f"two links have the name '{link.name}'", link.name)
    raise ModelError(f"link '{link.name}' has no parent", link.name)


def _check_order(edge: Edge) -> None:
    link, parent = edge.link, edge.predecessor
    if link is not None and (link.id or 0) <= (parent.id or 0):
        raise ModelError(
            f"the link '{link.name}' has the id {link.id}, not greater than {parent.id} "
            f"of its parent '{parent.name}'",
            link.id_place,
        )
