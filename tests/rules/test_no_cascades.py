"""One mistake gives one message: every single slip of some kind in a good model."""

import itertools
import random
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.support.amount import usually
from tests.support.models import Style, random_model
from tests.support.mutants import lumps, mutants

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.fixing import fixed, is_fixable
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.language.syntax.document import parse

MODEL = random_model(12, 3, Style(has_expressions=True))
N_MUTANTS = usually(100, thoroughly=250)
SETTINGS = Settings(bindings={"offset": Binding(0.1)})
EDGE = re.compile(r"(segment_\d+) via (joint_\d+)")
BLOCK = re.compile(r"^(?:link|r_joint|p_joint) (\w+) \{", re.MULTILINE)


def remarks(text: str) -> list[Diagnostic]:
    found = analyse(text, SETTINGS).findings
    return [finding for finding in found if finding.severity in ("error", "warning")]


def replaced(pattern: re.Pattern[str], group: int, new: str) -> Iterator[str]:
    for match in pattern.finditer(MODEL):
        start, end = match.span(group)
        yield MODEL[:start] + match.expand(new) + MODEL[end:]


def blocks() -> Iterator[tuple[str, int, int]]:
    document = parse(MODEL)
    for start, island in zip(document.starts, document.islands, strict=True):
        if BLOCK.match(island.text):
            node = island.nodes[0]
            yield node.kind, start + node.start, start + node.end


def test_model_is_good() -> None:
    assert remarks(MODEL) == []


@pytest.mark.parametrize(
    ("pattern", "group", "new", "codes"),
    [
        pytest.param(EDGE, 1, r"segmnt_\1", {"KD105"}, id="unknown link in a pair"),
        pytest.param(EDGE, 1, r"gripper", {"KD105"}, id="quite unknown link in a pair"),
        pytest.param(EDGE, 2, r"x\2", {"KD106"}, id="unknown joint in a pair"),
        pytest.param(EDGE, 0, r"\2 via \1", {"KD105"}, id="pair the wrong way round"),
        pytest.param(EDGE, 0, r"\1 via \2 \1 via \2", {"KD207"}, id="pair twice"),
        pytest.param(EDGE, 1, r"trunk", {"KD206"}, id="base in a pair"),
        pytest.param(EDGE, 0, r"", {"KD203"}, id="pair left out"),
        pytest.param(BLOCK, 1, r"x\1", {"KD105", "KD106"}, id="block renamed"),
        pytest.param(BLOCK, 1, r"other", {"KD105", "KD106"}, id="block named quite differently"),
        pytest.param(re.compile(r"id = (\d+)\n    inertia"), 1, "70", {"KD109"}, id="id too great"),
    ],
)
def test_slip_gives_one_message(
    pattern: re.Pattern[str], group: int, new: str, codes: set[str]
) -> None:
    texts = list(replaced(pattern, group, new))
    assert texts
    for text in texts:
        found = remarks(text)
        assert len(found) == 1, [(f.code, f.message) for f in found]
        assert found[0].code in codes


@pytest.mark.parametrize("unit", ["kg", "g", " kg"])
@pytest.mark.parametrize("section", ["mass", "CoM", "Ix", "Ixy"])
def test_unit_behind_a_number_of_an_inertia_gives_one_message(section: str, unit: str) -> None:
    number = re.compile(rf"\b{section} = \(?(-?\d*\.\d+)\b")
    texts = list(replaced(number, 1, rf"\1{unit}"))
    assert len(texts) > 6
    for text in texts:
        assert [f.code for f in remarks(text)] == ["KD408"]
    for text in replaced(number, 1, "12kg"):
        assert [f.code for f in remarks(text)] == ["KD005"]


@pytest.mark.parametrize(
    ("mass", "codes"),
    [
        ("2.0", ["KD405"]), ("2", ["KD405", "KD005"]), ("payload", []),
        ("2.0kg", ["KD408"]), ("(payload)", ["KD006"]),
    ],
)  # fmt: skip
def test_a_slip_in_the_mass_beside_parametric_moments(mass: str, codes: list[str]) -> None:
    inertia = "Ix = payload/2.0 Iy = payload/2.0 Iz = payload/2.0"
    text = re.sub(r"mass = \S+", f"mass = {mass}", MODEL, count=1)
    text = re.sub(r"Ix = \S+\s+Iy = \S+\s+Iz = \S+", inertia, text, count=1)
    settings = Settings(bindings={**SETTINGS.bindings, "payload": Binding(2.0)})
    found = [f.code for f in analyse(text, settings).findings if f.severity != "info"]
    assert [code for code in found if code[:3] in ("KD0", "KD4")] == codes


