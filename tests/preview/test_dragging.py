"""What a page may drag: tried out while it moves, written once when it is dropped."""

import asyncio

import pytest
from tests.preview.robots import ARM, PARAMETRIC_ARM

from kindsl.frontends.preview.channel import Tab
from kindsl.frontends.preview.document_preview import DocumentPreview
from kindsl.frontends.preview.dragging import Dragging
from kindsl.frontends.preview.requests import BadRequestError, Reveal, parse_request, request_of
from kindsl.frontends.preview.reveal import place_of as place_of_click
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.analysis.translated_robot import analysed_robot
from kindsl.language.text.edits import apply_edits
from kindsl.robots.scene.encoding import as_dict

URDF = """<robot name="arm"><link name="base"/><link name="upper"/>
<joint name="lift" type="prismatic"><parent link="base"/><child link="upper"/></joint></robot>"""
PENDULUM = """Robot pendulum {
RobotBase base { children { rod via hinge } }
link rod { id = 1
    inertia_params {
        mass = 2.0 CoM = (0.0, 0.0, 0.3)
        Ix = 0.2 Iy = 0.2 Iz = 0.01 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0
    }
    children {}
}
r_joint hinge { ref_frame { translation = (0.0, 0.0, 1.0) rotation = (PI/2.0, 0.0, 0.0) } }
}
"""


class Page:
    """One page of a document whose text is kept here."""

    def __init__(self, text: str, refusal: str = "") -> None:
        self.preview = DocumentPreview("arm")
        self.writings: list = []
        self.refusal = refusal
        self.dragging = Dragging(self.preview, self._write)
        self.preview.show(analyse(text), ())
        self.messages: list = []
        self.tab = Tab(self._take)
        self.preview.channel.join(self.tab)

    async def ask(self, **request):
        request.setdefault("revision", self.preview.revision)
        await self.dragging.receive(request_of(request))
        self.messages += list(self.tab._waiting.values())
        self.tab._waiting.clear()

    def last(self, kind: str):
        return next((as_dict(m) for m in reversed(self.messages) if m.type == kind), None)

    def state(self, kind: str):
        return [as_dict(m) for m in self.preview.channel.state if m.type == kind]

    async def _write(self, writing):
        self.writings.append(writing)
        if not self.refusal:
            self.preview.show(analyse(apply_edits(writing.text, writing.edits)), ())
        return self.refusal

    async def _take(self, change):
        self.messages += change.parts


def drag(phase="move", component="x", value=0.55, step=0.01, **more):
    thing = {"type": "drag", "kind": "joint", "name": "lift", "component": component}
    return {**thing, "value": value, "step": step, "phase": phase, **more}


def look_of(page, link):
    return next(m["look"] for m in page.state("solid") if m["name"] == link)


def place_of(page, joint):
    return next(list(m["placement"][12:15]) for m in page.state("joint") if m["name"] == joint)


@pytest.fixture
def page():
    return Page(ARM)


async def test_what_is_grasped_shows_its_numbers(page):
    await page.ask(type="grasp", kind="joint", name="shoulder")
    handles = page.last("handles")
    assert [c["component"] for c in handles["components"]] == ["x", "y", "z", "rx", "ry", "rz"]
    assert [c["text"] for c in handles["components"]][2:4] == ["0.5", "PI/2.0"]
    await page.ask(type="grasp", kind="joint", name="")
    assert not page.state("handles")


async def test_a_number_follows_the_parameter_that_carries_it():
    page = Page(PARAMETRIC_ARM)
    await page.ask(type="grasp", kind="joint", name="lift")
    page.preview.set_parameters({"reach": 0.3})
    assert page.state("handles")[0]["components"][0]["value"] == 0.3
    await page.ask(**drag("drop", value=0.45))
    assert page.state("handles")[0]["components"][0]["value"] == 0.45
    assert not page.writings


async def test_moving_draws_and_checks_but_writes_nothing(page):
    for value in (0.41, 0.47, 0.553):
        await page.ask(**drag(value=value))
    assert place_of(page, "lift") == [0.55, 0.0, 0.0]
    assert page.last("dragged")["text"] == "0.55"
    assert page.preview.analysis.text == ARM and not page.writings
    await page.ask(**drag("cancel"))
    assert place_of(page, "lift") == [0.4, 0.0, 0.0]
    assert page.last("dragged")["phase"] == "cancel"


async def test_dropping_writes_one_number(page):
    await page.ask(**drag(value=0.553))
    await page.ask(**drag("drop", value=0.553))
    (writing,) = page.writings
    assert writing.label == "Set x of joint 'lift'"
    assert page.preview.analysis.text == ARM.replace("(0.4, 0.0, 0.0)", "(0.55, 0.0, 0.0)")
    assert place_of(page, "lift") == [0.55, 0.0, 0.0]


