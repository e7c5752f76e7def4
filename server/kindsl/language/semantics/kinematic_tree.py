"""Parents and children: the edges `link via joint`, and their defects as a tree."""

from collections.abc import Iterable, Mapping
from functools import cached_property
from typing import NamedTuple

from kindsl.language.semantics.declarations import Child, Joint, Link
from kindsl.language.text.groups import grouped


class Edge(NamedTuple):
    """One `link via joint` with what its names refer to; None where they refer to nothing."""

    predecessor: Link
    child: Child
    link: Link | None
    joint: Joint | None


class KinematicTree:
    """The edges of a document, each looked up once."""

    def __init__(
        self,
        bodies: Iterable[Link],
        links: Mapping[str, Link],
        joints: Mapping[str, Joint],
        base: Link | None,
    ) -> None:
        self.edges: list[Edge] = []
        self.below: dict[Link, list[Edge]] = {}
        for body in bodies:
            if body.children:
                self.below[body] = [
                    Edge(body, child, links.get(child.link), joints.get(child.joint))
                    for child in body.children
                ]
                self.edges += self.below[body]
        self._base = base

    @cached_property
    def above(self) -> dict[Link, list[Edge]]:
        """The edges that lead to a body; more than one is a defect."""
        return grouped((edge.link, edge) for edge in self.edges)

    @cached_property
    def joint_uses(self) -> dict[Joint, list[Edge]]:
        """The edges that name a joint; more than one is a defect."""
        return grouped((edge.joint, edge) for edge in self.edges)

    @cached_property
    def reachable(self) -> set[Link]:
        """The bodies that the base carries, the base included."""
        if self._base is None:
            return set()
        return {self._base, *self.in_topological_order(self._base)}

    @cached_property
    def loops(self) -> list[tuple[Edge, ...]]:
        """Each kinematic loop once, as the edges around it.

        Depth-first search without recursion; an edge back to the path closes a loop.
        """
        loops: list[tuple[Edge, ...]] = []
        done: set[Link] = set()
        for start in self.below:
            if start not in done:
                self._search_loops(start, done, loops)
        return loops

    def supporting_edge(self, link: Link) -> Edge | None:
        """Return the edge that carries a link, the first if there are several."""
        edges = self.above.get(link)
        return edges[0] if edges else None

    def successor_edges(self, body: Link) -> list[Edge]:
        """Return the edges that leave a body."""
        return self.below.get(body, [])

    def joints_on(self, body: Link) -> tuple[Joint, ...]:
        """Return the existing joints to the body's children."""
        return tuple([e.joint for e in self.below.get(body, ()) if e.joint is not None])

    def in_topological_order(self, base: Link) -> list[Link]:
        """Return the links that the base carries, parents first, siblings in written order."""
        order: list[Link] = []
        seen = {base}
        row = [base]
        while row:
            row = [
                edge.link
                for body in row
                for edge in self.successor_edges(body)
                if edge.link is not None and edge.link not in seen and not seen.add(edge.link)  # type: ignore[func-returns-value]
            ]
            order += row
        return order

    def _search_loops(self, start: Link, done: set[Link], loops: list[tuple[Edge, ...]]) -> None:
        path: list[Edge] = []
        depth = {start: 0}
        stack = [iter(self.below.get(start, ()))]
        bodies = [start]
        while stack:
            edge = next(stack[-1], None)
            if edge is None:
                stack.pop()
                finished = bodies.pop()
                done.add(finished)
                del depth[finished]
                if path:
                    path.pop()
            elif edge.link is not None and edge.link in depth:
                loops.append((*path[depth[edge.link] :], edge))
            elif edge.link is not None and edge.link not in done:
                path.append(edge)
                depth[edge.link] = len(bodies)
                bodies.append(edge.link)
                stack.append(iter(self.below.get(edge.link, ())))