def test_wrong_but_known_name_in_a_pair_gives_one_message() -> None:
    generator = random.Random(7)
    names = [f"segment_{number}" for number in range(1, 13)]
    joints = [f"joint_{number}" for number in range(1, 13)]
    for group, choice in ((1, names), (2, joints)):
        for match in EDGE.finditer(MODEL):
            new = generator.choice([name for name in choice if name != match[group]])
            text = MODEL[: match.start(group)] + new + MODEL[match.end(group) :]
            found = remarks(text)
            assert len(found) == 1, [(f.code, f.message) for f in found]
            assert found[0].code in {"KD201", "KD202", "KD205", "KD207"}


def test_a_loop_hides_no_defect_elsewhere() -> None:
    loop = MODEL.replace("segment_12 via joint_12", "segment_2 via joint_12")
    assert {f.code for f in remarks(loop)} == {"KD201"}
    pose = "translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0)"
    spare = f"r_joint spare {{ ref_frame {{ {pose} }} }}\n"
    with_spare = re.sub("(?=[rp]_joint joint_1 )", spare, loop)
    assert {f.code for f in remarks(with_spare)} == {"KD201", "KD203"}
    apart = loop.replace("segment_11 via joint_11", "")
    assert sorted(f.code for f in remarks(apart)) == ["KD201", "KD203"]


def test_duplicate_id_gives_one_message() -> None:
    for number in range(2, 13):
        text = MODEL.replace(f"id = {number}\n    inertia", f"id = {number - 1}\n    inertia")
        assert [finding.code for finding in remarks(text)] == ["KD101"]


def test_block_left_out_gives_one_message() -> None:
    assert len(list(blocks())) == 24
    for kind, start, end in blocks():
        found = remarks(MODEL[:start] + MODEL[end:])
        assert [f.code for f in found] == [{"link": "KD105", "joint": "KD106"}[kind]]


def test_block_written_twice_gives_one_message() -> None:
    for kind, start, end in blocks():
        found = remarks(f"{MODEL[:end]}\n{MODEL[start:]}")
        assert [f.code for f in found] == [{"link": "KD102", "joint": "KD103"}[kind]]


def test_a_lump_of_lost_tokens_gives_few_messages() -> None:
    """At most two of a lump in 99.5 % (`benchmarks/lost_tokens.py`), never more than three."""
    model = random_model(3, 3, Style(has_expressions=False))
    counts = [
        len(remarks(mutant.text))
        for mutant in itertools.islice(lumps(model, random.Random(23)), 60)
    ]
    assert sum(count > 2 for count in counts) <= 1
    assert max(counts) <= 3


@pytest.mark.parametrize(
    ("lost", "message"),
    [
        (r"\}\s*link segment_2 \{", "expected 'link' before 'id'"),
        (r"\}\s*link (?=segment_2 \{)", "expected 'link' before 'segment_2'"),
        (r"link segment_2 (?=\{)", "expected 'link' before '{'"),
        (r"\}\s*link segment_1 \{", "expected 'link' before 'id'"),
        (r"\}\s*r_joint joint_2 \{(?=\s*id)", "expected 'r_joint' or 'p_joint' before 'id'"),
        (r"r_joint joint_1 \{(?=\s*id)", "expected 'r_joint' or 'p_joint' before 'id'"),
        (r"\}\s*r_joint joint_1 \{(?=\s*id)", "expected 'r_joint' or 'p_joint' before 'id'"),
    ],
)
def test_a_lost_head_is_one_mistake(lost: str, message: str) -> None:
    text = re.sub(lost, "", MODEL, count=1)
    assert text != MODEL
    assert [finding.message for finding in remarks(text)] == [message]


def test_syntax_error_invents_nothing_elsewhere() -> None:
    n_broken = 0
    for mutant in random.Random(11).sample(list(mutants(MODEL)), N_MUTANTS):
        found = remarks(mutant.text)
        syntax = [f for f in found if f.code.startswith("KD0")]
        assert not syntax or found == syntax, (mutant, found)
        n_broken += bool(syntax)
    assert n_broken > 0.4 * N_MUTANTS


def test_syntax_error_silences_nothing_elsewhere() -> None:
    seeded = MODEL.replace("id = 12\n", "id = 11\n", 1)
    names = {"segment_11", "segment_12"}
    for mutant in random.Random(13).sample(list(mutants(seeded)), N_MUTANTS):
        if not names & mutant.touched and mutant.kind != "truncate":
            assert any(f.code in ("KD101", "KD102", "KD105") for f in remarks(mutant.text)), mutant


