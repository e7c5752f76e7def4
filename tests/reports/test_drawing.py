"""Drawings of robots: where things are on the sheet, in which order, and each shape's words."""

from io import BytesIO
from math import cos, hypot, inf, radians, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.preview.robots import ARM, skeleton_of

from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import transposed, turned
from kindsl.products.reports.drawing.bodies import (
    BODY,
    EDGE,
    JOINTS,
    JUDGED,
    SHADED,
    Deep,
    body_shapes,
    hatching,
)
from kindsl.products.reports.drawing.camera import HEIGHT, WIDTH, Camera, camera_for, depth
from kindsl.products.reports.drawing.robot import (
    AXIS,
    COM,
    FRAME,
    NAME,
    PRESETS,
    _overlap,
    points_of,
    robot_drawing,
)
from kindsl.products.reports.drawing.shapes import Disc, Drawing, Label, Line, Polygon, Spot
from kindsl.products.reports.drawing.svg import svg_text
from kindsl.robots.scene.size import extent
from kindsl.robots.scene.solids import Doubt, link_solids

numbers = st.floats(-5.0, 5.0).map(lambda x: round(x, 3))
points = st.lists(st.tuples(numbers, numbers, numbers), min_size=2, max_size=8, unique=True)
DRAWING = Drawing(
    640.0,
    480.0,
    (
        Line((100.0, 50.0), (200.0, 150.0), 7.0, "7d93ab"),
        Disc((300.0, 60.0), 5.0, "2b4562"),
        Polygon(((1.0, 2.0), (30.0, 2.0), (30.0, 40.0)), "93a6bc", "2b3540", 1.0, 0.4),
        Label((10.0, 20.0), "a_<b>", 12.0, "33404d"),
    ),
)


def discs(drawing: Drawing, color: str) -> list[Disc]:
    return [s for s in drawing.shapes if isinstance(s, Disc) and s.color == color]


def rounded(spot: Spot) -> Spot:
    return round(spot[0], 6), round(spot[1], 6)


def labels(drawing: Drawing) -> dict[str, Label]:
    return {s.text: s for s in drawing.shapes if isinstance(s, Label)}


@given(points)
def test_points_fill_the_sheet_but_for_its_margin_and_stay_in_the_middle(places) -> None:
    camera = camera_for(places)
    xs, ys = zip(*map(camera.spot, places), strict=True)
    width, height = max(xs) - min(xs), max(ys) - min(ys)
    assert width <= WIDTH - 112.0 + 1e-6 and height <= HEIGHT - 112.0 + 1e-6
    if hypot(width, height) > 1e-3:
        assert width == pytest.approx(WIDTH - 112.0) or height == pytest.approx(HEIGHT - 112.0)
    assert (min(xs) + max(xs)) / 2 == pytest.approx(WIDTH / 2)
    assert (min(ys) + max(ys)) / 2 == pytest.approx(HEIGHT / 2)


def test_up_is_up_and_the_camera_stands_to_the_front_right_above() -> None:
    camera = Camera(100.0, (0.0, 0.0))
    turn, rise = radians(50.0), radians(22.0)
    assert camera.spot((0.0, 0.0, 0.0)) == (320.0, 240.0)
    assert camera.spot((0.0, 0.0, 1.0)) == pytest.approx((320.0, 240.0 - 100.0 * cos(rise)))
    across, down = 100.0 * sin(turn), 100.0 * sin(rise) * cos(turn)
    assert camera.spot((1.0, 0.0, 0.0)) == pytest.approx((320.0 + across, 240.0 + down))
    across, up = 100.0 * cos(turn), 100.0 * sin(rise) * sin(turn)
    assert camera.spot((0.0, 1.0, 0.0)) == pytest.approx((320.0 + across, 240.0 - up))
    assert depth((0.0, 0.0, 1.0)) == pytest.approx(sin(rise))
    assert depth((1.0, 0.0, 0.0)) == pytest.approx(cos(rise) * cos(turn))
    assert depth((0.0, 1.0, 0.0)) == pytest.approx(-cos(rise) * sin(turn))


