"""Each message about a robot, its parameters, findings and formulas, in full."""

from dataclasses import replace
from math import hypot, log, pi

import numpy as np
import pytest
from tests.preview.robots import ARM, PARAMETRIC_ARM, skeleton_of

from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.semantics.parameters import Binding, JointProperties
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.robots.scene.ellipsoids import inertia_ellipsoid
from kindsl.robots.scene.encoding import as_dict
from kindsl.robots.scene.formulas import affine_component, formula_messages
from kindsl.robots.scene.geometry import Form, Shape
from kindsl.robots.scene.guesses import NO_GUESSES, Guesses, guesses
from kindsl.robots.scene.marks import (
    BAD_INERTIA,
    BASE,
    COM,
    GHOST,
    INERTIA,
    LINK,
    ROBOT_COM,
    body_marks,
    joint_marks,
    mass_marks,
)
from kindsl.robots.scene.messages import Affine, Part
from kindsl.robots.scene.parameters import parameter_messages
from kindsl.robots.scene.picture import Picture, PictureState, picture
from kindsl.robots.scene.robot import ghost_messages, robot_messages
from kindsl.robots.scene.size import STEP, Segment, extent


def of_type(messages: list[Part], kind: str) -> list[Part]:
    return [message for message in messages if message.type == kind]


def shapes(messages: list[Part]) -> dict[str, Shape]:
    return {m.path: m.object for m in messages if m.type == "set_object"}


