"""What is said about a mistake, and that the repair mends it."""

import re

import pytest
from tests.support import robots
from tests.support.mutants import messages
from tests.support.syntax_checks import repaired

from kindsl.language.syntax.document import parse

MODEL = robots.STUB

MENDED = [
    ("(0.0, 0.1, 0.3)", "(0.0, 1, 0.3)", "KD005", "number '1' has no decimal point"),
    ("(0.0, 0.1, 0.3)", "(0.0, 1/3, 0.3)", "KD005", "number '1' has no decimal point"),
    ("(0.0, 0.1, 0.3)", "(0,0, 0.1, 0.3)", "KD005", "'0,0' is not a number"),
    ("mass = 2.0", "mass = 2,5", "KD005", "'2,5' is not a number"),
    ("mass = 2.0", "mass = 2,5E-3", "KD005", "'2,5E-3' is not a number"),
    ("(0.0, 0.1, 0.3)", "(0.0, 1,5e-2, 0.3)", "KD005", "'1,5e-2' is not a number"),
    ("mass = 2.0", "mass = 1_000.0", "KD005", "'1_000.0' is not a number"),
    ("mass = 2.0", "mass = 0x10", "KD005", "'0x10' is not a number"),
    ("mass = 2.0", "mass = 1.5+0.5", "KD006", "sum '1.5+0.5' where the language has no sums"),
    ("mass = 2.0", "mass = (2.0)", "KD006", "parentheses in '(2.0)' where the language has none"),
    (
        "(PI/2.0,",
        "(3.0*PI/4.0,",
        "KD006",
        "expression '3.0*PI/4.0' is of a form that no generator takes",
    ),
    ("(0.0, 0.1, 0.3)", "[0.0, 0.1, 0.3]", "KD001", "vector is enclosed in '[]' instead of '()'"),
    ("(0.0, 0.1, 0.3)", "0.0, 0.1, 0.3", "KD001", "vector is not enclosed in '()'"),
    ("(0.0, 0.1, 0.3)", "(0.0, 0.1, 0.3, 1.0)", "KD001", "vector has 4 components instead of 3"),
    (
        "(0.0, 0.1, 0.3)",
        "0.0 -0.1 1",
        "KD001",
        "expected a vector '(x, y, z)' instead of '0.0 -0.1 1'",
    ),
    (
        "(0.0, 0.1, 0.3)",
        '"0 0.1 0.3"',
        "KD001",
        "expected a vector '(x, y, z)' instead of '0 0.1 0.3'",
    ),
    ("(PI/2.0,", "(90°,", "KD005", "'90°' is not a number"),
    ("(PI/2.0,", "(-90.0°,", "KD005", "'-90.0°' is not a number"),
    ("id = 1", "id = 1.0", "KD005", "id '1.0' is not a natural number"),
    ("via shoulder }", "via shoulder; }", "KD001", "unexpected ';'"),
    ("via shoulder }", "via shoulder, }", "KD001", "unexpected ','"),
    ("link upper", "link up-per", "KD001", "'up-per' is not a name"),
    ("(0.0, 0.1, 0.3)", "(0.0 0.1, 0.3)", "KD001", "expected ',' after '0.0'"),
    ("(0.0, 0.1, 0.3)", "(0.0 0.1 0.3)", "KD001", "expected ',' after '0.0'"),
    ("(0.0, 0.1, 0.3)", "(0.0, -0.1 0.3)", "KD001", "expected ',' after '-0.1'"),
    ("(0.0, 0.1, 0.3)", "(0.0 -0.1 -0.3)", "KD001", "expected ',' after '0.0'"),
    ("(PI/2.0,", "(PI/2.0", "KD001", "expected ',' after '2.0'"),
    ("(0.0, 0.1, 0.3)", "(0.0 0.1 PI/2.0)", "KD001", "expected ',' after '0.0'"),
    ("(0.0, 0.1, 0.3)", "(0.0 PI -PI/2.0)", "KD001", "expected ',' after '0.0'"),
    ("(0.0, 0.1, 0.3)", "(0.0, 0.1, 0.3", "KD001", "expected ')' after '0.3'"),
    ("id = 1", "id 1", "KD001", "expected '=' after 'id'"),
    ("id = 1", "id = 1;", "KD001", "unexpected ';'"),
    ("link upper {", "link upper", "KD001", "expected '{' after 'upper'"),
    ("link upper {", "upper {", "KD001", "expected 'link' before 'upper'"),
    ("link upper {", "Link upper {", "KD010", "unknown keyword 'Link', did you mean 'link'"),
    (
        "r_joint shoulder {",
        "joint shoulder {",
        "KD010",
        "unknown keyword 'joint', did you mean 'r_joint' or 'p_joint'",
    ),
    (
        "r_joint shoulder {",
        "link shoulder {",
        "KD001",
        "expected 'r_joint' or 'p_joint' instead of 'link'",
    ),
    ("children { }", "chidren { }", "KD010", "unknown keyword 'chidren', did you mean 'children'"),
    ("frames {", "{", "KD001", "expected 'frames' after '}'"),
    (
        "        }\n    }\n}\nr_joint",
        "        }\n}\nr_joint",
        "KD002",
        "expected '}' to close 'frames'",
    ),
    ("    }\n}\n}\n", "    }\n}\n", "KD002", "expected '}' to close robot 'arm'"),
    ("link upper {", "link upper {\u00a0", "KD004", "invalid character no-break space (U+00A0)"),
    ("Robot arm", "\ufeffRobot arm", "KD004", "invalid character byte order mark (U+FEFF)"),
    ("link upper", "# the upper arm\nlink upper", "KD001", "'#' does not begin a comment"),
    ("    id = 1\n", "    id = 1 /* why\n", "KD003", "comment is not closed by '*/'"),
    (
        "mass = 2.0 CoM = (0.0, 0.0, 0.2)",
        "CoM = (0.0, 0.0, 0.2) mass = 2.0",
        "KD007",
        "'mass' stands after 'CoM'",
    ),
    (
        "Ix=0.3 Iy=0.3 Iz=0.1",
        "Ix=0.3 Ix=0.3 Iz=0.1",
        "KD009",
        "'inertia_params' has two 'Ix' and no 'Iy'",
    ),
    ("id = 1", "id = 1 id = 1", "KD009", "link 'upper' has a second 'id'"),
    ("link upper {", "}\nlink upper {", "KD001", "unexpected '}'"),
]