def test_one_point_is_seen_as_if_it_were_a_metre_wide() -> None:
    for places in ([], [(0.0, 0.0, 0.0)]):
        assert camera_for(places) == Camera(WIDTH - 112.0, (0.0, 0.0))


def test_a_camera_looks_where_it_is_told() -> None:
    camera = Camera(10.0, (1.0, 2.0))
    assert camera.spot((0.0, 0.0, 0.0)) == (310.0, 260.0)


def test_what_is_nearer_is_drawn_over_what_is_farther() -> None:
    front, back = "translation = (2.0, 0.0, 0.5)", "translation = (-2.0, 0.0, 0.5)"
    shoulder = "translation = (0.0, 0.0, 0.5)"
    for place, is_above in ((front, True), (back, False)):
        text = ARM.replace(shoulder, place, 1)
        shapes = robot_drawing(skeleton_of(text), colors={"base": "000001"}).shapes
        bodies = [s.color for s in shapes if isinstance(s, Polygon)]
        of_base, others = bodies.index("000001"), [bodies.index(c) for c in (BODY, SHADED)]
        assert of_base < min(others) if is_above else of_base > max(others)


def test_a_core_is_as_large_on_the_sheet_as_it_is() -> None:
    skeleton = skeleton_of(ARM)
    camera = Camera(100.0, (0.0, 0.5))
    solid = link_solids(skeleton, extent(skeleton))[1]
    pose = skeleton.zero_poses[1]
    assert solid.core is not None
    shapes = robot_drawing(skeleton, camera, {"upper": "000001"}).shapes
    (x, y) = camera.spot(pose.point(solid.core.center))
    around = [
        s.corners
        for s in shapes
        if isinstance(s, Polygon) and s.color == "000001"
        if (sum(c[0] for c in s.corners) / 48, sum(c[1] for c in s.corners) / 48)
        == pytest.approx((x, y), abs=1e-6)
    ]
    widths = [max(c[0] for c in own) - min(c[0] for c in own) for own in around]
    turn = radians(50.0)
    right = (sin(turn), cos(turn), 0.0)
    local = turned(transposed(pose.rotation), right)
    far = pose.point(solid.core.support(local))
    assert max(widths) == pytest.approx(2.0 * (camera.spot(far)[0] - x), rel=0.01)


def test_a_bone_is_as_thick_all_around_as_it_is() -> None:
    skeleton = skeleton_of(ARM)
    camera = Camera(100.0, (0.0, 0.5))
    radius = 100.0 * link_solids(skeleton, extent(skeleton))[0].bone
    lone, *_ = body_shapes(skeleton, skeleton.zero_poses, camera, {}, is_solid=False)
    (bone,) = lone.shapes
    assert isinstance(bone, Polygon)
    xs, ys = zip(*bone.corners, strict=True)
    (x, bottom), (_, top) = camera.spot((0.0, 0.0, 0.0)), camera.spot((0.0, 0.0, 0.5))
    assert [min(xs), max(xs)] == pytest.approx([x - radius, x + radius], rel=1e-3)
    assert [min(ys), max(ys)] == pytest.approx([top - radius, bottom + radius], rel=1e-3)


def test_a_bone_is_as_deep_as_its_middle_but_in_front_of_nothing_that_holds_it() -> None:
    skeleton = skeleton_of(ARM)
    poses, camera = skeleton.zero_poses, Camera(100.0, (0.0, 0.5))
    solids = link_solids(skeleton, extent(skeleton))
    for is_solid in (False, True):
        found = list(body_shapes(skeleton, poses, camera, {}, is_solid=is_solid))
        lone, upper, *_ = [thing.depth for thing in found]
        assert lone == pytest.approx(depth((0.0, 0.0, 0.25)))
        core = solids[1].core if is_solid else None
        deepest = depth(poses[1].point(core.center)) if core else inf
        assert upper == pytest.approx(min(depth((0.2, 0.0, 0.5)), deepest))