class TestRobot:
    """The numbers that the page places a robot by."""

    def test_model(self) -> None:
        (model,) = of_type(robot_messages("Arm", skeleton_of(ARM)), "model")
        size = hypot(0.4, 0.8)
        assert as_dict(model) == {
            "type": "model", "path": "/kindsl/model", "name": "Arm", "is_floating": False,
            "size": pytest.approx(size), "center": pytest.approx([0.2, 0.0, 0.4]),
            "ground": 0.0, "unit": extent(skeleton_of(ARM)).radius, "density": 300.0,
        }  # fmt: skip

    def test_links(self) -> None:
        base, upper, slider = of_type(robot_messages("Arm", skeleton_of(ARM)), "link")
        assert (base.name, base.index, base.joint, base.mass) == ("base", 0, "", 0.0)
        assert (upper.name, upper.index, upper.joint) == ("upper", 1, "shoulder")
        assert upper.path == "/kindsl/robot/links/upper" and upper.mass == 2.0
        assert upper.com == (0.2, 0.0, 0.0) and upper.is_consistent is True
        # About its CoM, which is 0.2 m along x.
        about_com = np.diag([0.01, 0.12 - 2.0 * 0.04, 0.12 - 2.0 * 0.04])
        np.testing.assert_allclose(np.reshape(upper.inertia, (3, 3)), about_com, atol=1e-12)
        assert upper.anchor == pytest.approx([0.2, 0.0, 0.0])
        assert upper.ends == (pytest.approx((0.4, 0.0, 0.0)),)
        assert slider.anchor == pytest.approx([0.0, 0.0, 0.15])

    def test_a_name_stands_half_way_along_the_mean_of_the_segments(self) -> None:
        two = ARM.replace("slider via lift", "slider via lift other via swing", 1)
        two = two.rstrip()[:-1] + (
            "link other { id = 3 children {} }\n"
            "r_joint swing { ref_frame { translation = (0.0, 0.6, 0.0)"
            " rotation = (0.0, 0.0, 0.0) } }\n}\n"
        )
        upper = of_type(robot_messages("Arm", skeleton_of(two)), "link")[1]
        assert len(upper.ends) == 2
        assert upper.anchor == pytest.approx([0.1, 0.15, 0.0])
        last = of_type(robot_messages("Arm", skeleton_of(two)), "link")[3]
        assert (last.anchor, last.ends) == ((0.0, 0.0, 0.0), ())

    def test_an_impossible_base_matters_only_if_it_floats(self) -> None:
        skeleton = skeleton_of(ARM)
        bad = MassDistribution(1.0, (0.0, 0.0, 0.0), (0.1, 0.1, 0.5, 0.0, 0.0, 0.0))
        for body, floats, expected in ((0, False, True), (0, True, False), (1, False, False)):
            masses = list(skeleton.masses)
            masses[body] = bad
            changed = replace(skeleton.with_masses(masses), is_floating=floats)
            links = of_type(robot_messages("r", changed), "link")
            assert [link.is_consistent for link in links] == [
                expected if i == body else True for i in range(3)
            ]

    def test_joints_and_frames(self) -> None:
        guessed = Guesses({}, (), frozenset({"lift"}), frozenset({"tool"}))
        messages = robot_messages("Arm", skeleton_of(ARM), guessed)
        first, second = of_type(messages, "joint")
        assert {k: v for k, v in as_dict(first).items() if k != "placement"} == {
            "type": "joint", "path": "/kindsl/robot/joints/shoulder", "name": "shoulder",
            "index": 1, "kind": "revolute", "predecessor": "base", "successor": "upper",
            "is_guess": False,
        }  # fmt: skip
        assert (second.name, second.index, second.kind) == ("lift", 2, "prismatic")
        assert (second.predecessor, second.successor) == ("upper", "slider")
        assert second.is_guess is True
        (frame,) = of_type(messages, "frame")
        assert (frame.name, frame.link, frame.is_guess) == ("tool", "slider", True)
        assert frame.placement == pytest.approx([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0.3, 1])
        known = robot_messages("Arm", skeleton_of(ARM))
        assert [m.is_guess for kind in ("joint", "frame") for m in of_type(known, kind)] == [
            False, False, False,
        ]  # fmt: skip

    def test_limits_are_those_of_joints_that_are_there(self) -> None:
        limits = {"lift": JointProperties(-0.1, 0.4), "other": JointProperties(0.0, 1.0)}
        (found,) = of_type(robot_messages("Arm", skeleton_of(ARM), NO_GUESSES, limits), "limits")
        assert as_dict(found) == {
            "type": "limits", "path": "/kindsl/limits/lift", "name": "lift",
            "minimum": -0.1, "maximum": 0.4,
        }  # fmt: skip

    def test_marks(self) -> None:
        skeleton = skeleton_of(ARM)
        found = shapes(robot_messages("Arm", skeleton))
        links = "/kindsl/robot/links"
        assert found[f"{links}/base/base/ball"].color == BASE
        assert found[f"{links}/upper/body/ball"].color == LINK
        assert found[f"{links}/base/base/slab"] == Shape(Form.SLAB, BASE)
        assert found[f"{links}/upper/link-frame/triad"].form is Form.TRIAD
        assert f"{links}/upper/inertia/ellipsoid" in found
        total = "/kindsl/robot/total/robot/robot-com/ball"
        assert found[total] == Shape(Form.BALL, ROBOT_COM, on_top=True)
        heavy = skeleton.with_masses((skeleton.masses[1], *skeleton.masses[1:]))
        assert f"{links}/base/inertia/ellipsoid" not in shapes(robot_messages("Arm", heavy))
        floating = shapes(robot_messages("Arm", replace(heavy, is_floating=True)))
        assert f"{links}/base/inertia/ellipsoid" in floating
        assert f"{links}/base/base/slab" not in floating

    def test_a_ghost_has_the_same_places_below_its_own_root(self) -> None:
        skeleton = skeleton_of(ARM)
        ghost, robot = ghost_messages(skeleton), robot_messages("Arm", skeleton)
        for kind in ("link", "joint", "frame"):
            assert [
                replace(m, path=m.path.replace("/ghost/", "/robot/")) for m in of_type(ghost, kind)
            ] == of_type(robot, kind)
        assert {shape.color for shape in shapes(ghost).values()} == {GHOST}


