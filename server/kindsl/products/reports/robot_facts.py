"""The output of `kindsl info`, as plain data."""

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from math import inf
from typing import Any

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.verdicts import verdicts
from kindsl.judgement.rules.base import Severity
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.parameters import Parameter
from kindsl.language.semantics.places import Located
from kindsl.language.semantics.unknown import Unknown
from kindsl.language.text.groups import grouped
from kindsl.language.text.lines import LineIndex
from kindsl.products.reports.columns import number
from kindsl.products.reports.finding_objects import position_object
from kindsl.robots.mechanism.total_mass import Weight, missing_masses, own_mass, total_mass

_Place = Callable[[Located], dict[str, int]]

_SUBJECTS = {
    "KD0": "syntax",
    "KD1": "names and ids",
    "KD2": "kinematic tree",
    "KD3": "inertia",
    "KD4": "parameters",
    "KD5": "geometry",
    "KD6": "generators",
    "KD7": "style",
}


def robot_facts(analysis: Analysis) -> dict[str, Any]:
    """Return tree, masses and parameters, of a broken document the rest.

    Masses are in kilograms, None where they cannot be read. The robot's counts what moves, and is
    None unless all of it is known; `known_mass` is the sum of the rest, `missing_masses` the gaps.
    """
    model, values = analysis.model, analysis.context.values
    lines = LineIndex(analysis.text)

    def at(offset: int) -> dict[str, int]:
        return position_object(lines, offset)

    def place(located: Located) -> dict[str, int]:
        return at(analysis.resolver.span(located)[0])

    bodies = [_body(model, body, values, place) for body in _in_order(model)]
    weight = total_mass(model, values)
    n_joints = sum(body["joint"] is not None for body in bodies)
    return {
        "robot": model.name,
        "floating": model.floating,
        "dof": n_joints + (6 if model.floating else 0),
        "mass": weight.known if weight.is_whole else None,
        "known_mass": weight.known,
        "missing_masses": missing_facts(model, values),
        "base": bodies[0] if bodies and bodies[0]["id"] == 0 else None,
        "links": [body for body in bodies if body["id"] != 0],
        "parameters": [_parameter(p, analysis, place) for p in model.parameters],
        "constants": [
            {"name": str(c.name), "value": values.get(f"<{c.name}>"), **place(c.name)}
            for c in model.constants
        ],
        "findings": _severity_counts(analysis.findings),
        "verdicts": {
            verdict.target: {
                "reads": verdict.reads,
                "places": [
                    {"code": d.code, "message": d.message, **at(d.start)} for d in verdict.places
                ],
            }
            for verdict in verdicts(analysis)
        },
        "health": health_facts(analysis.findings, at),
    }


def _in_order(model: Model) -> Iterator[Link]:
    """Yield the base, then the links by id, those without one last."""
    if model.base is not None:
        yield model.base
    yield from sorted(model.links, key=lambda link: inf if link.id is None else link.id)


def _body(model: Model, body: Link, values: Mapping[str, float], place: _Place) -> dict[str, Any]:
    edge = None if body.is_base else model.tree.supporting_edge(body)
    mass = own_mass(body, values)
    return {
        "name": str(body.name),
        "id": body.id,
        "parent": str(edge.predecessor.name) if edge else None,
        "joint": str(edge.child.joint) if edge else None,
        "joint_type": edge.joint.kind if edge and edge.joint else None,
        "mass": None if isinstance(mass, Unknown) else mass,
        "frames": [str(frame.name) for frame in body.frames],
        **place(body.name),
    }


def branches(facts: Mapping[str, Any]) -> Iterator[tuple[tuple[bool, ...], dict[str, Any]]]:
    """Yield the bodies, each before those it carries, unconnected ones last.

    With each comes, for itself and its ancestors below the root, whether it is the last child.
    """
    children = grouped((link["parent"], link) for link in facts["links"])
    seen: set[int] = set()
    for start in [facts["base"], *facts["links"]] if facts["base"] else facts["links"]:
        pending: list[tuple[tuple[bool, ...], dict[str, Any]]] = [((), start)]
        while pending:
            are_last, body = pending.pop()
            if id(body) not in seen:
                seen.add(id(body))
                yield are_last, body
                below = children.get(body["name"], [])
                pending += [((*are_last, c is below[-1]), c) for c in reversed(below)]


def mass_text(facts: Mapping[str, Any]) -> str:
    """Return the mass of a robot for people; a partial mass is marked as such."""
    missing = [Unknown(one["reason"]) for one in facts["missing_masses"]]
    weight = Weight(facts["known_mass"], len(missing), missing[0] if missing else Unknown(""))
    return weight.explained(number(weight.known, "kg"))


def missing_facts(model: Model, values: Mapping[str, float]) -> list[dict[str, str]]:
    """Return the missing parts of the mass of a robot, with the reason."""
    missing = missing_masses(model, values)
    return [{"name": owner, "reason": why.plain} for owner, why in missing]


def _parameter(parameter: Parameter, analysis: Analysis, place: _Place) -> dict[str, Any]:
    name = str(parameter.name)
    binding = analysis.settings.bindings.get(name)
    in_document = None if parameter.value is None else "document"
    return {
        "name": name,
        "kind": parameter.kind.value,
        "value": analysis.context.values.get(name),
        "origin": binding.origin if binding else in_document,
        "min": binding.minimum if binding else None,
        "max": binding.maximum if binding else None,
        "uses": [{"kind": use.kind.value, **place(use.name)} for use in parameter.uses],
    }


def health_facts(
    findings: Sequence[Diagnostic], place: Callable[[int], dict[str, int]]
) -> dict[str, Any]:
    """Return a verdict and what it rests on, places as line, column and offset."""
    serious = [f for f in findings if f.severity in (Severity.ERROR, Severity.WARNING)]
    return {
        "verdict": _verdict(serious),
        "subjects": {
            name: _severity_counts([f for f in findings if f.code.startswith(prefix)])
            for prefix, name in _SUBJECTS.items()
        },
        "findings": [
            {
                "code": finding.code,
                "severity": finding.severity.value,
                "message": finding.message,
                **place(finding.start),
            }
            for finding in sorted(serious, key=lambda f: f.severity is Severity.WARNING)
        ],
    }


def _verdict(serious: Sequence[Diagnostic]) -> str:
    if any(finding.severity is Severity.ERROR for finding in serious):
        return "broken"
    return "suspect" if serious else "good"


def _severity_counts(findings: Sequence[Diagnostic]) -> dict[str, int]:
    counts = Counter(finding.severity for finding in findings)
    return {severity.value: counts[severity] for severity in Severity}
