"""One document's preview over time: sliders, parameters, ghosts, findings, places."""

import math
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.preview.page import Page
from tests.preview.robots import ARM, BROKEN_ARM, PARAMETRIC_ARM

from kindsl.frontends.preview.comparing import document_robot
from kindsl.frontends.preview.document_preview import DocumentPreview
from kindsl.frontends.preview.findings import MOST_LISTED
from kindsl.frontends.preview.requests import Reveal
from kindsl.frontends.preview.reveal import place_of
from kindsl.frontends.preview.server import PreviewServer
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.rules.base import Severity
from kindsl.language.semantics.parameters import Binding, JointProperties


def preview_of(text, settings=None, findings=()):
    preview = DocumentPreview("arm")
    preview.show(analyse(text, settings or Settings()), findings)
    return preview


def page_of(preview):
    return Page(preview.channel.state)


def joint_x(preview, joint="lift"):
    return page_of(preview).at(f"/kindsl/robot/joints/{joint}")["joint"]["placement"][12]


def look_of(preview, link):
    return page_of(preview).at(f"/kindsl/robot/links/{link}/solid")["solid"]["look"]


def status(preview):
    return page_of(preview).at("/kindsl/status")["status"]


def test_a_broken_edit_keeps_the_model_and_a_repair_brings_the_new_one():
    preview = preview_of(ARM)
    preview.show(analyse(BROKEN_ARM.replace("0.4,", "0.6,")), ())
    assert (status(preview)["state"], joint_x(preview)) == ("broken", 0.4)
    preview.show(analyse(ARM.replace("0.4,", "0.6,")), ())
    assert (status(preview)["state"], joint_x(preview)) == ("live", 0.6)


def test_a_base_alone_is_drawn_already():
    start = ARM.index("link ", ARM.index("RobotBase"))
    base = re.sub(r"children\s*\{[^}]*\}", "children {}", ARM[:start]) + "}"
    assert status(preview_of(base))["state"] == "live"


@given(st.floats(allow_nan=True, allow_infinity=True))
def test_joint_values_survive_every_reload(number):
    preview = preview_of(ARM)
    preview.set_joint("shoulder", number)
    preview.show(analyse(BROKEN_ARM), ())
    preview.show(analyse(ARM.replace("0.4,", "0.6,")), ())
    kept = page_of(preview).at("/kindsl/values/shoulder")
    assert kept == {} if not math.isfinite(number) else kept["value"]["value"] == number


def test_a_parameter_is_typed_kept_and_given_back():
    preview = preview_of(PARAMETRIC_ARM.replace("(reach,", "(reach[0.4],"))
    row = page_of(preview).at("/kindsl/parameters/reach")["parameter"]
    assert (row["value"], row["minimum"], row["maximum"]) == (0.4, 0.0, 0.8)
    preview.set_parameters({"reach": 0.7})
    preview.show(analyse(PARAMETRIC_ARM.replace("(reach,", "(reach[0.5],")), ())
    assert joint_x(preview) == 0.7
    assert page_of(preview).at("/kindsl/parameters/reach")["parameter"]["is_overridden"]
    preview.set_parameters({"reach": None})
    assert joint_x(preview) == 0.5


def test_a_typed_value_is_judged_in_the_picture():
    text = ARM.replace("mass = 2.0", "mass = heavy[2.0]")
    preview = preview_of(text)
    assert look_of(preview, "upper") == "sound"
    preview.set_parameters({"heavy": 2000.0})
    assert look_of(preview, "upper") == "impossible"
    preview.show(analyse(text), ())
    assert look_of(preview, "upper") == "impossible"
    preview.set_parameters({"heavy": None})
    assert look_of(preview, "upper") == "sound"


def test_a_configured_range_is_the_sliders():
    settings = Settings(bindings={"reach": Binding(0.35, 0.2, 0.5)})
    row = page_of(preview_of(PARAMETRIC_ARM, settings)).at("/kindsl/parameters/reach")["parameter"]
    assert (row["value"], row["minimum"], row["maximum"]) == (0.35, 0.2, 0.5)


def test_configured_limits_reach_the_page_and_leave_it():
    preview = preview_of(
        ARM, Settings(joints={"lift": JointProperties(None, 0.2), "x": JointProperties()})
    )
    assert {k.path for k in page_of(preview).state if k.type == "limits"} == {"/kindsl/limits/lift"}
    told = page_of(preview).at("/kindsl/limits/lift")["limits"]
    assert (told["minimum"], told["maximum"]) == (None, 0.2)
    preview.show(analyse(ARM), ())
    assert page_of(preview).at("/kindsl/limits/lift") == {}


def test_a_parameter_without_a_value_has_a_row_with_a_guess():
    preview = preview_of(PARAMETRIC_ARM)
    row = page_of(preview).at("/kindsl/parameters/reach")["parameter"]
    assert (row["value"], row["is_guess"]) == (0.5, True)
    assert (row["minimum"], row["maximum"]) == (0.0, 1.0)
    assert status(preview)["state"] == "guessed"
    assert page_of(preview).at("/kindsl/robot/joints/lift")["joint"]["is_guess"]
    preview.set_parameters({"reach": 0.3})
    assert status(preview)["state"] == "live"


def test_a_page_from_before_a_restart_brings_its_values():
    preview = preview_of(PARAMETRIC_ARM)
    preview.set_joint("lift", 0.1)
    preview.adopt({"lift": 0.9, "shoulder": 0.5}, {"reach": 0.3})
    page = page_of(preview)
    assert page.at("/kindsl/values/lift")["value"]["value"] == 0.1
    assert page.at("/kindsl/values/shoulder")["value"]["value"] == 0.5
    assert joint_x(preview) == 0.3


