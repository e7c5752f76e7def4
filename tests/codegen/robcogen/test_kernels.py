"""The functions behind RobCoGen's classes: each number that they give, and no other is written.

They need no Eigen, so one program calls them all: of a floating and a fixed base, and transforms
that are products of those across joints.
"""

import re
import subprocess
from collections.abc import Iterator
from itertools import permutations

import numpy as np
import pytest
from tests.codegen.robcogen.programs import COMPILERS, STRICT
from tests.codegen.robcogen.test_classes import CRAB, VALUES, equal, wrenches
from tests.codegen.robots import PLAIN

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import skew
from kindsl.products.codegen.generating import Source, generate
from kindsl.products.codegen.library import GenerationError, Options
from kindsl.products.codegen.robcogen import transforms

pytestmark = pytest.mark.skipif(not COMPILERS, reason="there is no C++ compiler")
HAND = (
    "frames { hand { translation = (0.0, bend, 0.3) rotation = (0.4, -0.2, reach) } }\n}\nr_joint"
)
MOVING = CRAB.replace("}\nr_joint", HAND, 1)
FRAMES = {"fr_Left": "Left", "fr_claw": "claw", "fr_right": "right", "tip": "tip", "hand": "hand"}
PAIRS = [*permutations(("fr_shell", *FRAMES), 2)]
LISTED = ", ".join(("fr_shell", *FRAMES))
WANTED = "".join(f"    base={a}, target={b}\n" for a, b in PAIRS)
TRANSFORMS = (
    f"Robot Crab\nFrames {{ {LISTED} }}\nTransforms {{\n{WANTED}}}\nJacobians {{\n{WANTED}}}\n"
)
# Of each robot: its text, the joints that make a transform a product, the headers to call.
ROBOTS = {
    "floating": (MOVING, 7, ("transforms", "jacobians", "inertia_properties", "jsim",
                             "inverse_dynamics", "forward_dynamics")),
    "product": (MOVING, 1, ("transforms",)),
    "fixed": (MOVING.replace("shell floating", "shell"), 7,
              ("inverse_dynamics", "forward_dynamics", "jsim", "inertia_properties")),
}  # fmt: skip
UNTOUCHED = 12345.0
SPARE = 3
HEAD = """\
#include <cmath>
#include <cstdio>
struct Numbers {
    typedef double Scalar;
    static double sin(double x) { return std::sin(x); }
    static double cos(double x) { return std::cos(x); }
};
static void row(const char* name, const double* x, int n)
{
    std::printf("%s", name);
    for (int i = 0; i < n; i++) {
        std::printf(" %.17g", x[i]);
    }
    std::puts("");
}
"""
q, qd, x, v0, a0 = (np.sin(k * np.arange(1, n + 1)) for k, n in
                    ((1.3, 3), (0.7, 3), (2.1, 3), (0.9, 6), (1.9, 6)))  # fmt: skip
FEXT = np.concatenate([np.sin((0.4 + i) * np.arange(1, 7)) for i in range(4)])
GIVEN = {"q": q, "qd": qd, "qdd": x, "tau": x, "v0": v0, "a0": a0, "g": [9.81], "fext": FEXT}


class Asked:
    """A robot, its mechanics and what its functions gave, by their names and those of results."""

    def __init__(self, kind: str) -> None:
        text, joints, self.headers = ROBOTS[kind]
        bindings = {name: Binding(value) for name, value in VALUES.items()}
        analysis = kindsl.parse(text, Settings(bindings=bindings))
        options = Options("robcogen", PLAIN, "double", False, parameters="all", prefix="crab")
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(transforms, "MOST_JOINTS", joints)
            source = Source("crab.kindsl", analysis, {}, TRANSFORMS)
            self.library, self.files = generate(source, options)
        self.kind = kind
        self.mechanics: Mechanics = analysis.mechanism({n: VALUES[n] for n in self.names})
        self.found: dict[str, Array] = {}

    @property
    def names(self) -> list[str]:
        return list(self.library.parameter_names)

    def calls(self) -> Iterator[str]:
        """Yield the statements that call each function and print its results."""
        for header in self.headers:
            text = self.files[f"{header}.impl.h"]
            for name, arguments in re.findall(r"inline void (\w+)\(([^)]*)\)\s*{", text):
                names = re.findall(r"(\w+)(?:, |$)", arguments)
                results = [
                    n for n in names if f"const typename TRAIT::Scalar* {n}" not in arguments
                ]
                if name.endswith(("_constants", "fill", "append")) or "int " in arguments:
                    continue
                if not name.startswith("s_"):
                    yield self.call(name, name, names, results)
                    continue
                for letter, place in (("m", 3), ("f", 18)):
                    yield self.call(name, letter + name[1:], names, ["X"], f", X_ + {place}")

    def call(
        self, name: str, shown: str, names: list[str], results: list[str], coupling: str = ""
    ) -> str:
        """Return the statements of one call, which ends with the place of the coupling if any."""
        body = "".join(
            f"    double {n}_[{self.size(shown, n) + SPARE}];\n"
            f"    for (double& one : {n}_) one = {UNTOUCHED};\n"
            for n in results
        )
        space = f"{self.kind}::kernels::"
        if results == ["X"]:
            size = self.size(shown, "X")
            body += f"    for (int i = 0; i < {size}; i++) X_[i] = 0.0;\n"
            body += f"    {space}{name}_constants<Numbers>(X_{coupling});\n"
        given = ", ".join(f"{n}_" if n in results else n for n in names if n != "C") + coupling
        body += f"    {space}{name}<Numbers>({given});\n"
        body += "".join(
            f'    row("{self.kind}:{shown}:{n}", {n}_, {self.size(shown, n) + SPARE});\n'
            for n in results
        )
        return f"    {{\n{body}    }}\n"

    def size(self, function: str, result: str) -> int:
        """Return the length of a result."""
        if result == "m":
            return 10 * (4 if self.mechanics.bodies.is_floating else 3)
        if result != "X":
            return 6 if result in ("a0", "f0") else 3
        if function == "joint_space_inertia":
            return self.mechanics.bodies.n_velocities**2
        if "_J_" in function:
            return 6 * len(between(function))
        return 16 if function.startswith("h_") else 36

    def result(self, function: str, result: str) -> Array:
        """Return a result, behind which nothing was written."""
        numbers = self.found[f"{self.kind}:{function}:{result}"]
        np.testing.assert_array_equal(numbers[-SPARE:], UNTOUCHED)
        return numbers[:-SPARE]


