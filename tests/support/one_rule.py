"""What one rule says of a document, or of single blocks; no rule may fail meanwhile."""

from tests.support.example_documents import document_of
from tests.support.examples import link, robot

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding

MOMENTS = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")


def found(code: str, text: str, *targets: str, **values: float | Binding) -> list[Diagnostic]:
    """Return a rule's findings for targets, with values of parameters or values with ranges."""
    bindings = {n: v if isinstance(v, Binding) else Binding(v) for n, v in values.items()}
    settings = Settings(frozenset(targets), ("KD",), bindings=bindings)
    analysis = analyse(document_of(text), settings)
    assert analysis.faults == ()
    return [finding for finding in analysis.findings if finding.code == code]


def told(code: str, text: str, *targets: str, **values: float | Binding) -> list[str]:
    """Return a rule's messages."""
    return [finding.message for finding in found(code, text, *targets, **values)]


def told_as(
    code: str, text: str, *targets: str, **values: float | Binding
) -> list[tuple[str, str]]:
    """Return a rule's severities and messages."""
    return [(f.severity, f.message) for f in found(code, text, *targets, **values)]


def section(mass: object, com: str, *moments: object) -> str:
    """Return an inertia of these numbers; products that are not given are zero."""
    numbers = [*moments, *["0.0"] * (6 - len(moments))]
    given = " ".join(f"{name}={number}" for name, number in zip(MOMENTS, numbers, strict=True))
    return f"inertia_params {{ mass = {mass} CoM = ({com}) {given} }}"


def body(mass: object, com: str, *moments: object) -> str:
    """Return a link with an inertia of these numbers."""
    return link("ball", 1, inertia=section(mass, com, *moments))


def with_base(word: str, inertia: str) -> str:
    """Return a document whose base, `floating` or not, has an inertia."""
    text = robot(link("leg", 1), base="leg via hip", joints="hip")
    return text.replace("ground {", f"ground {word} {{ {inertia}")


def row(*sections: str, names: str = "upper lower hand") -> str:
    """Return links with these inertias, side by side."""
    words = names.split()
    links = [link(w, n, inertia=s) for n, (w, s) in enumerate(zip(words, sections, strict=True), 1)]
    base = " ".join(f"{word} via to_{word}" for word in words)
    return robot(*links, base=base, joints=" ".join(f"to_{word}" for word in words))