class TestMarks:
    """Shapes, colours and places of single marks."""

    def test_a_body_is_a_ball_and_rods_that_end_in_balls(self) -> None:
        segments = (Segment("a", (0.0, 0.0, 2.0)), Segment("b", (1.0, 0.0, 0.0)))
        messages = {(m.type, m.path): m for m in body_marks("robot", "l", segments, "body")}
        place = "/kindsl/robot/links/l/body"
        drawn = {path: m.object for (kind, path), m in messages.items() if kind == "set_object"}
        assert drawn == {
            f"{place}/ball": Shape(Form.BALL, LINK),
            f"{place}/segment-a": Shape(Form.CYLINDER, LINK),
            f"{place}/end-a": Shape(Form.BALL, LINK),
            f"{place}/segment-b": Shape(Form.CYLINDER, LINK),
            f"{place}/end-b": Shape(Form.BALL, LINK),
        }
        end = messages["set_transform", f"{place}/end-a"].matrix
        assert end == (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.0, 0.0, 2.0, 1)

    @pytest.mark.parametrize(
        "end",
        [
            (1.0, 0.0, 0.0), (0.0, -2.0, 0.0), (0.0, 0.0, 0.5), (3.0, 2.0, 1.0), (1.0, 3.0, 2.0),
            (2.0, 1.0, 3.0), (1.0, 1.0, 1.0),
        ],
    )  # fmt: skip
    def test_a_rod_is_turned_and_stretched_and_not_sheared(self, end) -> None:
        marks = body_marks("robot", "l", (Segment("a", end),), "body")
        (rod,) = [m for m in marks if m.type == "set_transform" and "segment" in m.path]
        matrix = np.reshape(rod.matrix, (4, 4)).T
        x, y, z = matrix[:3, :3].T
        np.testing.assert_allclose(y, end)
        np.testing.assert_allclose(matrix[:3, 3], np.array(end) / 2.0)
        np.testing.assert_allclose([x @ x, z @ z, x @ y, y @ z, x @ z], [1, 1, 0, 0, 0], atol=1e-12)
        assert np.linalg.det(matrix) == pytest.approx(np.linalg.norm(end))
        assert min(abs(x)) == 0.0 and matrix[3].tolist() == [0, 0, 0, 1]

    def test_a_centre_of_mass_and_an_ellipsoid_lie_where_they_are(self) -> None:
        body = MassDistribution(
            5.0, (0.1, 0.2, 0.3), (0.2 + 0.65, 0.5 + 0.5, 0.5 + 0.25, 0.1, 0.15, 0.3)
        )
        ellipsoid = inertia_ellipsoid(body)
        messages = {(m.type, m.path): m for m in mass_marks("l", body.com, ellipsoid)}
        place = "/kindsl/robot/links/l"
        ball = messages["set_object", f"{place}/com/ball"].object
        assert ball == Shape(Form.POINT, COM, on_top=True)
        assert messages["set_transform", f"{place}/com/ball"].matrix[12:] == (0.1, 0.2, 0.3, 1.0)
        mark = messages["set_transform", f"{place}/inertia/ellipsoid"].matrix
        assert mark[12:] == (0.1, 0.2, 0.3, 1.0) and mark[3] == mark[7] == mark[11] == 0.0
        semi = np.reshape(mark, (4, 4))[:3, :3]
        assert ellipsoid.semi_axes is not None
        np.testing.assert_allclose(semi, ellipsoid.semi_axes)
        assert messages["set_object", f"{place}/inertia/ellipsoid"].object.color == INERTIA
        bad = ellipsoid._replace(is_consistent=False)
        found = {m.path: m.object for m in mass_marks("l", body.com, bad) if m.type == "set_object"}
        assert found[f"{place}/inertia/ellipsoid"].color == BAD_INERTIA

    def test_what_a_mass_and_moments_allow_is_told(self) -> None:
        def ellipsoid(mass: float, *moments: float):
            return inertia_ellipsoid(MassDistribution(mass, (0.0,) * 3, (*moments, 0.0, 0.0, 0.0)))

        # A rod has no extent across: drawable, and a body.
        rod = ellipsoid(1.0, 0.0, 1.0, 1.0)
        assert rod.is_consistent and rod.semi_axes is not None
        assert [hypot(*axis) for axis in rod.semi_axes] == pytest.approx(
            [0.01 * 5.0**0.5, 0.01 * 5.0**0.5, 5.0**0.5]
        )
        assert not ellipsoid(1.0, 0.1, 0.1, 0.3).is_consistent
        assert ellipsoid(0.0, 1.0, 1.0, 1.0).semi_axes is None
        assert ellipsoid(0.0, 1.0, 1.0, 1.0).is_consistent
        negative = ellipsoid(-1.0, 1.0, 1.0, 1.0)
        assert negative.semi_axes is None and not negative.is_consistent
        point = ellipsoid(1.0, 0.0, 0.0, 0.0)
        assert point.semi_axes is None and point.is_consistent

    def test_a_tensor_has_the_products_negated_and_is_symmetric(self) -> None:
        body = MassDistribution(1.0, (0.0, 0.0, 0.0), (1.0, 2.0, 2.5, 0.1, 0.2, 0.3))
        assert inertia_ellipsoid(body).about_com == pytest.approx(
            (1.0, -0.1, -0.2, -0.1, 2.0, -0.3, -0.2, -0.3, 2.5)
        )

    def test_a_joint_stands_in_its_frame(self) -> None:
        place = "/kindsl/robot/joints/j"
        for kind, forms in (
            ("revolute", {f"{place}/revolute/mark": Form.DRUM}),
            ("prismatic", {f"{place}/prismatic/mark": Form.BLOCK,
                           f"{place}/prismatic/rail": Form.CYLINDER}),
        ):  # fmt: skip
            marks = joint_marks("j", kind)
            drawn = {m.path: m.object.form for m in marks if m.type == "set_object"}
            assert drawn == forms | {
                f"{place}/axis/arrow": Form.ARROW,
                f"{place}/joint-frame/triad": Form.SHORT_TRIAD,
                f"{place}/torque/force": Form.FORCE,
            }
            turned = {m.path: m.matrix for m in marks if m.type == "set_transform"}
            assert set(turned) == set(forms)
            for path, matrix in turned.items():
                found = np.reshape(matrix, (4, 4)).T
                lies_along = 2 if drawn[path] is Form.BLOCK else 1
                np.testing.assert_array_equal(found[:3, lies_along], [0, 0, 1])
                assert np.linalg.det(found[:3, :3]) == 1.0
                np.testing.assert_array_equal(found[:, 3], [0, 0, 0, 1])
                np.testing.assert_array_equal(found[3], [0, 0, 0, 1])
        drawn = {m.path for m in robot_messages("Arm", skeleton_of(ARM))}
        assert "/kindsl/robot/total/robot/robot-com/ball" in drawn


