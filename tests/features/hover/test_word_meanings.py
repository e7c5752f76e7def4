from tests.features.samples import COMMENTED, PARAMETRIC

from kindsl.frontends.features.semantic_tokens import semantic_tokens
from kindsl.judgement.analysis.analysis import analyse


def meanings(text):
    return {text[t.start : t.end]: (t.type, *t.modifiers) for t in semantic_tokens(analyse(text))}


def test_words_get_the_type_of_what_they_mean():
    found = meanings(PARAMETRIC)
    assert found["link"] == ("keyword",)
    assert found["Gripper"] == ("namespace", "declaration")
    assert found["slide"] == ("method", "declaration")
    assert found["grip"] == ("property", "declaration")
    assert found["width"] == ("parameter",)
    assert found["m"] == ("parameter", "modification")
    assert found["offset"] == ("variable", "readonly")
    assert found["0.05"] == ("number",)


def test_a_keyword_used_as_a_name_is_a_name():
    assert meanings("Robot R { RobotBase b {} link hip { id = 1 } p_joint id { } }")["id"] in (
        ("method", "declaration"),
        ("keyword",),
    )


def test_comments_come_line_by_line():
    found = meanings(COMMENTED)
    assert found["/* a block"] == ("comment",)
    assert found["   comment */"] == ("comment",)


def test_a_range_gives_what_touches_it():
    analysis = analyse(PARAMETRIC)
    start = PARAMETRIC.index("link finger")
    found = semantic_tokens(analysis, start, start + 4)
    assert [PARAMETRIC[t.start : t.end] for t in found] == ["link"]