async def test_an_impossible_text_is_told_while_it_moves():
    page, thing = Page(ARM), {"kind": "com", "name": "upper"}
    looks = [look_of(page, "upper")]
    for value in (0.9, 4.0):
        await page.ask(**drag("move", "x", value, None) | thing)
        assert page.state("finding")
        looks.append(look_of(page, "upper"))
    await page.ask(**drag("cancel") | thing)
    assert not page.state("finding")
    assert [*looks, look_of(page, "upper")] == ["sound", "impossible", "impossible", "sound"]


@pytest.mark.parametrize(
    ("vector", "component", "reason"),
    [
        ("(0.4, , 0.0)", "y", "component y of joint 'lift' is missing"),
        ("(4..4, 0.0, 0.0)", "x", "'4..4' is not a valid value"),
        ("(a+b, 0.0, 0.0)", "x", "'a+b' is not a valid value"),
    ],
)
async def test_in_a_broken_text_what_is_whole_can_be_dragged(vector, component, reason):
    page = Page(ARM.replace("(0.4, 0.0, 0.0)", vector))
    await page.ask(type="grasp", kind="joint", name="lift")
    locked = {c["component"]: c["locked"] for c in page.last("handles")["components"]}
    assert {c: why for c, why in locked.items() if why} == {component: reason}
    await page.ask(**drag("drop", component, 0.7))
    assert page.last("dragged")["reason"] == reason and not page.writings
    await page.ask(**drag("drop", "z", 0.25))
    (writing,) = page.writings
    assert [edit.text for edit in writing.edits] == ["0.25"]


async def test_an_edit_of_an_older_text_is_refused(page):
    await page.ask(**drag("drop", revision=page.preview.revision - 1))
    assert page.last("dragged")["reason"] == "the document has changed in the meantime"
    assert not page.writings


async def test_a_urdf_is_shown_with_its_lines_and_not_edited(page):
    page.preview.show(analysed_robot("arm.urdf", URDF, Settings()), ())
    await page.ask(type="grasp", kind="joint", name="lift")
    assert not page.state("handles") and not page.state("editing")
    await page.ask(**drag("drop"))
    assert page.last("dragged")["reason"].startswith("only a .kindsl document is edited here")
    assert not page.writings
    span = place_of_click(Reveal("joint", "lift"), page.preview.analysis, ())
    assert URDF[span.start : span.end] == "lift"


def test_a_link_whose_name_the_language_has_not_is_found_in_its_file():
    text = URDF.replace('"upper"', '"upper-arm"').replace('"lift"', '"link"')
    analysis = analysed_robot("arm.urdf", text, Settings())
    (link,), (joint,) = analysis.model.links, analysis.model.joints
    assert (str(link.name), str(joint.name)) == ("upper_arm", "link_")
    spans = [analysis.resolver.span(each) for each in (link, joint)]
    assert [text[slice(*span)] for span in spans] == ["upper-arm", "link"]


async def test_what_cannot_be_written_stays_as_it_was():
    page = Page(ARM, "permission denied")
    await page.ask(**drag())
    await page.ask(**drag("drop"))
    assert page.last("dragged")["reason"] == "permission denied"
    assert place_of(page, "lift") == [0.4, 0.0, 0.0]


async def test_the_page_is_answered_when_the_new_version_is_shown():
    page = Page(ARM)

    async def write_later(writing):
        new = analyse(apply_edits(writing.text, writing.edits))
        asyncio.get_running_loop().call_later(0.02, page.preview.show, new, ())
        return ""

    page.dragging._write = write_later
    await page.ask(**drag("drop", value=0.55))
    assert page.preview.revision == 2
    kinds = [message.type for message in page.messages]
    assert kinds.index("editing") < kinds.index("dragged")


@pytest.mark.parametrize(
    ("request_", "kind"),
    [(drag("drop"), "dragged"), ({"type": "plan", "gesture": "undo"}, "plan")],
    ids=["drag", "plan"],
)
async def test_a_page_is_answered_whatever_fails(page, capsys, request_, kind):
    async def fail(_writing):
        raise ZeroDivisionError

    await page.ask(**drag("drop", value=0.7))
    page.dragging._write = fail
    await page.ask(**request_)
    assert page.last(kind)["reason"] == "internal error"
    assert capsys.readouterr().err == "internal error in the preview: ZeroDivisionError()\n"


async def test_only_a_drop_that_changes_the_text_is_told_as_written(page):
    await page.ask(**drag(value=0.5))
    assert page.last("dragged")["written"] is False
    await page.ask(**drag("drop", value=0.5))
    assert page.last("dragged")["written"] is True


async def test_what_was_dragged_is_taken_back_and_made_again(page):
    await page.ask(**drag("drop", value=0.55))
    await page.ask(**drag("drop", value=0.7))
    for gesture, x in (("undo", "0.55"), ("undo", "0.4"), ("redo", "0.55"), ("redo", "0.70")):
        await page.ask(type="plan", gesture=gesture)
        assert page.preview.analysis.text == ARM.replace("(0.4, 0.0", f"({x}, 0.0")
    await page.ask(type="plan", gesture="redo")
    assert page.last("plan")["reason"] == "there is nothing to redo"