class TestSize:
    """What scales the picture."""

    def test_bodies_reach_to_joints_else_frames_else_through_the_centre_of_mass(self) -> None:
        bare = ARM[: ARM.index("    frames")] + ARM[ARM.index("}\n\nr_joint") :]
        names = [[s.name for s in own] for own in extent(skeleton_of(bare)).segments]
        assert names == [["shoulder"], ["lift"], ["com"]]
        (through,) = extent(skeleton_of(bare)).segments[2]
        assert through.end == pytest.approx((0.0, 0.0, 0.2)) and through.length == pytest.approx(
            0.2
        )
        weightless = bare.replace("CoM = (0.0, 0.0, 0.1)", "CoM = (0.0, 0.0, 0.0)")
        assert extent(skeleton_of(weightless)).segments[2] == ()
        here = ARM.replace("translation = (0.0, 0.0, 0.3)", "translation = (0.0, 0.0, 0.0)")
        assert [s.name for s in extent(skeleton_of(here)).segments[2]] == ["com"]

    def test_the_box_is_around_all_ends_and_the_ground_below_them(self) -> None:
        size = extent(skeleton_of(ARM))
        assert size.center == pytest.approx((0.2, 0.0, 0.4))
        assert size.size == pytest.approx(hypot(0.4, 0.8))
        below = ARM.replace("translation = (0.0, 0.0, 0.5)", "translation = (0.0, 0.0, -2.0)")
        assert extent(skeleton_of(below)).ground == pytest.approx(-2.0)
        floating = extent(skeleton_of(ARM.replace("base {", "base floating {", 1)))
        assert floating.ground == pytest.approx(-0.5 * floating.radius)

    def test_the_radius_is_a_step_near_a_share_of_the_median_segment(self) -> None:
        def radius(text: str) -> tuple[float, float]:
            size = extent(skeleton_of(text))
            steps = log(size.radius, STEP)
            assert steps == pytest.approx(round(steps))
            return size.radius, size.size

        # Segments of 0.5, 0.4 and 0.3 m: 0.11 of 0.4 m, but no more than 0.02 of the whole.
        found, whole = radius(ARM)
        assert abs(log(found / (0.020 * whole), STEP)) <= 0.5 + 1e-9
        long = ARM.replace("(0.0, 0.0, 0.5)", "(0.0, 0.0, 5.0)")
        found, whole = radius(long)
        assert abs(log(found / 0.044, STEP)) <= 0.5 + 1e-9
        longer = ARM.replace("(0.0, 0.0, 0.5)", "(0.0, 0.0, 50.0)")
        found, whole = radius(longer)
        assert abs(log(found / (0.004 * whole), STEP)) <= 0.5 + 1e-9