def test_a_drum_is_as_deep_as_its_front() -> None:
    skeleton = skeleton_of(ARM)
    solids, camera = link_solids(skeleton, extent(skeleton)), Camera(100.0, (0.0, 0.5))
    found = list(body_shapes(skeleton, skeleton.zero_poses, camera, {}, is_solid=False))
    places = [(0.0, 0.0, 0.5), (0.4, 0.0, 0.5)]
    assert [thing.depth for thing in found[-2:]] == pytest.approx(
        [depth(place) + solid.drum for place, solid in zip(places, solids[1:], strict=True)]
    )


def test_a_body_beside_its_bones_hangs_on_a_strut() -> None:
    skeleton = skeleton_of(ARM)
    counts = []
    for place in ((0.2, 0.0, 0.0), (0.2, 0.3, 0.3)):
        x, y, z = place
        moments = (y * y + z * z, x * x + z * z, x * x + y * y)
        a, b, c = (4e-4 + moment for moment in moments)
        small = MassDistribution(1.0, place, (a, b, c, x * y, x * z, y * z))
        masses = (skeleton.masses[0], small, *skeleton.masses[2:])
        shapes = robot_drawing(skeleton.with_masses(masses), colors={"upper": "000001"}).shapes
        counts.append(len([s for s in shapes if isinstance(s, Polygon) and s.color == "000001"]))
    assert counts[1] == counts[0] + 1


def test_solids_are_left_out_where_kinematics_are_to_be_seen() -> None:
    counts = {
        preset: len([s for s in robot_drawing(skeleton_of(ARM), preset=preset).shapes
                     if isinstance(s, Polygon)])
        for preset in PRESETS
    }  # fmt: skip
    assert counts["bodies"] == counts["inertia"] == counts["all"]
    assert counts["kinematics"] == counts["frames"] == counts["bodies"] - 2


def test_a_picture_of_pixels_has_each_shape_where_it_is() -> None:
    image = pytest.importorskip("PIL.Image")
    png = pytest.importorskip("kindsl.products.reports.drawing.png")
    drawing = DRAWING._replace(shapes=DRAWING.shapes[:3])
    picture = image.open(BytesIO(png.png_bytes(drawing)))
    assert picture.size == (640, 480)
    wanted = {
        (150, 100): (0x7D, 0x93, 0xAB), (298, 62): (0x2B, 0x45, 0x62), (25, 10): (0xD4, 0xDB, 0xE4),
        (170, 100): (255, 255, 255), (307, 60): (255, 255, 255),
    }  # fmt: skip
    for place, color in wanted.items():
        assert picture.getpixel(place) == pytest.approx(color, abs=6), place
    assert max(picture.getpixel((30, 20))) < 150
    named = image.open(BytesIO(png.png_bytes(DRAWING._replace(shapes=DRAWING.shapes[3:]))))
    left, top, right, bottom = named.convert("L").point(lambda v: 255 * (v < 160)).getbbox()
    assert 9 <= left <= 12 and 8 <= top <= 13 and 34 <= right <= 56 and 20 <= bottom <= 24


def test_what_is_judged_is_striped_within_its_outline() -> None:
    doubts = {"slider": (Doubt("KD311", "of lead", False),)}
    drawing = robot_drawing(skeleton_of(ARM), doubts=doubts)
    edges = [s for s in drawing.shapes if isinstance(s, Polygon) and s.edge != EDGE]
    stripes = [s for s in drawing.shapes if isinstance(s, Line) and s.color in JUDGED.values()]
    assert len(edges) == 1
    assert len(stripes) > 3
    xs, ys = zip(*edges[0].corners, strict=True)
    for stripe in stripes:
        for x, y in (stripe.start, stripe.end):
            assert min(xs) - 1e-6 <= x <= max(xs) + 1e-6
            assert min(ys) - 1e-6 <= y <= max(ys) + 1e-6