def test_a_fix_gives_no_joint_to_two_pairs() -> None:
    good = (Path(__file__).parents[2] / "examples" / "quadruped.kindsl").read_text()
    text = re.sub(r"r_joint R[FH]_HAA \{.*?\n\}\n", "", good, flags=re.DOTALL)
    assert [f.code for f in remarks(text)] == ["KD106", "KD106"]
    result = fixed(analyse(text, SETTINGS), is_fixable).analysis
    assert "KD205" not in {finding.code for finding in result.findings}


POSES = random_model(4, 4, Style(has_expressions=False))
POSES = POSES.replace(
    "tip_4 {", "side { translation = (0.1, 0.2, 0.3) rotation = (0.0, 0.0, 0.0) } tip_4 {"
)
POSES = re.sub(r"(Iyz = \S+)(?=\s+\}\s+children \{\s+\}\s+frames)", r"\1 ref_frame = side", POSES)
VECTOR = r"\(([^,()]+), ([^,()]+), ([^,()]+)\)"


@pytest.mark.parametrize(
    ("wanted", "new"),
    [
        (VECTOR + r"(\s+rotation = )\(([^,()]+), ", r"(\1, \2, \3 (\5, "),
        (VECTOR + r"(\s+rotation = )\(([^,()]+), ", r"(\1, \2\4(\5, "),
        (r"rotation = " + VECTOR, r"rotation = (PI/-PI/2.0)"),
        (r"rotation = " + VECTOR, r"rotation = (PI/2.0 0.0)"),
        (r"rotation = " + VECTOR, r"rotation = ((\1, \2, \3)"),
        (r"rotation = " + VECTOR + r"\s+\}\s+\w+ \{(\s+translation)", r"rotation = (\1, \2, \3)\4"),
        (r"ref_frame = \w+\s+\}\s+children", "ref_frame"),
    ],
)
def test_a_pose_that_is_torn_gives_one_message(wanted: str, new: str) -> None:
    places = list(re.finditer(wanted, POSES))
    assert places
    for match in places:
        text = POSES[: match.start()] + match.expand(new) + POSES[match.end() :]
        assert len(remarks(text)) <= 1, [(f.code, f.message) for f in remarks(text)]


def test_an_empty_body_before_sections_has_one_brace_too_many() -> None:
    text = re.sub(r"\}\s+(link segment_2 \{)", r"\1 }", MODEL)
    assert text != MODEL
    assert [f.message for f in remarks(text)] == [
        "expected '}' to close link 'segment_1'",
        "unexpected '}'",
    ]


def test_a_link_stays_one_where_its_children_stand_in_a_reference_frame() -> None:
    text = re.sub(r"(Iyz = \S+)\s+\}\s+children (?=\{\s+segment_3)", r"\1 ref_frame ", POSES)
    assert text != POSES
    assert len(remarks(text)) <= 2, [(f.code, f.message) for f in remarks(text)]


HEAD = r"\s{0} \w+ \{{\s+{1}(?= )"


@pytest.mark.parametrize(
    ("lost", "messages"),
    [
        (HEAD.format("link", "id"), ["expected 'link' before '='"]),
        (HEAD.format("[rp]_joint", "id"), ["expected 'r_joint' or 'p_joint' before '='"]),
        (HEAD.format("[rp]_joint", "ref_frame"), ["expected 'r_joint' or 'p_joint' before '{'"]),
    ],
)
def test_a_head_lost_with_the_section_behind_it_is_one_mistake(
    lost: str, messages: list[str]
) -> None:
    model = MODEL if "id" in lost else re.sub(r"(joint \w+ \{)\s+id = \d+", r"\1", MODEL)
    for text in (model, re.sub(r"//.*|\s+", " ", model)):
        places = list(re.finditer(lost, text))
        assert len(places) >= 10
        for match in places:
            found = remarks(text[: match.start()] + " " + text[match.end() :])
            assert [f.message for f in found] == messages


def test_a_head_lost_behind_a_base_of_many_frames_is_one_mistake() -> None:
    pose = "{ translation = (0.1, 0.2, 0.3) rotation = (0.0, 0.0, 0.0) }"
    frames = "".join(f"        mount_{n} {pose}\n" for n in range(60))
    text, n = re.subn(
        r"(\n    \})\n\}\s+link segment_1 \{",
        rf"\1\n    frames {{\n{frames}    }}\n",
        MODEL,
        count=1,
    )
    assert n == 1
    assert [f.message for f in remarks(text)] == ["expected 'link' before 'id'"]