def rows(text: str, bindings=None, typed=None, guessed=None) -> list[Part]:
    model = analyse(text).model
    return list(parameter_messages(model, bindings or {}, typed or {}, guessed or {}))


class TestParameters:
    """Rows of the panel: value, range, whether it is the document's own."""

    def test_without_a_value_it_is_the_guess(self) -> None:
        (row,) = rows(PARAMETRIC_ARM, guessed={"reach": 0.5})
        assert as_dict(row) == {
            "type": "parameter", "path": "/kindsl/parameters/reach", "index": 0, "name": "reach",
            "kind": "length", "value": 0.5, "is_guess": True, "is_bound": False,
            "minimum": 0.0, "maximum": 1.0, "has_range": False, "is_overridden": False,
        }  # fmt: skip

    def test_a_binding_and_what_is_typed_win(self) -> None:
        bound = {"reach": Binding(0.7, 0.1, 0.9)}
        (row,) = rows(PARAMETRIC_ARM, bound)
        found = as_dict(row)
        told = {k: found[k] for k in ("value", "is_guess", "is_bound", "minimum", "maximum")}
        assert told == {
            "value": 0.7, "is_guess": False, "is_bound": True, "minimum": 0.1, "maximum": 0.9,
        }  # fmt: skip
        (row,) = rows(PARAMETRIC_ARM, bound, {"reach": 2.0})
        assert (row.value, row.is_overridden, row.maximum) == (2.0, True, 0.9)
        (row,) = rows(PARAMETRIC_ARM, None, {"reach": 2.0})
        assert (row.value, row.is_guess, row.is_bound) == (2.0, False, False)

    @pytest.mark.parametrize(
        ("binding", "span"),
        [
            (Binding(0.5), (0.0, 1.0)),
            (Binding(-0.5), (-1.0, 0.0)),
            (Binding(0.0), (-1.0, 1.0)),
            (Binding(0.5, 0.2), (0.2, 1.0)),
            (Binding(0.5, None, 0.6), (0.0, 0.6)),
            (Binding(0.5, 1.5, None), (1.5, 2.5)),
            (Binding(0.5, 0.5, 0.5), (0.5, 1.5)),
        ],
    )
    def test_the_range_of_a_length(self, binding: Binding, span: tuple[float, float]) -> None:
        (row,) = rows(PARAMETRIC_ARM, {"reach": binding})
        assert (row.minimum, row.maximum) == span
        assert row.has_range == (binding.minimum is not None and binding.maximum is not None)

    def test_ranges_of_angles_and_masses_and_the_order(self) -> None:
        text = ARM.replace("(-PI/2.0, 0.0, 0.0)", "(tilt, 0.0, 0.0)").replace(
            "mass = 1.0", "mass = m"
        )
        found = {row.name: row for row in rows(text, {"tilt": Binding(0.3)})}
        assert (found["tilt"].minimum, found["tilt"].maximum) == (-pi, pi)
        assert (found["m"].minimum, found["m"].maximum, found["m"].value) == (0.0, 10.0, 0.0)
        assert sorted(row.index for row in found.values()) == [0, 1]


