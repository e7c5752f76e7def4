"""XML of strangers: elements with their lines, or one sentence."""

import pytest

from kindsl.robots.interchange import xml_reading
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf
from kindsl.robots.interchange.xml_reading import XmlError, finite_number, parsed_xml

ROBOT = '<robot name="é">\n<link name="a"/><!-- a\n b --><link\n name="b"/>\n</robot>'


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16", "iso-8859-1", "windows-1252"])
def test_elements_know_where_they_begin(encoding: str) -> None:
    text = f'<?xml version="1.0" encoding="{encoding}"?>{ROBOT}'
    root = parsed_xml(text.encode(encoding))
    assert [root.get("name"), *(link.get("name") for link in root)] == ["é", "a", "b"]
    assert [element.sourceline for element in root.iter()] == [1, 2, 3]


def test_names_are_what_is_written_whether_declared_or_not() -> None:
    text = b'<a xmlns="u" xmlns:d="v w"><d:b/><e:b e:x="1"/><?pi?>t<![CDATA[<]]><!-- c -->u</a>'
    root = parsed_xml(text)
    assert [root.tag, *(child.tag for child in root)] == ["a", "d:b", "e:b"]
    assert root[1].tail == "t<u"


def test_a_document_type_without_entities_does_no_harm() -> None:
    assert parsed_xml(b'<!DOCTYPE robot SYSTEM "robot.dtd"><robot/>').tag == "robot"


def test_a_text_may_be_as_long_as_the_limit_and_as_deep(monkeypatch) -> None:
    deepest = "<a>" * 256 + "</a>" * 256
    assert len(list(parsed_xml(deepest).iter())) == 256
    monkeypatch.setattr(xml_reading, "_LARGEST", 4)
    assert parsed_xml("<r/>").tag == "r"
    with pytest.raises(XmlError, match="longer than"):
        parsed_xml("<ro/>")


@pytest.mark.parametrize(
    ("word", "value"),
    [("1e50", 1e50), ("-1e50", -1e50), ("1.5e50", None), ("-1.5e50", None), ("0x1", None)],
)
def test_a_number_has_a_measure(word: str, value: float | None) -> None:
    assert finite_number(word) == value


LAUGHS = "".join(f'<!ENTITY l{i} "{f"&l{i - 1};" * 10}">' for i in range(1, 10))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (f'<!DOCTYPE r [\n<!ENTITY l0 "ha">{LAUGHS}]><r>&l9;</r>', "entity declared at line 2"),
        ('<!DOCTYPE r [<!ENTITY e SYSTEM "file:///etc/passwd">]><r a="&e;"/>', "entity declared"),
        ('<!DOCTYPE r [<!ENTITY % e "x">]><r/>', "entity declared at line 1"),
        ("<r>&nbsp;</r>", "not well-formed XML at line 1"),
        ("<a>\n" * 100_000, "nested deeper than 256 at line 257"),
        ("<a>" + "<b/>" * 9 + "<a>\n" * 256, "nested deeper than 256 at line 256"),
        ("<r>" + " " * 2**26 + "</r>", "longer than 64 MB"),
        ('<?xml version="1.0" encoding="klingon"?><r/>', "encoding that is not supported"),
        ('<?xml version="1.0" encoding="gb2312"?><r/>', "encoding that is not supported"),
        ("<r a='\0'/>", "not well-formed XML at line 1"),
        ("", "not well-formed XML at line 1"),
        ("<r a='1'\na='2'/>", "not well-formed XML at line 2: duplicate attribute"),
        ("<r>\n</r><r/>", "at line 2: nothing may follow </r> in line 2$"),
        ("<r>\n</r>\n\n</r>", "at line 4: nothing may follow </r> in line 2$"),
        ("<r>\n<a b=1/></r>", "at line 2: unexpected '1': a value needs quotes$"),
        ("<r>\n<a b='c & d'/></r>", "unexpected ' ': '&' has to be written '&amp;'$"),
        ("<r>\n<!-- a -- b --></r>", "unexpected ' ': '--' must not be in a comment$"),
        ("<r>\n<ä/><a\n<b/></r>", "at line 3: unexpected '<'$"),
        ("<r>\n<a b='\x01'/></r>", "at line 2: invalid character$"),
        ("<r>\n<a>\n<b/>\n", "not well-formed XML at line 2: <a> is not closed$"),
        ("<r>\n<a>\n<b/>\n</r>", "at line 4: <a> in line 2 is not closed$"),
        ("<r>\n<a>\n<b/>\n</r", "not well-formed XML at line 4: unclosed token"),
    ],
    ids=lambda value: value[:20],
)
def test_an_attack_ends_in_one_sentence(text: str, told: str) -> None:
    with pytest.raises(XmlError, match=told) as caught:
        parsed_xml(text.encode())
    assert "\n" not in str(caught.value) and not str(caught.value).endswith(".")
    with pytest.raises(FormatError, match=f"not a readable URDF: .*{told}"):
        robot_of_urdf(text.encode(), "robot")
