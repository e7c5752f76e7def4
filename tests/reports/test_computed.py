"""What `kindsl compute` tells people: each number in its column, with its unit."""

from math import pi

import pytest
from tests.cli.samples import arm

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.products.reports.computation import Results, compute
from kindsl.products.reports.computed_text import computed_text
from kindsl.products.reports.motions import Motion

GRAVITY = (0.0, 0.0, -9.81)
ZERO = Motion((0.0, 0.0), (0.0, 0.0), (0.0, 0.0), (0.0, 0.0), (0.0,) * 6)


def computed(*motions: Motion, text: str = "", is_forward: bool = False) -> Results:
    document = kindsl.parse(text or arm(), Settings())
    return compute(document, document.mechanism(), motions, GRAVITY, is_forward=is_forward)


def row(text: str, head: str) -> list[str]:
    (line,) = [line for line in text.splitlines() if line.startswith(head)]
    return line[len(head) :].split()


def test_everything_of_one_configuration() -> None:
    motion = ZERO._replace(q=(pi / 2, 0.25), qdd=(0.0, 1.0))
    assert computed_text(computed(motion)) == (
        "arm: fixed base, 2 links\n"
        "\n"
        "joint          q       qd  qdd  -> tau  gravity  bias\n"
        "shoulder  1.5708  rad   0    0       0        0     0  N m\n"
        "elbow       0.25  m     0    1   10.81     9.81  9.81  N\n"
        "\n"
        "pose in the base   x / m   y / m   z / m  rx / rad  ry / rad  rz / rad\n"
        "upper             0.0000  0.0000  0.5000    0.0000    0.0000    1.5708\n"
        "lower             0.0000  0.5000  0.7500    0.0000    0.0000    1.5708\n"
        "tip               0.0000  0.5000  1.2500    0.0000    0.0000    1.5708\n"
        "\n"
        "mass 3 kg, centre of mass (0, 0.166667, 0.583333) m\n"
        "\n"
        "joint-space inertia       0       1\n"
        "0 shoulder           0.2555  0.0000\n"
        "1 elbow              0.0000  1.0000\n"
    )


def test_forward_tells_accelerations() -> None:
    text = computed_text(computed(ZERO._replace(tau=(0.0, 10.81)), is_forward=True))
    assert row(text, "joint ") == ["q", "qd", "tau", "->", "qdd", "gravity", "bias"]
    assert row(text, "elbow ") == ["0", "m", "0", "10.81", "1", "9.81", "9.81", "N"]


def test_several_configurations_are_counted_from_one_and_one_is_not() -> None:
    assert "configuration" not in computed_text(computed(ZERO))
    text = computed_text(computed(ZERO, ZERO._replace(q=(0.0, 0.5))))
    assert [line for line in text.splitlines() if "configuration" in line] == [
        "--- configuration 1 ---", "--- configuration 2 ---",
    ]  # fmt: skip
    first, second = text.split("--- configuration 2 ---")
    assert row(first, "elbow ")[0] == "0" and row(second, "elbow ")[0] == "0.5"


def test_a_floating_base_has_rows_of_its_own_but_none_among_the_joints() -> None:
    results = computed(ZERO, text=arm(floating=True))
    text = computed_text(results)
    assert text.startswith("arm: floating base, 2 links\n")
    assert row(text, "elbow ")[-3:] == ["9.81", "9.81", "N"]
    assert row(text, "0 base wx")[0] == f"{results.quantities['joint_space_inertia'][0][0][0]:.4f}"
    assert row(text, "5 base vz")[5] == "4.0000" and row(text, "7 elbow")[7] == "1.0000"
    # Everything falls freely unless something holds the base: the base does at rest by 9.81 m/s^2.
    acceleration = ", ".join(f"{x:.6g}" for x in results.quantities["base_acceleration"][0])
    assert f"base acceleration ({acceleration}) rad/s^2, m/s^2\n" in text


def test_a_base_that_moves_has_its_velocity_in_everything() -> None:
    velocity = (0.0, 0.0, 2.0, 0.5, 0.0, 0.0)
    still, moving = computed(
        ZERO, ZERO._replace(base_velocity=velocity), text=arm(floating=True)
    ).as_json()["configurations"]
    assert (still["base_velocity"], moving["base_velocity"]) == ([0.0] * 6, list(velocity))
    assert still["gravity_torque"] == moving["gravity_torque"]
    assert still["bias_torque"] != moving["bias_torque"]


def test_parameters_are_told_with_their_values() -> None:
    settings = Settings(bindings={"length": Binding(0.75)})
    document = kindsl.parse(arm(reach="length"), settings)
    results = compute(document, document.mechanism(), (ZERO,), GRAVITY, is_forward=False)
    assert row(computed_text(results), "length") == ["0.75"]


@pytest.mark.parametrize(
    ("q", "told"), [(1e-13, "0"), (-1e-13, "0"), (2e-12, "2e-12"), (-0.1234567, "-0.123457")]
)
def test_dust_of_rounding_is_zero(q: float, told: str) -> None:
    assert row(computed_text(computed(ZERO._replace(q=(q, 0.0)))), "shoulder ")[0] == told


@pytest.mark.parametrize(
    ("q", "told"), [(-0.00004, "0.0000"), (-0.00006, "-0.0001"), (0.00006, "0.0001")]
)
def test_poses_have_no_negative_zero(q: float, told: str) -> None:
    assert row(computed_text(computed(ZERO._replace(q=(q, 0.0)))), "upper ")[-1] == told
