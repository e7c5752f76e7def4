"""Shapes as meshcat's objects, and messages as bytes and words."""

import json
import math
from itertools import pairwise

import numpy as np
import pytest
import umsgpack

from kindsl.frontends.preview.changes import Key, keyed
from kindsl.robots.scene.encoding import as_json, encode
from kindsl.robots.scene.geometry import (
    ARROW_PROFILE,
    FORCE_PROFILE,
    SIDES,
    Form,
    Mesh,
    Shape,
    lathe,
    lowered,
    triad,
)
from kindsl.robots.scene.messages import (
    Change,
    Delete,
    FindingMessage,
    Handle,
    HandlesMessage,
    SetObject,
    SetTransform,
    StatusMessage,
)
from kindsl.robots.scene.picture import PictureState

# Radii, heights, widths: of bodies, whose radius is 1.
SIZES = {
    Form.BALL: {"radius": 1.0},
    Form.POINT: {"radius": 0.62},
    Form.CYLINDER: {"radiusTop": 1.0, "radiusBottom": 1.0, "height": 1.0},
    Form.DRUM: {"radiusTop": 1.42, "radiusBottom": 1.42, "height": 2.8},
    Form.BLOCK: {"width": 2.2, "height": 2.2, "depth": 4.4},
    Form.SLAB: {"width": 7.0, "height": 7.0, "depth": 1.0},
}
SMOOTHNESS = {"widthSegments", "heightSegments", "radialSegments"}


def corners(mesh: Mesh) -> np.ndarray:
    return np.array(mesh.vertices)[np.array(mesh.faces)]


def volume(mesh: Mesh) -> float:
    """Return what the faces enclose, positive if they are seen from outside."""
    return float(sum(a @ np.cross(b, c) for a, b, c in corners(mesh)) / 6.0)


def is_closed(mesh: Mesh) -> bool:
    """Return whether each edge belongs to two faces that go along it in opposite directions."""
    edges: dict[tuple, int] = {}
    for face in np.round(corners(mesh), 9) + 0.0:
        if np.linalg.norm(np.cross(face[1] - face[0], face[2] - face[0])) < 1e-12:
            continue  # in a tip two corners are one
        for a, b in pairwise([*face.tolist(), face[0].tolist()]):
            edges[tuple(a), tuple(b)] = edges.get((tuple(a), tuple(b)), 0) + 1
    return all(n == edges.get((b, a)) for (a, b), n in edges.items())


def cone_stack(profile) -> float:
    """Return the volume that a profile encloses, from its lowest point to its highest."""
    return sum(
        math.pi * (h2 - h1) * (r1 * r1 + r1 * r2 + r2 * r2) / 3.0
        for (r1, h1), (r2, h2) in pairwise(profile)
    )


@pytest.mark.parametrize(
    "profile", [ARROW_PROFILE, FORCE_PROFILE, ((0.0, 0.0), (1.0, 0.0), (0.0, 3.0))]
)
def test_what_a_profile_sweeps_is_closed_and_seen_from_outside(profile) -> None:
    mesh = lathe(profile)
    assert is_closed(mesh)
    # A polygon of so many sides has a little less area than its circle.
    share = SIDES * math.sin(2.0 * math.pi / SIDES) / (2.0 * math.pi)
    assert volume(mesh) == pytest.approx(share * cone_stack(profile))
    radii = {(round(math.hypot(x, y), 9), z) for x, y, z in mesh.vertices}
    assert radii == set(profile)
    assert len(mesh.vertices) == 2 * SIDES * (len(profile) - 1)


def test_arrows_go_along_z_and_out_of_bodies() -> None:
    assert ARROW_PROFILE[0] == (0.0, -3.0) and ARROW_PROFILE[-1] == (0.0, 7.0)
    assert FORCE_PROFILE[0] == (0.0, 0.0) and FORCE_PROFILE[-1] == (0.0, 1.0)
    for profile in (ARROW_PROFILE, FORCE_PROFILE):
        shaft, head = max(r for r, _ in profile[:3]), max(r for r, _ in profile)
        assert 0.0 < shaft < head and [h for _, h in profile] == sorted(h for _, h in profile)


def test_a_triad_has_a_needle_along_each_axis_in_its_colour() -> None:
    mesh = triad(0.25, 4.0)
    assert is_closed(mesh) and len(mesh.vertices) == 15 and len(mesh.faces) == 18
    # Three pyramids with a square of 0.5 as base.
    assert volume(mesh) == pytest.approx(3 * 0.5**2 * 4.0 / 3.0)
    tips = [v for v in mesh.vertices if max(v) == 4.0]
    assert tips == [(4.0, 0.0, 0.0), (0.0, 4.0, 0.0), (0.0, 0.0, 4.0)]
    assert mesh.colors is not None and len(mesh.colors) == 15
    for n in range(3):
        (color,) = set(mesh.colors[5 * n : 5 * n + 5])
        around = {tuple(np.delete(vertex, n)) for vertex in mesh.vertices[5 * n : 5 * n + 4]}
        assert around == {(x, y) for x in (0.25, -0.25) for y in (0.25, -0.25)}
        assert {vertex[n] for vertex in mesh.vertices[5 * n : 5 * n + 4]} == {0.0}
        assert max(color) == color[n] and list(mesh.vertices[5 * n + 4]).index(4.0) == n


