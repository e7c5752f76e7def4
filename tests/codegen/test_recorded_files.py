"""Every file of every language, for documents and options that take all ways through the emitters.

The length and a digest of each are in `recorded`, a file a language; how they get there:
`tests/support/recorded.py`. What a changed digest is about, `kindsl generate` shows before and
after. That the numbers in the code are right is tested elsewhere.
"""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.codegen.documents import DOCUMENTS, DRIVES, TRANSFORMS
from tests.codegen.robcogen.test_classes import VALUES
from tests.codegen.robots import ALL, STAMP
from tests.support.recorded import assert_as_recorded

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.products.codegen.generating import Source, generate
from kindsl.products.codegen.language import language_named, language_names
from kindsl.products.codegen.library import Library, Options
from kindsl.products.codegen.manifest import NAME
from kindsl.robots.interchange.generated_folder import digest

RECORDED = Path(__file__).parent / "recorded"
# A number of so many digits that processors may not agree on the last, or on the sign of what is
# but rounding; and the zero that it may be.
LONG = re.compile(r"-?\b\d+\.\d{7,}(?:e[+-]\d+)?|-?\b\d\.?\d*e-[1-9]\d\b|-0\.0\b")
# Products of short numbers may end in a 5 that would be rounded either way.
OFF_HALVES = 3e-11
SOME = ("poses", "jacobians", "foot_jacobians", "inverse_dynamics", "joint_space_inertia",
        "energies", "forward_dynamics")  # fmt: skip
PLAIN = {
    "real": "double", "is_single_header": False, "parameters": "unbound", "prefix": "arm",
    "quantities": SOME,
}  # fmt: skip
ALL_PARAMETERS: dict[str, object] = {"parameters": "all"}
PLAINLY: list[tuple[str, dict[str, object]]] = [
    *((document, ALL_PARAMETERS) for document in ("arm", "crab")),
    *((document, {}) for document in ("one", "odd", "driven", "reach", "chain")),
]
FOR_ROBCOGEN: list[tuple[str, dict[str, object]]] = [
    (document, ALL_PARAMETERS)
    for document in ("arm", "crab", "odd", "light", "one", "reach", "angle", "chain", "driven")
]
CASES: dict[str, list[tuple[str, dict[str, object]]]] = {
    "c": [
        ("arm", {"quantities": ALL}),
        *PLAINLY,
        ("crab", {"quantities": ALL}),
        ("arm", {"is_single_header": True}),
        ("arm", {"real": "float"}),
        ("arm", {"is_single_header": True, "real": "float"}),
        ("crab", {"is_single_header": True, "parameters": "reach, bend"}),
        ("crab", {"frames": ("fr_claw", "tip")}),
    ],
    "casadi": PLAINLY[:2],
    "cpp": [("arm", {"quantities": ALL}), *PLAINLY, ("arm", {"real": "float"})],
    "jax": PLAINLY[:2],
    "octave": FOR_ROBCOGEN,
    "python": [("arm", {"quantities": ALL}), *PLAINLY, ("arm", {"quantities": ("energies",)})],
    "robcogen": [
        *FOR_ROBCOGEN,
        ("long", {}),
        ("long_parameters", {}),
        ("crab", {"frames": ("fr_claw",)}),
        ("odd", {"layout": "robcogen", "prefix": "other"}),
        ("arm", {"layout": "robcogen", "has_runtime": True}),
        ("arm", {"layout": "robcogen-0.5"}),
    ],
}


def generated(
    language: str, document: str, options: dict[str, object]
) -> tuple[Library, dict[str, str]]:
    """Return a library and the text of each of its files by its name."""
    bound = {name: Binding(value) for name, value in VALUES.items() if document == "crab"}
    joints = DRIVES if document == "driven" else {}
    text = DOCUMENTS["arm" if document == "driven" else document]
    analysis = kindsl.parse(text, Settings(bindings=bound, joints=joints, version="2.1"))
    source = Source("arm.kindsl", analysis, {}, TRANSFORMS.get(document))
    return generate(source, Options(language, **{**PLAIN, **options}), STAMP)


def _rounded(number: re.Match[str]) -> str:
    return f"{round(float(number[0]) + OFF_HALVES, 9) + 0.0}"


def told(language: str) -> Iterator[str]:
    for document, options in CASES[language]:
        shown = {name: x if x != ALL else "all" for name, x in options.items()}
        yield f"# {document}, {shown}"
        library, files = generated(language, document, options)
        if renamed := language_named(language).renamed(library):
            yield f"renamed {dict(renamed)}"
        for name, text in files.items():
            if name != NAME:
                content = digest(LONG.sub(_rounded, text).encode())[:12]
                yield f"{name}: {text.count(chr(10))} lines, {content}"


@pytest.mark.parametrize("language", language_names())
def test_all_files_are_as_recorded(language: str) -> None:
    assert_as_recorded(RECORDED / f"{language}.txt", told(language))