def upper_as(look: str) -> list[Deep]:
    """Return the shapes of a robot whose upper link is a ball, or impossible, by its verdict."""
    skeleton = skeleton_of(ARM)
    place = (0.2, {"glass": -0.8}.get(look, 0.0), 0.0)
    size = {"oversized": 2.0}.get(look, 0.2)
    mass = {"oversized": 0.5}.get(look, 32.0)
    own = 0.4 * mass * size**2
    x, y, _ = place
    moments = (own + mass * y * y, own + mass * x * x, own + mass * (x * x + y * y))
    if look == "impossible":
        moments = (moments[0], moments[1], 1.4 * moments[2])
    body = MassDistribution(mass, place, (*moments, mass * x * y, 0.0, 0.0))
    skeleton = skeleton.with_masses((skeleton.masses[0], body, *skeleton.masses[2:]))
    doubts = {"upper": (Doubt("KD302", "no body", True),)} if look == "impossible" else {}
    (upper,) = link_solids(skeleton, extent(skeleton), doubts)[1:2]
    assert upper.is_oversized if look == "oversized" else upper.look == look
    poses, camera = skeleton.zero_poses, Camera(100.0, (0.0, 0.5))
    farthest = max(hypot(*point) for point in points_of(skeleton))
    assert farthest < 1.5 * hypot(0.4, 0.8)
    return list(body_shapes(skeleton, poses, camera, {}, doubts, is_solid=True))[1:]


@pytest.mark.parametrize(
    ("look", "opacities", "stripes"),
    [("sound", [], set()), ("glass", [0.4], set()), ("oversized", [], set()),
     ("impossible", [0.25], {JUDGED["impossible"]})],
)  # fmt: skip
def test_a_body_is_drawn_as_it_is_judged(
    look: str, opacities: list[float], stripes: set[str]
) -> None:
    shapes = [shape for thing in upper_as(look) for shape in thing.shapes]
    polygons = [shape for shape in shapes if isinstance(shape, Polygon)]
    assert [shape.opacity for shape in polygons if shape.opacity < 1.0] == opacities
    assert {shape.color for shape in shapes if isinstance(shape, Line)} == stripes
    assert polygons[0].color == JUDGED.get(look, SHADED)
    assert len(upper_as("oversized")) == len(upper_as("sound")) - 1


def test_stripes_cross_a_square_from_edge_to_edge() -> None:
    square = ((0.0, 0.0), (12.0, 0.0), (12.0, 12.0), (0.0, 12.0))
    found = list(hatching(square))
    assert found[0] == ((0.0, 3.0), (3.0, 0.0))
    assert len(found) == 4
    assert all(x + y == pytest.approx(u + v) for (x, y), (u, v) in found)


def test_each_thing_has_its_mark_where_it_is() -> None:
    skeleton = skeleton_of(ARM)
    camera = Camera(100.0, (0.0, 0.5))
    drawing = robot_drawing(skeleton, camera)
    shoulder, lift = camera.spot((0.0, 0.0, 0.5)), camera.spot((0.4, 0.0, 0.5))
    for color, place in ((JOINTS["revolute"], shoulder), (JOINTS["prismatic"], lift)):
        (drum,) = (s for s in drawing.shapes if isinstance(s, Polygon) and s.color == color)
        xs, ys = zip(*drum.corners, strict=True)
        middle = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
        assert middle == pytest.approx(place, abs=1e-6)
    # The joints turn by a quarter about x and back: the last link's axes are the base's.
    (tool,) = discs(drawing, FRAME)
    assert tool.center == pytest.approx(camera.spot((0.4, 0.0, 0.8)))
    coms = {camera.spot((0.2, 0.0, 0.5)), camera.spot((0.4, 0.0, 0.6))}
    assert {rounded(d.center) for d in discs(drawing, COM)} == set(map(rounded, coms))
    axes = [s for s in drawing.shapes if isinstance(s, Line) and s.color == AXIS]
    size = hypot(0.4, 0.8)  # of the box around all bodies
    y, z = (0.0, -0.05 * size, 0.5), (0.4, 0.0, 0.5 + 0.05 * size)
    assert {(rounded(axis.start), rounded(axis.end)) for axis in axes} == {
        (rounded(shoulder), rounded(camera.spot(y))),
        (rounded(lift), rounded(camera.spot(z))),
    }