@pytest.mark.parametrize("form", list(Form))
def test_each_form_in_meshcat_s_words(form: Form) -> None:
    shape = lowered(Shape(form, 0x00FF80))
    (found,) = shape["geometries"]
    (material,) = shape["materials"]
    is_triad = form in (Form.TRIAD, Form.SHORT_TRIAD)
    assert shape["object"] == {
        "uuid": shape["object"]["uuid"], "type": "Mesh", "geometry": found["uuid"],
        "material": material["uuid"], "matrix": np.eye(4).ravel().tolist(),
    }  # fmt: skip
    assert material["color"] == 0x00FF80 and material["depthTest"] is True
    assert material["vertexColors"] == (2 if is_triad else 0)
    assert material["type"] == ("MeshBasicMaterial" if is_triad else "MeshLambertMaterial")
    assert (material["side"], material["transparent"], material["opacity"]) == (2, False, 1.0)
    assert material["wireframe"] is False and material["reflectivity"] == 0.5
    if form in SIZES:
        size = {k: v for k, v in found.items() if k not in ("uuid", "type", *SMOOTHNESS)}
        assert size == SIZES[form]
        assert {found[key] for key in SMOOTHNESS & set(found)} <= {20, 50}
    else:
        _assert_is_mesh(found["data"], form)


def _assert_is_mesh(data, form: Form) -> None:
    is_triad = form in (Form.TRIAD, Form.SHORT_TRIAD)
    assert set(data["attributes"]) == ({"position", "color"} if is_triad else {"position"})
    for kind, buffer in (
        *(("f", buffer) for buffer in data["attributes"].values()),
        ("I", data["index"]),
    ):
        assert buffer["array"].typecode == kind and buffer["itemSize"] == 3
        assert buffer["type"] == {"f": "Float32Array", "I": "Uint32Array"}[kind]
        assert buffer["normalized"] is False
    length = {Form.ARROW: 7.0, Form.FORCE: 1.0, Form.TRIAD: 5.0, Form.SHORT_TRIAD: 3.6}[form]
    width = {Form.ARROW: 0.62, Form.FORCE: 1.3, Form.TRIAD: 0.24, Form.SHORT_TRIAD: 0.18}[form]
    points = np.reshape(data["attributes"]["position"]["array"], (-1, 3))
    assert points[:, 2].max() == pytest.approx(length)
    across = points[points[:, 2] < length - 1e-3][:, 0] if not is_triad else points[:4, 1]
    assert across.max() == pytest.approx(width)


def test_what_is_on_top_is_seen_through_other_things_and_shapes_are_told_apart() -> None:
    plain, top = Shape(Form.BALL, 1), Shape(Form.BALL, 1, on_top=True)
    assert lowered(top)["materials"][0]["depthTest"] is False
    assert lowered(plain) is lowered(Shape(Form.BALL, 1))
    names = {lowered(Shape(form, c))["object"]["uuid"] for form in Form for c in (1, 16)}
    assert len(names) == 2 * len(Form)


class TestMessages:
    """Messages by key, as bytes and as JSON."""

    def test_of_two_with_one_key_the_last_stays(self) -> None:
        first, last = SetTransform("/a", (0.0,) * 16), SetTransform("/a", (1.0,) * 16)
        other = Delete("/a")
        assert keyed([first, other, last]) == {
            Key("/a", "set_transform"): last, Key("/a", "delete"): other,
        }  # fmt: skip

    def test_bytes_have_the_shape_and_typed_arrays_by_their_kind(self) -> None:
        shape = Shape(Form.ARROW, 0x123456)
        sent = umsgpack.unpackb(encode(SetObject("/a", shape)))
        assert sent["path"] == "/a" and sent["object"]["metadata"]["type"] == "Object"
        data = sent["object"]["geometries"][0]["data"]
        known = lowered(shape)["geometries"][0]["data"]
        for found, wanted, kind in (
            (data["attributes"]["position"], known["attributes"]["position"], 0x17),
            (data["index"], known["index"], 0x16),
        ):
            assert found["array"].type == kind
            assert found["array"].data == wanted["array"].tobytes()
        assert umsgpack.unpackb(encode(Delete("/a"))) == {"type": "delete", "path": "/a"}

    def test_bytes_that_were_no_text_become_question_marks(self) -> None:
        finding = FindingMessage("/a", 0, "KD004", "error", "\udce4x", 1, 2)
        sent = umsgpack.unpackb(encode(Change(True, (Delete("/a"), finding))))
        assert sent == {
            "type": "change", "is_whole": True,
            "parts": [
                {"type": "delete", "path": "/a"},
                {
                    "type": "finding", "path": "/a", "index": 0, "code": "KD004",
                    "severity": "error", "message": "?x", "line": 1, "column": 2,
                },
            ],
        }  # fmt: skip

    def test_json_has_lists_for_arrays_and_null_for_what_is_no_number(self) -> None:
        row = Handle("x", math.nan, "0.5", "", ("joint 'a' x",), "")
        told = json.loads(as_json(HandlesMessage("joint", "a", 2, "", (row,))))
        assert told == {
            "type": "handles", "path": "/kindsl/handles", "kind": "joint", "name": "a",
            "revision": 2, "frame": "", "can_mirror": False,
            "components": [
                {
                    "component": "x", "value": None, "text": "0.5", "symbol": "",
                    "moves_along": ["joint 'a' x"], "locked": "",
                },
            ],
        }  # fmt: skip
        status = StatusMessage(PictureState.LIVE, "", 1, {"error": 1}, "a", math.inf, "", False)
        told = json.loads(as_json(status))
        assert (told["state"], told["counts"], told["mass"]) == ("live", {"error": 1}, None)
        assert as_json(SetTransform("/a", (0.5, 1))) == (
            '{"type":"set_transform","path":"/a","matrix":[0.5,1]}'
        )
        whole = json.loads(as_json(SetObject("/a", Shape(Form.BALL, 1))))
        arrow = json.loads(as_json(SetObject("/a", Shape(Form.ARROW, 1))))["object"]
        assert isinstance(arrow["geometries"][0]["data"]["index"]["array"], list)
        assert whole["object"]["geometries"][0]["radius"] == 1.0
