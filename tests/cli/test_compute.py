"""`kindsl compute`."""

import inspect
import json
import re
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from tests.cli.conftest import Runner
from tests.cli.samples import GOOD, INTEGER, UNBOUND, arm

import kindsl as package

KEYS = [
    "q", "qd", "qdd", "link_poses", "frame_poses", "mass", "com", "joint_space_inertia",
    "gravity_torque", "bias_torque", "inverse_dynamics", "jacobians",
]  # fmt: skip


@pytest.fixture
def document(folder: Path) -> Path:
    path = folder / "arm.kindsl"
    path.write_text(GOOD)
    return path


def test_a_link_without_inertia_leaves_the_totals_open(kindsl: Runner, folder: Path) -> None:
    start = GOOD.rindex("inertia_params")
    (folder / "a.kindsl").write_text(GOOD[:start] + GOOD[GOOD.index("}", start) + 1 :])
    result = json.loads(kindsl("compute", "a.kindsl").out)
    reason = "link 'lower' has no mass"
    assert result["missing_masses"] == [{"name": "lower", "reason": reason}]
    text = kindsl("compute", "a.kindsl", "--output-format", "text").out
    assert f"mass at least 2 kg ({reason}), centre of mass of what is known (" in text


def test_a_robot_without_masses_has_poses(kindsl: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(re.sub(r"inertia_params \{[^}]*\}", "", GOOD))
    told = kindsl("compute", "a.kindsl")
    assert told.status == 0, told.err
    (found,) = json.loads(told.out)["configurations"]
    assert (found["mass"], found["com"]) == (0.0, None)
    assert set(found["link_poses"]) == {"upper", "lower"}
    text = kindsl("compute", "a.kindsl", "--output-format", "text").out
    assert "nan" not in text
    assert "mass unknown" in text


def test_json_at_zero(kindsl: Runner, document: Path) -> None:
    told = kindsl("compute", document)
    assert (told.status, told.err) == (0, "")
    result = json.loads(told.out)
    (at_zero,) = result.pop("configurations")
    assert result == {
        "robot": "arm",
        "floating": False,
        "parameters": {},
        "links": [
            {"name": "upper", "id": 1, "parent": "base", "joint": "shoulder",
             "joint_type": "revolute"},
            {"name": "lower", "id": 2, "parent": "upper", "joint": "elbow",
             "joint_type": "prismatic"},
        ],
    }  # fmt: skip
    assert list(at_zero) == KEYS
    assert list(at_zero["link_poses"]) == ["upper", "lower"]
    assert np.array(at_zero["link_poses"]["lower"])[:3, 3] == pytest.approx([0.5, 0.0, 0.5])
    assert np.array(at_zero["frame_poses"]["tip"])[:3, 3] == pytest.approx([0.5, 0.0, 1.0])
    assert at_zero["mass"] == 3.0  # a fixed base does not count
    assert np.shape(at_zero["joint_space_inertia"]) == (2, 2)
    assert np.shape(at_zero["jacobians"]["tip"]) == (6, 2)
    assert at_zero["gravity_torque"] == pytest.approx([0.0, 9.81])


def test_numbers_are_the_mechanisms(kindsl: Runner, document: Path) -> None:
    q, qd, qdd = [0.3, -0.2], [1.0, -0.5], [-2.0, 0.1]
    gravity = (1.0, 0.0, -9.0)
    told = kindsl(
        "compute", document, "--q", "0.3,-0.2", "--qd=1,-0.5", "--qdd=-2,0.1", "--gravity", "1,0,-9"
    )
    (found,) = json.loads(told.out)["configurations"]
    mechanism = package.load(document).mechanism()
    assert found["inverse_dynamics"] == pytest.approx(
        mechanism.inverse_dynamics(q, qd, qdd, gravity=gravity)
    )
    assert found["bias_torque"] == pytest.approx(mechanism.bias_torque(q, qd, gravity=gravity))
    assert np.allclose(found["joint_space_inertia"], mechanism.joint_space_inertia(q))
    assert np.allclose(found["jacobians"]["tip"], mechanism.jacobian(q, "tip"))
    assert np.allclose(found["com"], mechanism.center_of_mass(q))


@pytest.mark.parametrize("floating", [False, True])
def test_forward_inverts_inverse(kindsl: Runner, folder: Path, floating: bool) -> None:
    (folder / "a.kindsl").write_text(arm(floating=floating))
    there = kindsl("compute", "a.kindsl", "--q", "0.3,0.1", "--qd", "1,2", "--qdd", "-1,0.5")
    (inverse,) = json.loads(there.out)["configurations"]
    tau = ",".join(map(repr, inverse["inverse_dynamics"]))
    back = kindsl("compute", "a.kindsl", "--q", "0.3,0.1", "--qd", "1,2", "--forward", "--tau", tau)
    (forward,) = json.loads(back.out)["configurations"]
    assert forward["qdd"] == pytest.approx([-1.0, 0.5])
    if floating:
        assert forward["base_acceleration"] == pytest.approx(inverse["base_acceleration"])
        assert np.shape(forward["joint_space_inertia"]) == (8, 8)


def test_many_configurations_equal_single_ones(kindsl: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(arm(floating=True))
    entries = [
        {"q": [0.1, 0.2], "qd": {"elbow": -1.0}, "base_velocity": [1, 0, 0, 0, 2, 0]},
        {"q": {"shoulder": 0.4}},
        {},
    ]
    (folder / "q.json").write_text(json.dumps(entries))
    many = json.loads(kindsl("compute", "a.kindsl", "--q-file", "q.json").out)["configurations"]
    assert len(many) == 3
    for entry, found in zip(entries, many, strict=True):
        (folder / "one.json").write_text(json.dumps(entry))
        told = kindsl("compute", "a.kindsl", "--q-file", "one.json")
        (alone,) = json.loads(told.out)["configurations"]
        for key, value in found.items():
            assert _flat(alone[key]) == pytest.approx(_flat(value))


def test_a_pose_of_the_configuration(kindsl: Runner, folder: Path, document: Path) -> None:
    (folder / "kindsl.toml").write_text(
        "[poses.up]\nshoulder = 0.4\n"
        "[[document]]\npath = 'arm.kindsl'\n[document.poses.down]\nshoulder = -0.4\n"
        "[poses.odd]\ntail = 1.0\n"
    )
    for name, q in (("up", "0.4"), ("down", "-0.4")):
        posed = json.loads(kindsl("compute", "arm.kindsl", "--pose", name).out)
        given = json.loads(kindsl("compute", "arm.kindsl", f"--q=shoulder={q}").out)
        assert posed == given
    for arguments, told in (
        (["--pose", "pu"], "kindsl.toml names no pose 'pu'"),
        (["--pose", "odd"], "pose 'odd' names 'tail', which the robot does not have"),
        (["--pose", "up", "--q", "1"], "--pose cannot be combined with --q or --q-file"),
    ):
        refused = kindsl("compute", "arm.kindsl", *arguments)
        assert refused.status == 2
        assert told in refused.err


def _flat(value: object) -> list[float]:
    if isinstance(value, dict):
        return [number for inner in value.values() for number in _flat(inner)]
    return [float(number) for number in np.ravel(np.array(value))]


def test_names_of_joints_as_keys(kindsl: Runner, document: Path) -> None:
    (found,) = json.loads(kindsl("compute", document, "--q", "elbow=0.25").out)["configurations"]
    assert found["q"] == [0.0, 0.25]


def test_npz(kindsl: Runner, document: Path, folder: Path) -> None:
    told = kindsl("compute", document, "--output-format", "npz", "-o", "out.npz")
    assert (told.status, told.out) == (0, "")
    archive = np.load(BytesIO((folder / "out.npz").read_bytes()))
    assert archive["pose_names"].tolist() == ["upper", "lower", "tip"]
    assert archive["poses"].shape == (1, 3, 4, 4)
    assert archive["jacobians"].shape == (1, 3, 6, 2)


def test_a_terminal_gets_a_table_and_a_program_json(
    kindsl: Runner, document: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert json.loads(kindsl("compute", document).out)["robot"] == "arm"
    table = kindsl("compute", document, "--output-format", "text").out
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    assert kindsl("compute", document).out == table
    assert json.loads(kindsl("compute", document, "--output-format", "json").out)


def test_text(kindsl: Runner, document: Path) -> None:
    out = kindsl("compute", document, "--output-format", "text").out
    assert out.startswith("arm: fixed base, 2 links\n")
    rows = [line.split() for line in out.splitlines()]
    assert ["elbow", "0", "m", "0", "0", "9.81", "9.81", "9.81", "N"] in rows
    assert ["tip", "0.5000", "0.0000", "1.0000", "0.0000", "0.0000", "0.0000"] in rows


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--q", "1"], "--q has 1 number, the robot has 2 joints: shoulder, elbow"),
        (["--qd", "1,2,3"], "--qd has 3 numbers"),
        (["--q", "1,x"], "--q holds 'x', which is not a number"),
        (["--q", "nan,0"], "--q holds a number that is not finite"),
        (["--q", "elbw=1"], "--q: there is no joint 'elbw', did you mean 'elbow'?"),
        (["--base-velocity", "1,2,3,4,5,6"], "--base-velocity is given, but the base is fixed"),
        (["--tau", "1,2"], "--tau needs --forward"),
        (["--forward", "--qdd", "1,2"], "--qdd cannot be used with --forward"),
        (["--gravity", "1,2"], "'1,2' is not three numbers X,Y,Z"),
        (["--q-file", "missing.json"], "missing.json: cannot be read: No such file"),
        (["--param", "x=1"], "arm.kindsl: error: there is no parameter 'x'"),
        (["-o", "no/such/folder"], "no/such/folder: error: cannot be written"),
    ],
)
def test_wrong_usage(kindsl: Runner, document: Path, arguments: list[str], told: str) -> None:
    result = kindsl("compute", document.name, *arguments)
    assert (result.status, result.out) == (2, "")
    assert told in result.err


@pytest.mark.parametrize(
    ("content", "told"),
    [
        ('{"q": [1, 2]', "q.json:1:13: not valid JSON"),
        ("[]", "q.json: no configuration is given"),
        ("3", "q.json: must be an object with 'q', not a number"),
        ('[{}, {"q": 1}]', "q.json: configuration 2: 'q' must be a list of numbers, not a number"),
        ('{"p": []}', "q.json: unknown key 'p' (known: q, qd, qdd, tau, base_velocity)"),
        ('{"q": [1, null]}', "q.json: 'q' holds null, not only numbers"),
        ('{"q": [1, NaN]}', "q.json: 'q' holds a number that is not finite"),
        ('{"q": [1, 1e999]}', "q.json: 'q' holds a number that is not finite"),
        (f'{{"q": [1, {10**400}]}}', "q.json: 'q' holds a number that is not finite"),
        ('{"qd": {"hip": 1}}', "q.json: 'qd': there is no joint 'hip'"),
    ],
)
def test_wrong_file(kindsl: Runner, document: Path, folder: Path, content: str, told: str) -> None:
    (folder / "q.json").write_text(content)
    result = kindsl("compute", document, "--q-file", "q.json")
    assert (result.status, result.out) == (2, "")
    assert result.err.startswith(f"kindsl compute: error: {told}")


def test_unbound_parameters_are_named_with_the_remedy(kindsl: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(arm(reach="length", mass="m"))
    told = kindsl("compute", "a.kindsl")
    assert told.status == 1
    assert "'m'" in told.err
    assert "'length'" in told.err
    assert "--param m=VALUE --param length=VALUE" in told.err
    assert told.err.startswith("a.kindsl:")
    (folder / "a.kindsl").write_text(UNBOUND)
    assert kindsl("compute", "a.kindsl", "--param", "length=1").status == 0


def test_defects_of_the_document_are_told_with_their_place(kindsl: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(INTEGER)
    told = kindsl("compute", "a.kindsl")
    assert (told.status, told.out) == (1, "")
    assert told.err.startswith("a.kindsl:21:32: error: [KD005]")
    (folder / "a.kindsl").write_text(GOOD.replace("children {}", "children { upper via shoulder }"))
    told = kindsl("compute", "a.kindsl")
    assert told.status == 1
    assert "upper -> lower -> upper" in told.err
    assert told.err.startswith("a.kindsl:")


def test_public_api(folder: Path, document: Path) -> None:
    loaded = package.load(document)
    assert loaded.findings == ()
    assert [link.name for link in loaded.model.links] == ["upper", "lower"]
    unbound = package.parse(UNBOUND)
    with pytest.raises(package.UnboundParameterError, match="length"):
        unbound.mechanism()
    assert unbound.mechanism(parameters={"length": 1.0}).total_mass() == 3.0
    (folder / "kindsl.toml").write_text("[parameters]\nlength = 2.0\n")
    document.write_text(UNBOUND)
    poses = package.load("arm.kindsl").mechanism().forward_kinematics([0.0, 0.0])
    assert poses["lower"][0, 3] == pytest.approx(2.0)
    with pytest.raises(package.ModelError):
        package.parse("Robot").mechanism()
    with pytest.raises(AttributeError, match="nothing"):
        package.nothing  # noqa: B018


def test_help_shows_short_signatures() -> None:
    for interface in (package.Mechanism, package.Document):
        for name, method in inspect.getmembers(interface, inspect.isfunction):
            if not name.startswith("_"):
                assert len(str(inspect.signature(method))) < 320, name


def test_errors_that_leave_a_mechanism_are_noted(kindsl: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(GOOD.replace("Ix = 0.0101", "Ix = -0.0101"))
    told = kindsl("compute", "a.kindsl")
    assert told.status == 0
    assert told.err == "a.kindsl: note: has an error, see kindsl lint\n"
