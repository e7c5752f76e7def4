"""The output of `kindsl info`, for people."""

from collections.abc import Iterator
from typing import Any

from kindsl.language.text.phrases import counted
from kindsl.language.text.printable import printable
from kindsl.products.reports.columns import PARAMETER_UNITS, aligned, number
from kindsl.products.reports.robot_facts import branches, mass_text
from kindsl.robots.mechanism.total_mass import UNKNOWN

_MOST_TOLD = 10


def robot_text(facts: dict[str, Any]) -> str:
    """Return heading, tree, parameters and health."""
    parts = [_heading(facts), aligned(list(_tree_rows(facts)), frozenset((1, 4)))]
    if facts["parameters"]:
        parts.append(_parameters(facts["parameters"]))
    if facts["constants"]:
        rows = [("constants", "")]
        rows += [(f"  {c['name']}", number(c["value"])) for c in facts["constants"]]
        parts.append(aligned(rows, frozenset((1,))))
    if facts["verdicts"]:
        parts.append("".join(_verdict(*entry) for entry in facts["verdicts"].items()))
    parts.append(health_text(facts["health"]))
    return printable_lines("\n".join(parts))


def printable_lines(text: str) -> str:
    """Return a text whose lines move no cursor."""
    return "".join(f"{printable(line)}\n" for line in text.split("\n")[:-1])


def _heading(facts: dict[str, Any]) -> str:
    base = "floating base" if facts["floating"] else "fixed base"
    dof = counted(facts["dof"], "degree")
    mass = mass_text(facts)
    mass = f"mass {mass}" if mass.startswith(UNKNOWN) else mass
    return f"{facts['robot'] or '(unnamed)'}: {base}, {dof} of freedom, {mass}\n"


def _verdict(target: str, verdict: dict[str, Any]) -> str:
    if verdict["reads"]:
        return f"{target} reads it\n"
    places = verdict["places"]
    first = places[0]
    return (
        f"{target} refuses it, {counted(len(places), 'place')}: "
        f"{first['line']}:{first['column']} {first['message']}\n"
    )


def _tree_rows(facts: dict[str, Any]) -> Iterator[tuple[str, ...]]:
    yield "link", "id", "joint", "", "mass", "frames"
    is_of_base = False
    for are_last, body in branches(facts):
        is_of_base = body is facts["base"] or (is_of_base and bool(are_last))
        branch = "".join("   " if is_last else "│  " for is_last in are_last[:-1])
        branch += ("└─ " if are_last[-1] else "├─ ") if are_last else ""
        yield (
            ("" if is_of_base else "  " if are_last else "? ")
            + branch
            + (body["name"] or "(unnamed)"),
            "-" if body["id"] is None else str(body["id"]),
            body["joint"] or "",
            body["joint_type"] or "",
            number(body["mass"], "kg"),
            " ".join(body["frames"]),
        )


def _parameters(parameters: list[dict[str, Any]]) -> str:
    rows = [("parameter", "kind", "value", "range", "bound by", "places")]
    for parameter in parameters:
        unit = PARAMETER_UNITS[parameter["kind"]]
        ends = parameter["min"], parameter["max"]
        span = "" if ends == (None, None) else f"{number(ends[0])} … {number(ends[1])}"
        places = " ".join(f"{use['line']}:{use['column']}" for use in parameter["uses"][:4])
        more = " …" if len(parameter["uses"]) > 4 else ""
        rows.append(
            (
                parameter["name"],
                parameter["kind"],
                number(parameter["value"], unit),
                span,
                parameter["origin"] or "nothing",
                places + more,
            )
        )
    return aligned(rows, frozenset((2,)))


def health_text(health: dict[str, Any]) -> str:
    """Return the section for people: the verdict, counts by subject, the gravest findings."""
    rows = [("health", health["verdict"])]
    for name, counts in health["subjects"].items():
        if counts["error"] or counts["warning"]:
            parts = (counted(counts[kind], kind) for kind in ("error", "warning") if counts[kind])
            rows.append((f"  {name}", ", ".join(parts)))
    gravest = health["findings"][:_MOST_TOLD]
    lines = [f"  {f['line']}:{f['column']}  [{f['code']}] {f['message']}\n" for f in gravest]
    left = len(health["findings"]) - len(gravest)
    if left:
        lines.append(f"  and {left} more, see kindsl lint\n")
    return aligned(rows) + "".join(lines)