def formulas(text: str, **values: float) -> dict[str, Part]:
    analysis = analyse(text)
    known = {**analysis.context.values, **values}
    return {m.name: m for m in formula_messages(analysis.model, known)}


class TestFormulas:
    """Places as what they are at zero and factors of parameters."""

    def test_joints_and_frames_with_parameters(self) -> None:
        text = PARAMETRIC_ARM.replace("(0.0, 0.0, 0.3)", "(0.0, 0.5 - 2.0*h, 0.3)")
        text = text.replace("(0.0, 0.5 - 2.0*h, 0.3)", "(0.0, -h/2.0, 0.3)")
        found = formulas(text)
        assert list(found) == ["lift", "tool"]
        assert as_dict(found["lift"]) == {
            "type": "formula", "path": "/kindsl/formulas/joints/lift", "group": "joints",
            "name": "lift", "link": "upper",
            "translation": [(0.0, (("reach", 1.0),)), (0.0, ()), (0.0, ())],
            "rotation": [(pytest.approx(-pi / 2), ()), (0.0, ()), (0.0, ())],
            "rod": "/kindsl/robot/links/upper/body/segment-lift",
            "end": "/kindsl/robot/links/upper/body/end-lift",
        }  # fmt: skip
        assert found["tool"].translation[1] == (0.0, (("h", -0.5),))
        assert (found["tool"].group, found["tool"].link) == ("frames", "slider")

    def test_a_base_s_rods_are_below_the_base_and_rotations_count(self) -> None:
        found = formulas(ARM.replace("(PI/2.0, 0.0, 0.0)", "(tilt, 0.0, 0.0)", 1))
        assert found["shoulder"].rod == "/kindsl/robot/links/base/base/segment-shoulder"
        assert found["shoulder"].rotation[0] == (0.0, (("tilt", 1.0),))
        assert formulas(ARM) == {}

    def test_what_is_no_such_formula_has_none(self) -> None:
        for broken in ("(1.0/0.0, 0.0, 0.0)", "(1.0/reach, 0.0, 0.0)", "(reach, 0.0)"):
            assert formulas(ARM.replace("(0.4, 0.0, 0.0)", broken)) == {}

    def test_a_value_that_is_known_is_still_a_factor(self) -> None:
        assert formulas(PARAMETRIC_ARM, reach=3.0) == formulas(PARAMETRIC_ARM)

    @pytest.mark.parametrize(
        ("written", "read"),
        [
            ("0.4", (0.4, ())),
            ("reach/4.0", (0.0, (("reach", 0.25),))),
            ("0.5 + 2.0 * reach", (0.5, (("reach", 2.0),))),
            ("0.5 + reach + tilt", (0.5, (("reach", 1.0), ("tilt", 1.0)))),
            ("reach * reach", None),
            ("reach * tilt", None),
            ("1.0/reach", None),
        ],
    )
    def test_a_component(self, written: str, read: Affine | None) -> None:
        model = analyse(ARM.replace("(0.4,", f"({written},")).model
        (lift,) = [j for j in model.joints if str(j.name) == "lift"]
        assert lift.pose.translation is not None
        first, second, _ = lift.pose.translation.components
        assert affine_component(first, {}) == read
        assert affine_component(second, {}) == (0.0, ())