async def test_what_somebody_typed_since_is_never_taken_back(page):
    await page.ask(**drag("drop", value=0.55))
    page.preview.show(analyse(page.preview.analysis.text + "\n"), ())
    await page.ask(type="plan", gesture="undo")
    assert page.last("plan")["reason"] == "the document has changed since"
    assert len(page.writings) == 1


async def test_a_gesture_is_a_ghost_until_it_is_accepted(page):
    plan = {"type": "plan", "gesture": "add-child", "name": "slider", "point": [0.1, 0.0, 0.2]}
    await page.ask(**plan)
    assert page.last("plan")["title"] == "Add link 'link1' to 'slider' by joint 'joint1'"
    assert any("/ghost/" in m.path for m in page.preview.channel.state) and not page.writings
    await page.ask(**plan, accepted=True)
    assert "link link1" in page.preview.analysis.text
    assert not any("/ghost/" in m.path for m in page.preview.channel.state)


async def test_the_pose_becomes_the_new_zero(page):
    plan = {"type": "plan", "gesture": "pose-as-zero", "joints": {"shoulder": 0.5}}
    await page.ask(**plan)
    assert page.last("plan")["title"] == "Write this pose as the new zero"
    # Nothing moves: a ghost would be turned by the joints once more.
    assert not any("/ghost/" in m.path for m in page.preview.channel.state) and not page.writings
    await page.ask(**plan, accepted=True)
    assert "rotation = (PI/2.0, 0.0, 0.5)" in page.preview.analysis.text


async def test_an_impossible_body_is_told_while_its_com_moves():
    page = Page(PENDULUM)
    com = {"kind": "com", "name": "rod", "component": "z"}
    await page.ask(**drag(**com, value=0.31))
    assert page.last("dragged")["warning"] == ""
    await page.ask(**drag(**com, value=0.5))
    warning = page.last("dragged")["warning"]
    assert warning.startswith("inertia of 'rod' is not positive definite: ")
    await page.ask(**drag("drop", **com, value=0.5))
    dropped = page.last("dragged")
    assert dropped["written"] and dropped["warning"] == warning
    # It is impossible already.
    await page.ask(**drag(**com, value=0.6))
    assert page.last("dragged")["warning"] == ""


async def test_the_moments_move_along_with_a_com():
    page = Page(PENDULUM)
    com = {"kind": "com", "name": "rod", "component": "z", "carries": True}
    await page.ask(**drag(**com, value=0.5))
    assert page.last("dragged")["warning"] == ""
    await page.ask(**drag("drop", **com, value=0.5))
    changed = {
        "(0.0, 0.0, 0.3)": "(0.0, 0.0, 0.5)",
        "Ix = 0.2": "Ix = 0.52",
        "Iy = 0.2": "Iy = 0.52",
    }
    wanted = PENDULUM
    for old, new in changed.items():
        wanted = wanted.replace(old, new)
    assert page.preview.analysis.text == wanted
    assert page.writings[-1].label == "Set z of com 'rod' with its moments"
    await page.ask(**drag(**{**com, "kind": "joint", "name": "hinge"}, value=0.5))
    assert not page.last("dragged")["reason"]


async def test_moments_with_parameters_stay_where_they_are():
    page = Page(PENDULUM.replace("Ix = 0.2", "Ix = a"))
    await page.ask(**drag("drop", kind="com", name="rod", component="z", carries=True))
    assert page.last("dragged")["reason"] == "the moments of 'rod' are not six plain numbers"
    assert not page.writings


@pytest.mark.parametrize(
    "text",
    [
        '{"type":"drag"}',
        '{"type":"drag","kind":"joint","name":"j","component":"x","value":NaN,"phase":"move","revision":1}',
        '{"type":"drag","kind":"wheel","name":"j","component":"x","value":1,"phase":"move","revision":1}',
        '{"type":"drag","kind":"joint","name":"j","component":"x","value":1,"phase":"jump","revision":1}',
        '{"type":"plan","gesture":"rm","name":"j","revision":1}',
        '{"type":"plan","gesture":"add-frame","name":"j","point":[1,2],"revision":1}',
        '{"type":"plan","gesture":"add-frame","name":"j","point":[1,2,"text"],"revision":1}',
        '{"type":"grasp","kind":"com","name":7}',
    ],
)
def test_nonsense_is_no_request(text):
    with pytest.raises(BadRequestError):
        parse_request(text)


async def test_a_document_that_nobody_writes_has_no_handles():
    preview = DocumentPreview("arm")
    preview.show(analyse(ARM), ())
    await asyncio.sleep(0)
    assert not [m for m in preview.channel.state if m.type == "editing"]