TOLD = [
    ("id = 1\n", "\n", "KD008", "link 'upper' has no 'id'"),
    ("id = 1", "id = 0", "KD005", "id '0' is not a natural number"),
    ("id = 1", "id = 1.5", "KD005", "id '1.5' is not a natural number"),
    ("id = 1", "id = 3000000000", "KD005", "id '3000000000' is larger than 2147483647"),
    ("Ixy=0.0", "", "KD008", "'inertia_params' has no 'Ixy'"),
    ("children { }", "", "KD008", "link 'upper' has no 'children'"),
    (
        "children { upper via shoulder }",
        "children { upper via }",
        "KD001",
        "expected a name after 'via'",
    ),
    ("mass = 2.0", "mass = ", "KD001", "expected a number after '='"),
    ("mass = 2.0", "mass = sqrt(2.0)", "KD006", "function 'sqrt' where the language has none"),
    (
        "(0.0, 0.1, 0.3)",
        "(0.0, sin(PI/2.0), 0.3)",
        "KD006",
        "function 'sin' where the language has none",
    ),
    ("(0.0, 0.1, 0.3)", "(0.0, 0.1)", "KD001", "vector has 2 components instead of 3"),
    ("(0.0, 0.1, 0.3)", "(0.0 PI/2.0)", "KD001", "vector has 2 components instead of 3"),
    ("(0.0, 0.1, 0.3)", "(0.0PI/2.0)", "KD001", "vector has 2 components instead of 3"),
    ("(0.0, 0.1, 0.3)", "", "KD001", "expected a vector '(x, y, z)' after '='"),
    ("link upper", "link 1upper", "KD001", "'1upper' is not a name"),
    ("Robot arm {\n", "", "KD008", "expected 'Robot NAME {' before base 'base'"),
    ("link upper {", "link {", "KD001", "expected a name after 'link'"),
    ("mass = 2.0", "children = 2.0", "KD001", "expected 'mass' instead of 'children'"),
    ("mass = 2.0", "id = 2.0", "KD001", "expected 'mass' instead of 'id'"),
    (
        "translation = (0.0, 0.0, 0.3)",
        "children = (0.0, 0.0, 0.3)",
        "KD001",
        "expected 'translation' instead of 'children'",
    ),
    (
        "translation = (0.0, 0.1, 0.3)",
        "inertia_params = (0.0, 0.1, 0.3)",
        "KD001",
        "expected 'translation' instead of 'inertia_params'",
    ),
    (" }\n}\nlink upper {", "\n{", "KD001", "expected 'link' before '{'"),
    ("    }\n}\n}\n", "    }\n}\n}\nstray\n", "KD001", "unexpected 'stray'"),
]


def changed(old: str, new: str) -> str:
    assert old in MODEL
    return MODEL.replace(old, new, 1)


def test_a_misspelt_block_behind_a_mistake_does_not_hide_it() -> None:
    text = changed("r_joint shoulder", "Joint shoulder").replace("children { }", "children { ; }")
    assert [entry[2] for entry in messages(parse(text))] == [
        "unexpected ';'",
        "unknown keyword 'Joint', did you mean 'r_joint' or 'p_joint'",
    ]
    text = changed("via shoulder }\n}\nlink", "via shoulder; }\n}\nLink")
    assert [entry[2] for entry in messages(parse(text))] == [
        "unexpected ';'",
        "unknown keyword 'Link', did you mean 'link'",
    ]