def test_marks_lie_over_bodies_a_little_nearer_and_names_over_all() -> None:
    """A mark is drawn as if it were nearer by a twentieth of the robot's size."""
    shapes = robot_drawing(skeleton_of(ARM), colors={"upper": "000001", "tool": "000002"}).shapes
    colors = [s.color for s in shapes]
    assert colors.index("000001") < colors.index(COM)
    last = max(i for i, s in enumerate(shapes) if isinstance(s, Polygon) and s.color == BODY)
    assert last < colors.index("000002")
    kinds = [type(s) for s in shapes]
    assert kinds.index(Label) > max(i for i, kind in enumerate(kinds) if kind is not Label)


def test_a_fixed_base_and_what_weighs_nothing_have_no_centre_of_mass() -> None:
    heavy = ARM.replace("RobotBase base {", "RobotBase base {\n" + _INERTIA, 1)
    assert heavy != ARM
    assert len(discs(robot_drawing(skeleton_of(heavy)), COM)) == 2
    floating = heavy.replace("RobotBase base", "RobotBase base floating", 1)
    assert len(discs(robot_drawing(skeleton_of(floating)), COM)) == 3
    skeleton = skeleton_of(ARM)
    none = skeleton.with_masses(b._replace(mass=0.0) for b in skeleton.masses)
    assert discs(robot_drawing(none), COM) == []


_INERTIA = """inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0)
    Ix = 0.1 Iy = 0.1 Iz = 0.1 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 }"""


def test_names_stand_beside_their_things_and_none_over_another() -> None:
    camera = Camera(100.0, (0.0, 0.5))
    found = labels(robot_drawing(skeleton_of(ARM), camera))
    x, y = camera.spot((0.0, 0.0, 0.0))
    assert found["base"] == Label((x + 9.0, y - 6.0), "base", 12.0, NAME)
    assert found["upper"].place == pytest.approx(
        (camera.spot((0.0, 0.0, 0.5))[0] + 9.0, camera.spot((0.0, 0.0, 0.5))[1] - 6.0)
    )
    crowded = labels(robot_drawing(skeleton_of(ARM), Camera(1.0, (0.0, 0.0))))
    assert list(crowded) == ["base"]
    chosen = robot_drawing(skeleton_of(ARM), Camera(1.0, (0.0, 0.0)), {"tool": "123456"})
    assert [(n, shape.color) for n, shape in labels(chosen).items()] == [("tool", "123456")]


def test_names_do_not_leave_the_sheet() -> None:
    skeleton = skeleton_of(ARM)
    middle = (-2.95, 0.0)  # the base is 25 pixels from the right edge, the link above it too
    found = labels(robot_drawing(skeleton, Camera(100.0, middle)))
    x, _ = Camera(100.0, middle).spot((0.0, 0.0, 0.0))
    assert x == pytest.approx(615.0)
    assert found["base"].place[0] == pytest.approx(x - 9.0 - 0.6 * 12.0 * len("base"))


