"""One program for each layout, built as its projects build: their folders, names and files."""

import shutil
import subprocess
from pathlib import Path
from typing import NamedTuple

import pytest
from tests.codegen.compiling import EIGEN
from tests.codegen.robcogen.programs import COMPILERS, QUICK, STRICT, generated, needs_cpp
from tests.codegen.robcogen.test_classes import CRAB, VALUES
from tests.support.amount import usually

from kindsl.products.codegen.robcogen.files import RUNTIME

MAIN = """\
#include <cmath>
#include <cstdio>
{includes}

typedef {names}::JointState::Scalar S;

int main()
{{
    const bool is_short = sizeof(S) == sizeof(float);
    const S little = S(is_short ? 1e-4 : 1e-9), step = S(is_short ? 1e-2 : 1e-5);
    {names}::JointState q, qd = {names}::JointState::Zero(), qdd, tau, again;
    q << S(0.3), S(-0.2), S(0.8);
    tau << S(1), S(-2), S(3);
    {names}::MotionTransforms motions;
    {names}::HomogeneousTransforms poses;
    {names}::Jacobians jacobians;
    {dynamics}::InertiaProperties inertia;
    {dynamics}::ForwardDynamics forward(inertia, motions);
    {dynamics}::InverseDynamics inverse(inertia, motions);
    typedef iit::rbd::Core<S>::VelocityVector Motion;
    Motion rest = Motion::Zero(), gravity = rest, a, b;
    gravity(iit::rbd::LZ) = S(-iit::rbd::g);
    forward.fd(qdd, a, rest, gravity, q, qd, tau);
    inverse.id(again, b, gravity, rest, q, qd, qdd);
    const S height = poses.fr_shell_X_tip(q)(2, 3);
    const S lift = jacobians.fr_shell_J_tip(q)(5, 0);
    q(0) += step;
    const S rise = (poses.fr_shell_X_tip(q)(2, 3) - height) / step;
    const bool is_right = (tau - again).norm() < little && (a - b).norm() < little
        && std::fabs(lift - rise) < step
        && {names}::getWholeBodyCOM(inertia, q, poses).norm() > S(0);
    std::puts(is_right ? "right" : "wrong");
    return is_right ? 0 : 1;
}}
"""


GCC = COMPILERS[0] if COMPILERS else ""


class Project(NamedTuple):
    """A program that was written for one of RobCoGen's forms.

    Attributes:
        options: What its headers are generated with.
        prefix: What it writes before the name of a header.
        names: Where it looks for names.
        dynamics: Where it looks for classes of dynamics.
        headers: The folder of the headers in the generated one.
        compiler: What builds it.
    """

    options: dict[str, object]
    prefix: str
    names: str
    dynamics: str
    headers: str = "."
    compiler: str = QUICK


PROJECTS = {
    "control-toolbox": Project(
        {"layout": "control-toolbox"}, "crab/generated/", "iit::Crab", "iit::Crab::dyn"
    ),
    "robcogen": Project(
        {"layout": "robcogen"}, "iit/robots/crab/", "iit::Crab", "iit::Crab::dyn",
        "iit/robots/crab",
    ),
    "float": Project(
        {"layout": "control-toolbox", "real": "float", "namespace": "a::b"},
        "", "a::b", "a::b::dyn", compiler=GCC,
    ),
    "robcogen-0.5": Project({"layout": "robcogen-0.5"}, "", "Crab::rcg", "Crab::rcg"),
    "pronto": Project(
        {"layout": "robcogen-0.5", "namespace": "pronto::crab", "has_sources": True},
        "crab_robcogen/", "pronto::crab", "pronto::crab::dyn", compiler=GCC,
    ),
}  # fmt: skip
HEADERS = (
    "declarations.h", "traits.h", "transforms.h", "jacobians.h", "inertia_properties.h",
    "forward_dynamics.h", "inverse_dynamics.h", "jsim.h", "miscellaneous.h",
)  # fmt: skip


@needs_cpp
@pytest.mark.parametrize("name", usually(("robcogen", "float", "pronto"), (*PROJECTS,)))
def test_a_project_is_built_as_it_stands(name: str, tmp_path: Path) -> None:
    project, made = PROJECTS[name], tmp_path / "made"
    generated(CRAB, VALUES, made, **{"has_runtime": False, **project.options})
    include, src, runtime = (tmp_path / folder for folder in ("include", "src", "own/iit/rbd"))
    shutil.copytree(RUNTIME / "iit/rbd", runtime)
    if project.options["layout"] == "robcogen-0.5":
        # What the headers of RobCoGen 0.5 do not have.
        shutil.rmtree(runtime / "traits")
        (runtime / "types.h").unlink()
    (include / project.prefix).mkdir(parents=True)
    src.mkdir()
    for file in (made / project.headers).glob("*.h"):
        shutil.copy(file, include / project.prefix)
    for file in (made / project.headers).glob("*.cpp"):
        shutil.copy(file, src)
    has_all = "has_sources" in project.options
    assert len(list(src.iterdir())) == (7 if has_all else 1)
    includes = "\n".join(f"#include <{project.prefix}{header}>" for header in HEADERS)
    (src / "main.cpp").write_text(
        MAIN.format(includes=includes, names=project.names, dynamics=project.dynamics)
    )
    command = [
        project.compiler, "-std=c++14", *STRICT, "-Wconversion", "-I", "own", "-I", "include",
        "-I", f"include/{project.prefix}", "-isystem", str(EIGEN),
        *(f"src/{name}.cpp" for name in ("main", "miscellaneous", *["jsim"] * has_all)),
        "-o", "program",
    ]  # fmt: skip
    done = subprocess.run(
        command, cwd=tmp_path, capture_output=True, text=True, timeout=280, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    told = subprocess.run([tmp_path / "program"], capture_output=True, text=True, check=True)
    assert told.stdout == "right\n"


@needs_cpp
def test_headers_that_a_project_lacks_build_on_its_own_ones(tmp_path: Path) -> None:
    made, own = tmp_path / "made", tmp_path / "own/iit/rbd"
    generated(CRAB, VALUES, made, layout="robcogen-0.5")
    shutil.copytree(RUNTIME / "iit/rbd", own)
    (own / "scalar_traits.h").unlink()
    for header in own.glob("*.h"):
        header.write_text(header.read_text().replace("IIT_RBD_", "OWN_"))
    (tmp_path / "main.cpp").write_text('#include "rbd_types.h"\n')
    command = [QUICK, "-std=c++14", "-fsyntax-only", "-I", "own", "-I", "made",
               "-isystem", str(EIGEN), "main.cpp"]  # fmt: skip
    subprocess.run(command, cwd=tmp_path, timeout=280, check=True)