def test_the_model_is_correct() -> None:
    assert messages(parse(MODEL)) == []


@pytest.mark.parametrize(("old", "new", "code", "message"), [*MENDED, *TOLD])
def test_one_mistake_is_told_once(old: str, new: str, code: str, message: str) -> None:
    assert [entry[1:] for entry in messages(parse(changed(old, new)))] == [(code, message)]


@pytest.mark.parametrize(("old", "new"), [case[:2] for case in MENDED])
def test_the_repair_mends_it(old: str, new: str) -> None:
    assert messages(parse(repaired(parse(changed(old, new))))) == []


@pytest.mark.parametrize(
    ("written", "meant"),
    [("2,5", "2.5"), ("2,5E-3", "0.0025"), ("-1,5e3", "-1500.0"), ("1,0E-3", "0.001")],
)
def test_a_decimal_comma_keeps_the_number(written: str, meant: str) -> None:
    old, new = (changed("mass = 2.0", f"mass = {text}") for text in (written, meant))
    assert repaired(parse(old)) == new


@pytest.mark.parametrize("mass", ["2.0", "m", "m[2.0]"])
@pytest.mark.parametrize("swapped", ["= CoM (0.0,", "= (CoM 0.0,"])
def test_what_is_swapped_is_moved_back(mass: str, swapped: str) -> None:
    text, n = re.subn(r"2.0(\s+)CoM = \(0.0,", rf"{mass}\1{swapped}", MODEL, count=1)
    assert n == 1
    document = parse(text)
    assert len(messages(document)) == 1
    (island,) = (island for island in document.islands if island.problems)
    (problem,) = island.problems
    assert problem.repair is not None
    assert problem.repair.title.startswith("Move '")
    assert messages(parse(repaired(document))) == []


def test_blocks_out_of_order_are_moved() -> None:
    start, end = MODEL.index("link upper"), MODEL.index("r_joint")
    text = MODEL[:start] + MODEL[end:-2] + MODEL[start:end] + "}\n"
    document = parse(text)
    message = "joint 'shoulder' stands before link 'upper'"
    assert [entry[1:] for entry in messages(document)] == [("KD007", message)]
    assert messages(parse(repaired(document))) == []


@pytest.mark.parametrize("text", ["", "  \n"])
def test_an_empty_document_is_no_error(text: str) -> None:
    assert messages(parse(text)) == []


def test_a_document_of_comments() -> None:
    assert messages(parse("// nothing\n")) == [(0, "KD008", "document has no robot")]


def test_a_second_robot() -> None:
    second = MODEL.replace("arm", "leg")
    told = messages(parse(MODEL + second))
    assert told == [(len(MODEL), "KD009", "second robot 'leg' in one document")]


def test_an_empty_piece_is_no_misspelt_keyword() -> None:
    assert messages(parse("r_joint l { CoM = (1.0) , l via j"))


@pytest.mark.parametrize(
    ("half", "message"),
    [
        ("upper", "expected 'via' after 'upper'"),
        ("upper via", "expected a name after 'via'"),
        ("upper via shoulder\n        low", "expected 'via' after 'low'"),
        ("low\n        upper via shoulder", "expected 'via' after 'low'"),
    ],
)
def test_half_a_child_is_told_by_what_it_lacks(half: str, message: str) -> None:
    told = messages(parse(changed("upper via shoulder", half)))
    assert [text for _, _, text in told] == [message]


@pytest.mark.parametrize(
    "words",
    [
        "Ixx Iyy Izz Ixy Ixz Iyz",
        "ixx iyy izz ixy ixz iyz",
        "IXX IYY IZZ IXY IXZ IYZ",
        "i_xx i_yy i_zz i_xy i_xz i_yz",
    ],
)
def test_moments_of_other_formats_mean_one_word_each(words: str) -> None:
    text = MODEL
    for word, other in zip(words.split(), ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz"), strict=True):
        text = re.sub(rf"\b{other}(?=\s*=)", word, text)
    document = parse(text)
    assert {code for _, code, _ in messages(document)} == {"KD010"}
    mended = repaired(document)
    assert messages(parse(mended)) == []
    assert mended == MODEL


@pytest.mark.parametrize(
    ("word", "meant"),
    [
        ("com", "CoM"),
        ("COM", "CoM"),
        ("xyz", "translation"),
        ("origin", "translation"),
        ("rpy", "rotation"),
    ],
)
def test_words_of_other_formats(word: str, meant: str) -> None:
    text = changed(f"{meant} =", f"{word} =")
    (told,) = messages(parse(text))
    assert told[1:] == ("KD010", f"unknown keyword '{word}', did you mean '{meant}'")
    (problem,) = [p for island in parse(text).islands for p in island.problems]
    assert problem.repair is not None
    assert problem.repair.title == f"Replace '{word}' with '{meant}'"