@pytest.mark.parametrize(
    ("dx", "dy", "n"),
    [
        pytest.param(0.0, 13.9, 1, id="just above"),
        pytest.param(0.0, 14.1, 2, id="above"),
        pytest.param(0.0, -13.9, 1, id="just below"),
        pytest.param(0.0, -14.1, 2, id="below"),
        pytest.param(7.1, 0.0, 1, id="just beside"),
        pytest.param(7.3, 0.0, 2, id="beside"),
        pytest.param(-7.1, 0.0, 1, id="just beside on the left"),
        pytest.param(-7.3, 0.0, 2, id="beside on the left"),
    ],
)
def test_of_names_that_touch_one_is_left_out(dx: float, dy: float, n: int) -> None:
    """A letter is 7.2 pixels wide, a name 14 high."""
    turn, rise = radians(50.0), radians(22.0)
    across = (sin(turn), cos(turn), 0.0)
    up = (-sin(rise) * cos(turn), sin(rise) * sin(turn), cos(rise))
    x, y, z = (dx * a + dy * b for a, b in zip(across, up, strict=True))
    text = f"""Robot r {{
    RobotBase a {{ children {{ b via j }} }}
    link b {{ id = 1 children {{}} }}
    r_joint j {{ ref_frame {{ translation = ({x:.9f}, {y:.9f}, {z:.9f})
        rotation = (0.0, 0.0, 0.0) }} }} }}"""
    found = labels(robot_drawing(skeleton_of(text), Camera(1.0, (0.0, 0.0))))
    assert len(found) == n


def test_boxes_that_touch_do_not_overlap() -> None:
    box = (1.0, 1.0, 2.0, 2.0)
    for dx, dy in ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)):
        there = (box[0] + dx, box[1] + dy, box[2] + dx, box[3] + dy)
        near = (box[0] + dx / 2, box[1] + dy / 2, box[2] + dx / 2, box[3] + dy / 2)
        assert not _overlap(box, there) and _overlap(box, near)


def test_links_frames_and_joints_take_the_colours_that_are_given() -> None:
    drawing = robot_drawing(skeleton_of(ARM), colors={"slider": "111111", "tool": "222222"})
    own = [s for s in drawing.shapes if s.color == "111111"]
    assert {type(s) for s in own} == {Polygon, Line, Label}
    assert not any(s.color == JOINTS["prismatic"] for s in drawing.shapes)
    assert len(discs(drawing, "222222")) == 1 and not discs(drawing, FRAME)
    assert {n: shape.color for n, shape in labels(drawing).items()}["slider"] == "111111"


def test_all_points_of_a_robot_are_in_its_picture() -> None:
    found = points_of(skeleton_of(ARM))
    wanted = [(0.0, 0.0, 0.0), (0.0, 0.0, 0.5), (0.4, 0.0, 0.5), (0.4, 0.0, 0.8)]
    for place in wanted:
        assert any(point == pytest.approx(place, abs=1e-12) for point in found), place
    camera = camera_for(found)
    for shape in robot_drawing(skeleton_of(ARM)).shapes:
        for x, y in shape.corners if isinstance(shape, Polygon) else ():
            assert 0.0 < x < WIDTH and 0.0 < y < HEIGHT
    assert camera == camera_for([*found, *wanted])


def test_svg_says_each_shape() -> None:
    lines = svg_text(DRAWING).splitlines()
    assert lines[0].endswith('width="640" height="480" viewBox="0 0 640 480">')
    assert lines[1:] == [
        '<rect width="100%" height="100%" fill="#ffffff"/>',
        '<line x1="100.0" y1="50.0" x2="200.0" y2="150.0" stroke="#7d93ab" stroke-width="7"'
        ' stroke-linecap="round"/>',
        '<circle cx="300.0" cy="60.0" r="5.0" fill="#2b4562"/>',
        '<polygon points="1.0,2.0 30.0,2.0 30.0,40.0" fill="#93a6bc" fill-opacity="0.4"'
        ' stroke="#2b3540" stroke-width="1" stroke-linejoin="round"/>',
        '<text x="10.0" y="20.0" font-family="sans-serif" font-size="12" fill="#33404d"'
        ' stroke="#ffffff" stroke-width="3" paint-order="stroke">a_&lt;b&gt;</text>',
        "</svg>",
    ]


def test_what_is_full_says_no_opacity() -> None:
    full = Polygon(((1.0, 2.0), (30.0, 2.0), (30.0, 40.0)), "93a6bc", "2b3540", 1.0)
    drawing = DRAWING._replace(shapes=(full,))
    assert "opacity" not in svg_text(drawing)