class TestGuesses:
    """What is drawn in place of values that are missing."""

    def of(self, text: str) -> Guesses:
        analysis = analyse(text)
        return guesses(analysis.model, analysis.context.values)

    def test_nothing_is_guessed_of_what_is_known(self) -> None:
        assert self.of(ARM) is NO_GUESSES

    def test_a_length_is_the_median_of_those_that_are_known(self) -> None:
        text = PARAMETRIC_ARM.replace("(0.0, 0.0, 0.5)", "(0.0, 0.3, 0.4)")
        assert self.of(text).values == {"reach": 0.5}
        precise = PARAMETRIC_ARM.replace("(0.0, 0.0, 0.5)", "(0.0, 0.0, 0.456)")
        assert self.of(precise).values == {"reach": 0.46}
        none = PARAMETRIC_ARM.replace("(0.0, 0.0, 0.5)", "(0.0, 0.0, 0.0)")
        assert self.of(none).values == {"reach": 0.3}
        short = PARAMETRIC_ARM.replace("(0.0, 0.0, 0.5)", "(0.5, 0.0)")
        assert self.of(short).values == {"reach": 0.3}

    def test_who_depends_on_what(self) -> None:
        text = ARM.replace("(0.0, 0.0, 0.3)", "(0.0, 0.0, reach)").replace("mass = 1.0", "mass = m")
        found = self.of(text)
        assert (found.joints, found.frames) == (frozenset(), {"tool", "slider.tool"})
        assert found.left_out == ("m",) and set(found.values) == {"reach"}
        turned = self.of(ARM.replace("(-PI/2.0, 0.0, 0.0)", "(tilt, 0.0, 0.0)"))
        assert (turned.values, turned.joints) == ({"tilt": 0.0}, {"lift"})


@pytest.mark.parametrize(
    ("edit", "message"),
    [
        (("slider via lift", "slidr via lift"), "There is no link 'slidr'"),
        (("slider via lift", "slider via lfit"), "There is no joint 'lfit'"),
        (("slider via lift", "slider via"), "Link 'slider' has no joint"),
        (("children {}", "children { upper via lift }"), "The links form a kinematic loop"),
        (("        slider via lift\n", ""), "Some links are not connected to the base"),
    ],
)
def test_why_a_picture_is_not_the_document(edit: tuple[str, str], message: str) -> None:
    text = ARM.replace(*edit, 1)
    assert text != ARM
    analysis = analyse(text)
    last = picture(analyse(ARM).model, {}, None)
    for last_good, consequence in (
        (last, "the last complete version is shown"), (None, "showing the rest"),
    ):  # fmt: skip
        drawn = picture(analysis.model, dict(analysis.context.values), last_good)
        assert (drawn.state, drawn.message) == (PictureState.BROKEN, f"{message}: {consequence}")


def test_guesses_and_incomplete_poses_are_counted() -> None:
    def drawn(text: str) -> Picture:
        analysis = analyse(text)
        return picture(analysis.model, dict(analysis.context.values), None)

    two = PARAMETRIC_ARM.replace("mass = 1.0", "mass = m")
    assert drawn(two).message == "2 parameters have no value: drawn at a guess"
    assert drawn(two).state is PictureState.GUESSED
    masses = ARM.replace("mass = 1.0", "mass = m").replace("mass = 2.0", "mass = n")
    assert drawn(masses).message == "2 parameters have no value: left out of masses and inertia"
    assert drawn(masses).state is PictureState.GUESSED
    one = ARM.replace("(0.4, 0.0, 0.0)", "(0.4, 0.0)")
    assert drawn(one).message == "The pose of joint 'lift' is incomplete: drawn as far as known"
    both = one.replace("(0.0, 0.0, 0.5)", "(0.0, 0.5)")
    message = "The pose of joint 'shoulder' and 1 more is incomplete: drawn as far as known"
    assert drawn(both).message == message
