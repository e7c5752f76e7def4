"""What stands twice counts once: the first of equal sections, whatever stands between them."""

from collections.abc import Sequence

from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.language.semantics.declarations import Joint, Link, Vector
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.model import Model
from kindsl.language.syntax.document import Chunk, SyntaxDocument, parse
from kindsl.language.syntax.vocabulary import MOMENTS

INERTIA = ("mass", "CoM", *MOMENTS)
POSE = ("translation", "rotation")
steady = settings(deadline=None, derandomize=True, max_examples=60)

wholes = st.integers(1, 99)


def sections(names: Sequence[str]) -> st.SearchStrategy[list[tuple[str, int]]]:
    return st.lists(st.tuples(st.sampled_from(names), wholes), max_size=8)


def firsts(written: Sequence[tuple[str, int]]) -> dict[str, float]:
    return {name: float(value) for name, value in reversed(written)}


def text_of(written: Sequence[tuple[str, int]]) -> str:
    vectors = ("CoM", *POSE)
    return "\n".join(
        f"{name} = ({value}.0, 0.0, 0.0)" if name in vectors else f"{name} = {value}.0"
        for name, value in written
    )


def link(text: str) -> Link:
    (found,) = (k for i in parse(text).islands for k in declarations(i).links)
    return found


def joint(text: str) -> Joint:
    (found,) = (j for i in parse(text).islands for j in declarations(i).joints)
    return found


def first_component(vector: Vector | None) -> float | None:
    return None if vector is None else vector.components[0].literal


@steady
@given(sections(INERTIA))
def test_the_first_of_equal_sections_of_an_inertia_counts(written: list[tuple[str, int]]) -> None:
    inertia = link(
        f"link a {{ id = 1 inertia_params {{ {text_of(written)} }} children {{}} }}"
    ).inertia
    assert inertia is not None
    found: dict[str, float | None] = {name: e.literal for name, e in inertia.moments.items()}
    found["mass"] = inertia.mass.literal if inertia.mass is not None else None
    found["CoM"] = first_component(inertia.com)
    assert {name: value for name, value in found.items() if value is not None} == firsts(written)


@steady
@given(sections(POSE), sections(POSE))
def test_the_first_of_equal_vectors_of_a_frame_counts(
    written: list[tuple[str, int]], again: list[tuple[str, int]]
) -> None:
    frames = "".join(f" ref_frame {{ {text_of(each)} }}" for each in (written, again))
    pose = joint(f"r_joint j {{{frames} }}").pose
    found = {name: first_component(getattr(pose, name)) for name in POSE}
    expected = firsts(written) or firsts(again)
    assert {name: value for name, value in found.items() if value is not None} == expected


@steady
@given(st.lists(wholes, min_size=1, max_size=3), st.lists(wholes, min_size=1, max_size=3))
def test_the_first_id_and_the_first_inertia_of_a_link_count(
    ids: list[int], masses: list[int]
) -> None:
    listed = "".join(f" id = {number}" for number in ids)
    bodies = "".join(f" inertia_params {{ mass = {mass}.0 }}" for mass in masses)
    for text in (listed + bodies, bodies + listed):
        assert joint(f"r_joint j {{{listed} ref_frame {{}} }}").id == ids[0]
        found = link(f"link a {{{text} children {{}} }}")
        assert found.id == ids[0]
        assert found.inertia is not None and found.inertia.mass is not None
        assert found.inertia.mass.literal == float(masses[0])


def test_the_first_frame_of_an_inertia_counts() -> None:
    found = link("link a { id = 1 inertia_params { ref_frame = p ref_frame = q } children {} }")
    assert found.inertia is not None and found.inertia.frame == "p"


words = st.sampled_from(("alpha", "beta", "gamma"))


@steady
@given(st.lists(st.tuples(words, st.booleans()), min_size=1, max_size=4))
def test_a_word_is_mentioned_in_the_broken_text_of_other_islands(
    written: list[tuple[str, bool]],
) -> None:
    blocks = [
        f"link l{n} {{ id = {n} children {{ {word} via {'' if broken else 'j'} }} }}"
        for n, (word, broken) in enumerate(written, 1)
    ]
    islands = [island for block in blocks for island in parse(block).islands]
    model = Model(SyntaxDocument((Chunk(tuple(islands)),)))
    assert [bool(island.problems) for island in islands] == [broken for _, broken in written]
    for word in ("alpha", "beta", "gamma", "delta"):
        mentioned = [
            island for island, w in zip(islands, written, strict=True) if w == (word, True)
        ]
        for island in islands:
            expected = any(other is not island for other in mentioned)
            assert model.is_mentioned_in_broken_text(word, elsewhere_than=island) == expected