def test_a_page_cannot_fill_the_memory(monkeypatch):
    monkeypatch.setattr("kindsl.frontends.preview.document_preview.MOST_VALUES", 5)
    preview = preview_of(ARM)
    for number in range(100):
        preview.set_joint(f"joint{number}", 0.1)
        preview.set_parameters({f"parameter{number}": 0.1})
    preview.set_joint("joint0", 0.2)
    values = [key.path for key in page_of(preview).state if key.type == "value"]
    assert len(values) == len(preview._parameters) == 5
    assert page_of(preview).at("/kindsl/values/joint0")["value"]["value"] == 0.2


def ghosts(preview):
    return [key.path for key in page_of(preview).state if key.path.startswith("/kindsl/ghost/")]


def test_the_saved_version_stands_behind_an_edited_one_only():
    preview = preview_of(ARM)
    preview.keep_as_ghost()
    assert ghosts(preview) == []
    preview.show(analyse(ARM.replace("mass = 1.0", "mass = 1.5")), ())
    assert ghosts(preview) == []
    preview.show(analyse(ARM.replace("0.4,", "0.6,")), ())
    assert "/kindsl/ghost/links/upper/body/ball" in ghosts(preview)
    preview.keep_as_ghost()
    assert ghosts(preview) == []


def test_another_document_stands_behind():
    preview = preview_of(ARM)
    other = analyse(ARM.replace("0.4,", "0.6,"))
    preview.compare(document_robot("other.kindsl", lambda: other))
    assert ghosts(preview)


def finding(code, start, end, severity=Severity.ERROR, message="broken"):
    return Diagnostic(code, "name", severity, message, start, end)


def test_findings_are_listed_the_worst_first_with_their_places():
    found = [finding("KD701", 0, 5, Severity.INFORMATION), finding("KD101", ARM.index("link"), 90)]
    page = page_of(preview_of(ARM, findings=found))
    first = page.at("/kindsl/findings/0")["finding"]
    assert (first["code"], first["line"], first["column"]) == ("KD101", 9, 1)
    assert page.at("/kindsl/findings/1")["finding"]["severity"] == "info"


def test_what_was_found_stays_listed_until_it_is_known_for_the_next_version():
    preview = preview_of(ARM, findings=[finding("KD101", 0, 1)])
    longer = analyse(ARM.replace("0.4,", "0.6,"))
    preview.put(longer, preview.drawing(longer))
    assert joint_x(preview) == 0.6
    assert status(preview)["total"] == 1
    assert page_of(preview).at("/kindsl/findings/0")
    preview.list_findings([])
    assert status(preview)["total"] == 0
    assert not page_of(preview).at("/kindsl/findings/0")


def test_a_body_looks_as_the_listed_findings_say():
    heavy = analyse(ARM.replace("Iz = 0.12", "Iz = 0.34"))
    preview = preview_of(ARM)
    preview.put(heavy, preview.drawing(heavy))
    assert look_of(preview, "upper") == "sound"
    preview.list_findings(heavy.findings)
    assert look_of(preview, "upper") == "impossible"
    longer = analyse(heavy.text.replace("0.4,", "0.6,"))
    preview.put(longer, preview.drawing(longer))
    assert (look_of(preview, "upper"), look_of(preview, "slider")) == ("impossible", "sound")
    sound = analyse(ARM)
    drawing = preview.drawing(sound)
    preview.list_findings(longer.findings)
    preview.put(sound, drawing)
    preview.list_findings(sound.findings)
    assert look_of(preview, "upper") == "sound"


async def test_a_version_is_drawn_once_and_then_only_told_of(monkeypatch):
    drawn = []
    drawing = DocumentPreview.drawing
    monkeypatch.setattr(
        DocumentPreview, "drawing", lambda self, a: drawn.append(a) or drawing(self, a)
    )
    server, analysis = PreviewServer(), analyse(ARM)
    await server.show("arm", analysis)
    await server.show("arm", analysis, [finding("KD101", 0, 1)])
    assert drawn == [analysis]
    assert status(server.document(None))["total"] == 1


def test_of_many_findings_some_are_listed_and_all_are_counted():
    preview = preview_of(ARM, findings=[finding("KD101", 0, 1)] * 500)
    listed = [key for key in page_of(preview).state if key.type == "finding"]
    assert len(listed) == MOST_LISTED
    assert status(preview)["total"] == 500


@pytest.mark.parametrize(
    ("kind", "name", "text"),
    [
        ("link", "slider", "slider {"),
        ("link", "base", "base {"),
        ("joint", "lift", "lift {"),
        ("frame", "tool", "tool {"),
        ("parameter", "reach", "reach, 0.0, 0.0)"),
    ],
)
def test_a_click_means_the_name_where_it_is_declared(kind, name, text):
    analysis = analyse(PARAMETRIC_ARM)
    span = place_of(Reveal(kind, name), analysis, ())
    assert span is not None
    assert PARAMETRIC_ARM[span.start :].startswith(text)
    assert PARAMETRIC_ARM[span.start : span.end] == name


def test_a_click_on_what_is_gone_means_nothing():
    assert place_of(Reveal("link", "gone"), analyse(ARM), ()) is None
    assert place_of(Reveal("finding", "3"), analyse(ARM), ()) is None
    assert place_of(Reveal("finding", "-1"), analyse(ARM), [finding("KD101", 1, 2)]) is None


def test_a_finding_means_what_it_marks():
    assert place_of(Reveal("finding", "0"), analyse(ARM), [finding("KD101", 3, 7)]) == (3, 7)


def test_undecodable_bytes_in_a_message_can_be_sent():
    from kindsl.robots.scene.encoding import encode

    preview = preview_of(ARM, findings=[finding("KD004", 0, 1, message="byte '\udcff'")])
    assert all(encode(message) for message in preview.channel.state)