def between(jacobian: str) -> list[int]:
    """Return the joints between the frames that a Jacobian is named after."""
    carried = {"fr_shell": set(), "fr_Left": {0}, "fr_claw": {0, 1}, "tip": {0, 1},
               "fr_right": {2}, "hand": {2}}  # fmt: skip
    base, target = jacobian.split("_J_")
    return sorted(carried[base] ^ carried[target])


@pytest.fixture(scope="module")
def asked(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Asked]:
    """Return all robots, after one program has called their functions."""
    folder = tmp_path_factory.mktemp("kernels")
    (folder / "declarations.h").write_text("")
    robots = {kind: Asked(kind) for kind in ROBOTS}
    source, body = HEAD, ""
    for kind, robot in robots.items():
        for header in robot.headers:
            text = robot.files[f"{header}.impl.h"]
            text = text.replace("namespace Crab", f"namespace {kind}").replace(
                "namespace iit {", ""
            )
            (folder / f"{kind}_{header}.h").write_text(
                text.replace("}\n}\n}\n\n#endif", "}\n}\n\n#endif")
            )
            body += f'#undef {text.split()[1]}\n#include "{kind}_{header}.h"\n'
    source += body + "int main()\n{\n"
    given = {**GIVEN, "p": [VALUES[name] for name in robots["floating"].names]}
    for name, numbers in given.items():
        source += f"    const double {name}[] = {{{', '.join(map(repr, map(float, numbers)))}}};\n"
    source += "".join(call for robot in robots.values() for call in robot.calls()) + "}\n"
    (folder / "main.cpp").write_text(source)
    command = [COMPILERS[0], "-std=c++14", *STRICT, "main.cpp", "-o", "main"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    told = subprocess.run([folder / "main"], capture_output=True, text=True, check=True).stdout
    rows = (line.split() for line in told.splitlines())
    found = {name: np.array([float(x) for x in numbers]) for name, *numbers in rows}
    for robot in robots.values():
        robot.found = found
    return robots


def poses(mechanics: Mechanics, at: Array) -> dict[str, Array]:
    found = mechanics.forward_kinematics(at)
    return {"fr_shell": np.eye(4), **{name: found[known] for name, known in FRAMES.items()}}


@pytest.mark.parametrize("kind", ["floating", "product"])
def test_transforms_between_all_frames(asked: dict[str, Asked], kind: str) -> None:
    robot = asked[kind]
    seen, zero = poses(robot.mechanics, q), np.zeros((3, 3))
    for base, target in PAIRS:
        T = np.linalg.inv(seen[base]) @ seen[target]
        E = T[:3, :3]
        coupling = skew(T[:3, 3]) @ E
        expected = {
            "h": T,
            "m": np.block([[E, zero], [coupling, E]]),
            "f": np.block([[E, coupling], [zero, E]]),
        }
        for letter, X in expected.items():
            equal(robot.result(f"{letter}_{base}_X_{target}", "X"), X.T)


def test_transforms_to_the_frames_of_joints(asked: dict[str, Asked]) -> None:
    robot = asked["floating"]
    for joint, T in robot.mechanics.joint_poses(q).items():
        equal(robot.result(f"h_fr_shell_X_fr_{joint}", "X"), T.T)


def test_jacobians_between_all_frames(asked: dict[str, Asked]) -> None:
    robot, h = asked["floating"], 1e-6
    for base, target in PAIRS:
        name = f"{base}_J_{target}"
        columns = []
        for joint in between(name):
            step = h * np.eye(3)[joint]
            later, earlier = (
                np.linalg.inv(seen[base]) @ seen[target]
                for seen in (poses(robot.mechanics, q + step), poses(robot.mechanics, q - step))
            )
            rate = (later - earlier) / (2 * h)
            turning = rate[:3, :3] @ ((later + earlier) / 2)[:3, :3].T
            columns += [turning[2, 1], turning[0, 2], turning[1, 0], *rate[:3, 3]]
        if columns:
            equal(robot.result(name, "X"), np.array(columns), 1e-8)
        else:
            assert f"floating:{name}:X" not in robot.found


@pytest.mark.parametrize("kind", ["floating", "fixed"])
def test_dynamics(asked: dict[str, Asked], kind: str) -> None:
    robot = asked[kind]
    mechanics, is_floating = robot.mechanics, kind == "floating"
    none, first = np.zeros(3), 6 if is_floating else 0
    weight = none if is_floating else np.array([0.0, 0.0, -9.81])
    base = (v0,) if is_floating else (None,)
    M = mechanics.joint_space_inertia(q)
    equal(robot.result("joint_space_inertia", "X"), M)
    bias = mechanics.bias_torque(q, qd, *base, weight)
    for suffix in ("", "_loaded"):
        still = bias - wrenches(mechanics, q, bool(suffix))
        free = np.linalg.solve(M[:first, :first], -(M[:first, first:] @ x + still[:first]))
        equal(robot.result(f"inverse_dynamics{suffix}", "tau"), (M @ [*free, *x] + still)[first:])
        moved = np.linalg.solve(M, [*np.zeros(first), *x] - still)
        equal(robot.result(f"forward_dynamics{suffix}", "qdd"), moved[first:], 1e-11)
        if is_floating:
            equal(robot.result(f"inverse_dynamics{suffix}", "a0"), free)
            equal(robot.result(f"forward_dynamics{suffix}", "a0"), moved[:6], 1e-11)
            driven = M @ [*a0, *x] + still
            equal(robot.result(f"inverse_dynamics_actuated{suffix}", "f0"), driven[:6])
            equal(robot.result(f"inverse_dynamics_actuated{suffix}", "tau"), driven[6:])
    held = M @ [*a0, *none] if is_floating else mechanics.gravity_torque(q, weight)
    moving = mechanics.bias_torque(q, qd, *base, none)
    for name, expected in (("gravity", held), ("coriolis", moving)):
        equal(robot.result(name, "tau"), expected[first:])
        if is_floating:
            equal(robot.result(name, "f0"), expected[:6])


@pytest.mark.parametrize("kind", ["floating", "fixed"])
def test_inertia(asked: dict[str, Asked], kind: str) -> None:
    bodies = asked[kind].mechanics.bodies
    expected = []
    for i in range(0 if kind == "floating" else 1, 4):
        (xx, xy, xz), (_, yy, yz), (_, _, zz) = bodies.inertias[i]
        expected += [bodies.masses[i], *bodies.coms[i], xx, xy, xz, yy, yz, zz]
    equal(asked[kind].result("inertia_properties", "m"), np.array(expected))


def test_frames_choose_the_pairs_that_have_one_of_them_on_either_side() -> None:
    analysis = kindsl.parse(MOVING, Settings(bindings={n: Binding(v) for n, v in VALUES.items()}))
    for frames in (("tip",), ("claw", "hand")):
        options = Options("robcogen", PLAIN, "double", False, "all", "crab", frames=frames)
        library, _ = generate(Source("crab.kindsl", analysis, {}, TRANSFORMS), options)
        own = {*frames, *(f"fr_{name}" for name in frames)}
        expected = [pair for pair in PAIRS if own & {*pair}]
        for pairs in library.wanted:
            assert [(base.name, target.name) for base, target in pairs] == expected


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ("base=fr_shell, target=tap\n", "transforms document, 4:23: "),
        ("\n\n  base=fr_Lift, target=tip\n", "transforms document, 6:8: "),
    ],
)
def test_an_unknown_frame_is_told_with_its_place(wrong: str, message: str) -> None:
    text = f"Robot Crab\nFrames {{ {LISTED} }}\nTransforms {{\n{wrong}}}\nJacobians {{ }}\n"
    analysis = kindsl.parse(MOVING, Settings(bindings={n: Binding(v) for n, v in VALUES.items()}))
    options = Options("robcogen", PLAIN, "double", False, "all", "crab")
    with pytest.raises(GenerationError) as error:
        generate(Source("crab.kindsl", analysis, {}, text), options)
    assert str(error.value).startswith(message)
