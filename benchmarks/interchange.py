"""How far other programs' numbers for converted robots are from ours.

    python benchmarks/interchange.py [--trees 200]

Random trees and the published documents in MuJoCo, random trees through MJCF and SDF and back, and
the URDFs of example-robot-data, converted to MJCF, in MuJoCo against pinocchio on the URDF itself.
Differences are over the greatest entry of their kind, or one if that is more.
"""

import argparse
import re
import sys
import tempfile
from importlib.metadata import files
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import mujoco
import numpy as np
import pinocchio
from tests.interchange.mujoco_agreement import Gap, gap
from tests.interchange.random_robots import random_robot
from tests.interchange.round_trips import gaps, mechanism_of, written, written_and_read
from tests.support.published import CORPUS

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.robots.interchange.format import Format, FormatError, ReadingChoices
from kindsl.robots.interchange.kindsl_writing import kindsl_text
from kindsl.robots.interchange.registry import format_named
from kindsl.robots.mechanism.errors import ModelError, UnboundParameterError

# Of unbound parameters by what their names say: a body that exists.
STAND_INS = (("mass", 50.0), ("_Ix$|_Iy$|_Iz$", 10.0), ("", 0.05))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--trees", type=int, default=200, help="how many random trees")
    n = parser.parse_args().trees
    formats = {name: _format(name) for name in ("mjcf", "sdf", "urdf")}
    robots = [mechanism_of(kindsl_text(random_robot(seed))) for seed in range(n)]
    _tell(f"{n} random trees in MuJoCo", [in_mujoco(robot, 0) for robot in robots])
    with tempfile.TemporaryDirectory() as folder:
        for name in ("mjcf", "sdf"):
            found = [_there_and_back(robot, formats[name], Path(folder)) for robot in robots]
            _tell(f"{n} random trees to {formats[name].title} and back", found)
    published_documents()
    published_urdfs()


def in_mujoco(ours: Mechanics, seed: int) -> Gap:
    model = mujoco.MjModel.from_xml_string(written(ours, _format("mjcf")))
    return gap(ours, model, np.random.default_rng(seed))


def published_documents() -> None:
    """Tell of the documents of others, unbound parameters at a stand-in."""
    found, left_out = [], []
    for path in sorted(CORPUS.glob("*.kindsl")):
        document = kindsl.load(path, Settings())
        names = [str(p.name) for p in document.model.parameters if p.value is None]
        bindings = {name: Binding(_stand_in(name)) for name in names}
        try:
            ours = kindsl.load(path, Settings(bindings=bindings)).mechanism()
            found.append(in_mujoco(ours, 1))
        except (ModelError, UnboundParameterError, FormatError, ValueError) as error:
            left_out.append(f"  {path.stem}: {error}")
    if found:
        _tell(f"{len(found)} published documents in MuJoCo", found)
    print("\n".join(left_out))


def _stand_in(name: str) -> float:
    return next(value for pattern, value in STAND_INS if re.search(pattern, name))


def published_urdfs() -> None:
    """Tell of the URDFs of others: URDF, document, MJCF, MuJoCo against pinocchio on the URDF."""
    found, left_out = [], []
    located = (Path(str(file.locate())) for file in files("example-robot-data") or ())
    for path in sorted(path for path in located if path.suffix == ".urdf"):
        try:
            found.append(against_pinocchio(path))
        except (ModelError, FormatError, ValueError) as error:
            left_out.append(f"  {path.stem}: {error}")
    _tell(f"{len(found)} URDFs through MJCF in MuJoCo against pinocchio", found)
    print("\n".join(left_out))


def against_pinocchio(path: Path) -> Gap:
    """Return the differences in inertia and bias at a random state, of joints by their names."""
    urdf, mjcf = _format("urdf"), _format("mjcf")
    assert urdf.read is not None
    text = kindsl_text(urdf.read(path, ReadingChoices()).robot)
    ours = kindsl.parse(text, Settings()).mechanism()
    theirs = pinocchio.buildModelFromUrdf(str(path))
    model = mujoco.MjModel.from_xml_string(written(ours, mjcf))
    joints = theirs.names[1:] if not ours.bodies.is_floating else theirs.names[2:]
    chance = np.random.default_rng(len(joints))
    q, v = pinocchio.neutral(theirs), np.zeros(theirs.nv)
    data = mujoco.MjData(model)
    rows, columns = [], []
    for name in joints:
        joint = theirs.joints[theirs.getJointId(name)]
        value, rate = chance.uniform(-0.5, 0.5, 2)
        q[joint.idx_q : joint.idx_q + joint.nq] = (
            (np.cos(value), np.sin(value)) if joint.nq == 2 else value
        )
        v[joint.idx_v] = rate
        mine = data.joint(ours.joint_names[_like(name, ours)])
        mine.qpos[0], mine.qvel[0] = value, rate
        rows.append(joint.idx_v)
        columns.append(model.joint(ours.joint_names[_like(name, ours)]).dofadr[0])
    mujoco.mj_forward(model, data)
    M = np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, data, M)
    their_data = theirs.createData()
    M_theirs = pinocchio.crba(theirs, their_data, q)
    M_theirs = np.triu(M_theirs) + np.triu(M_theirs, 1).T
    bias = pinocchio.nonLinearEffects(theirs, their_data, q, v)
    return Gap(
        0.0,
        _relative(M_theirs[np.ix_(rows, rows)], M[np.ix_(columns, columns)]),
        _relative(bias[rows], data.qfrc_bias[columns]),
    )


def _like(name: str, ours: Mechanics) -> int:
    """Return the index of the joint whose name a URDF's joint has got."""
    from kindsl.robots.interchange.portable_names import valid_name

    wanted = valid_name(name)
    return next(i for i, own in enumerate(ours.joint_names) if own in (wanted, f"{wanted}_joint"))


def _there_and_back(robot: Mechanics, format: Format, folder: Path) -> Gap:
    after = written_and_read(robot, format, folder)
    return Gap(*gaps(robot, after, np.random.default_rng(0)))


def _relative(a: Any, b: Any) -> float:
    return float(abs(a - b).max() / max(1.0, abs(a).max()))


def _format(name: str) -> Format:
    format = format_named(name)
    assert format is not None
    return format


def _tell(what: str, found: list[Gap]) -> None:
    worst = [max(column) for column in zip(*found, strict=True)]
    told = ", ".join(f"{name} {value:.1e}" for name, value in zip(Gap._fields, worst, strict=True))
    print(f"{what}: {told}", flush=True)


if __name__ == "__main__":
    main()
