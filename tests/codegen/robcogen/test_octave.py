"""RobCoGen's functions in Octave against the mechanics of this project."""

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from tests.codegen.robcogen.programs import generated
from tests.codegen.robcogen.test_classes import GRAVITY, ROBOTS, VALUES, equal, wrenches

OCTAVE = shutil.which("octave-cli") or shutil.which("octave")

SCRIPT = """
q = sin(1.3 * (1:@N@)'); qd = sin(0.7 * (1:@N@)'); qdd = sin(2.1 * (1:@N@)');
xm = updateMotionTransforms(initMotionTransforms(), q);
xh = updateHomogeneousTransforms(initHomogeneousTransforms(), q);
jac = updateJacobians(initJacobians(), q);
ip = inertiaProperties();
fext = {};
for i = 0:@NB@
    fext{end + 1} = sin((0.4 + i) * (1:6)');
end
function row(name, M)
    printf("%s", name); printf(" %.17g", M'); printf("\\n");
end
row("q", q); row("qd", qd); row("qdd", qdd);
"""
FIXED = """
row("id", inverseDynamics(ip, xm, qd, qdd));
row("id_q", inverseDynamics(ip, initMotionTransforms(), qd, qdd, q));
row("id_ext", inverseDynamics(ip, xm, qd, qdd, fext(2:end)));
"""
FLOATING = """
v0 = sin(0.9 * (1:6)'); g = [0; 0; 0; @G@];
row("v0", v0);
[tau, a] = inverseDynamics(ip, xm, v0, g, qd, qdd); row("id", tau); row("id_a0", a);
row("id_q", inverseDynamics(ip, initMotionTransforms(), v0, g, qd, qdd, q));
[tau, a] = inverseDynamics(ip, xm, v0, g, qd, qdd, fext); row("id_ext", tau); row("id_ext_a0", a);
"""


@pytest.mark.skipif(OCTAVE is None, reason="there is no Octave")
@pytest.mark.parametrize("robot", ROBOTS)
def test_octave_gives_the_mechanics_numbers(robot: str, tmp_path: Path) -> None:
    analysis, library = generated(ROBOTS[robot], VALUES, tmp_path, language="octave")
    mechanics = analysis.mechanism({name: VALUES[name] for name in library.defaults})
    is_floating, n = mechanics.bodies.is_floating, mechanics.n_joints
    base = f"fr_{library.robot.base_name}"
    script = SCRIPT + (FLOATING if is_floating else FIXED)
    script += "".join(
        f'row("H_{t.name}", xh.{b.name}_XH_{t.name}); row("X_{t.name}", xm.{b.name}_XM_{t.name});\n'
        for b, t in library.wanted.transforms
    ) + "".join(f'row("J_{t.name}", jac.{base}_J_{t.name});\n' for _, t in library.wanted.jacobians)
    for name, value in (("N", n), ("NB", n), ("G", "; ".join(map(str, GRAVITY)))):
        script = script.replace(f"@{name}@", str(value))
    (tmp_path / "main_.m").write_text(script)
    done = subprocess.run(
        [str(OCTAVE), "--norc", "--quiet", "main_.m"],
        cwd=tmp_path, capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    rows = (line.split() for line in done.stdout.splitlines())
    found = {name: np.array([float(x) for x in values]) for name, *values in rows}
    q, qd, qdd = found["q"], found["qd"], found["qdd"]
    M = mechanics.joint_space_inertia(q)
    first = M.shape[0] - n
    v0, g = (found["v0"], GRAVITY) if is_floating else (None, (0.0, 0.0, -9.81))
    bias = mechanics.bias_torque(q, qd, v0, g)
    for suffix in ("", "_ext"):
        still = bias - wrenches(mechanics, q, bool(suffix))
        a0 = np.linalg.solve(M[:first, :first], -(M[:first, first:] @ qdd + still[:first]))
        equal(found[f"id{suffix}"], (M @ [*a0, *qdd] + still)[first:])
        if is_floating:
            equal(found[f"id{suffix}_a0"], a0)
    equal(found["id_q"], found["id"])
    poses = dict(mechanics.forward_kinematics(q).items())
    known = {f"fr_{name}": poses[name] for name in mechanics.link_names} | poses
    for _, target in library.wanted.transforms:
        equal(found[f"H_{target.name}"], known[target.name])
    for _, target in library.wanted.jacobians:
        assert found[f"J_{target.name}"].any()


@pytest.mark.skipif(OCTAVE is None, reason="there is no Octave")
@pytest.mark.parametrize("name", ["upper_", "a_X_b", "end"])
def test_inverse_dynamics_find_transforms_of_any_name(name: str, tmp_path: Path) -> None:
    text = (
        ROBOTS["arm"]
        .replace("link upper_arm", f"link {name}")
        .replace("upper_arm via", f"{name} via")
    )
    analysis, _ = generated(text, VALUES, tmp_path, language="octave")
    mechanics = analysis.mechanism()
    q, qd, qdd = np.sin(np.arange(1.0, 3.0 * mechanics.n_joints + 1.0)).reshape(3, -1)
    (tmp_path / "main_.m").write_text(
        "xm = updateMotionTransforms(initMotionTransforms(), Q);\n"
        'printf("%.17g\\n", inverseDynamics(inertiaProperties(), xm, QD, QDD));\n'
        .replace("QDD", str([*map(float, qdd)])).replace("QD", str([*map(float, qd)]))
        .replace("Q", str([*map(float, q)]))
    )  # fmt: skip
    done = subprocess.run(
        [str(OCTAVE), "--norc", "--quiet", "main_.m"],
        cwd=tmp_path, capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    tau = [*map(float, done.stdout.split())]
    np.testing.assert_allclose(tau, mechanics.inverse_dynamics(q, qd, qdd), rtol=1e-12, atol=1e-12)
