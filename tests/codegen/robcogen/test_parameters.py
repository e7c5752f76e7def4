"""Parameters that change while a program runs give what a document with their values gives."""

from pathlib import Path

import pytest
from tests.codegen.robcogen import test_classes
from tests.codegen.robcogen.programs import COMPILERS, QUICK, built, generated, needs_cpp, told
from tests.codegen.robcogen.test_classes import CRAB, VALUES, Case, program

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.products.codegen.library import Library

# A value of each class, of those that lengths and centres share, and of all at once.
CHANGES = {
    "nothing": {},
    "a length that is a CoM's coordinate too": {"reach": 0.5},
    "an angle": {"bend": -1.1},
    "a mass": {"body": 9.5},
    "a moment": {"spin": 0.3},
    "a product": {"twist": -0.04},
    "a centre of mass": {"shift": -0.3},
    "all": {"reach": -0.2, "bend": 2.5, "body": 1.5, "spin": 0.7, "twist": 0.01, "shift": 0.1},
}
TEXTS = {"floating": CRAB, "fixed": CRAB.replace("shell floating", "shell")}

GIVEN = """\
    struct Given : iit::@NS@::ParamsGetter_lengths,
                   iit::@NS@::ParamsGetter_angles,
                   iit::@NS@::dyn::RuntimeParamsGetter {
@VALUES@    };
    Given source;
    T::MotionTransforms X(source, source);
    T::ForceTransforms F(source, source);
    T::HomogeneousTransforms H(source, source);
    T::Jacobians J(source, source);
    T::InertiaProperties I(source);
"""
CHANGE = """\
    M.update(numbers<T::JointState>(1.3));
    id.setJointStatus(numbers<T::JointState>(0.3));
@VALUES@    if (arguments[1][0] == 'a') {
        X.updateParameters();
        F.updateParameters();
        H.updateParameters();
        J.updateParameters();
        I.updateParameters();
    } else {
        iit::@NS@::Params_lengths lengths;
        iit::@NS@::Params_angles angles;
        iit::@NS@::dyn::RuntimeInertiaParams inertia;
        lengths.reach = inertia.reach = source.reach;
        angles.bend = source.bend;
        inertia.body = source.body;
        inertia.spin = source.spin;
        inertia.twist = source.twist;
        inertia.shift = source.shift;
        X.updateParameters(lengths, angles);
        F.updateParams(lengths, angles);
        H.updateParams(lengths, angles);
        J.updateParams(lengths, angles);
        I.updateParameters(inertia);
    }
"""


@pytest.fixture(scope="module", params=TEXTS)
def compiled(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory):
    """Return a folder with a program that takes parameters' values, and its robot."""
    folder = tmp_path_factory.mktemp(request.param)
    analysis, library = generated(TEXTS[request.param], VALUES, folder)
    names = list(library.parameter_names)
    values = "".join(
        f"        double {n} = {VALUES[n]};\n"
        f"        double getValue_{n}() const override {{ return {n}; }}\n"
        for n in names
    )
    changes = "".join(
        f"    source.{n} = std::atof(arguments[{i}]);\n" for i, n in enumerate(names, 2)
    )
    text = program(library, GIVEN.replace("@VALUES@", values), CHANGE.replace("@VALUES@", changes))
    compiler = COMPILERS[0] if request.param == "fixed" else QUICK
    done = built(folder, "#include <cstdlib>\n" + text, "-std=c++14", compiler=compiler)
    assert (done.returncode, done.stderr) == (0, "")
    return folder, analysis, library


@needs_cpp
@pytest.mark.parametrize("way", ["asked", "handed"])
@pytest.mark.parametrize("change", CHANGES)
def test_outputs_after_an_update(
    compiled: tuple[Path, Analysis, Library], change: str, way: str
) -> None:
    folder, analysis, library = compiled
    values = {name: CHANGES[change].get(name, VALUES[name]) for name in library.parameter_names}
    case: Case = analysis.mechanism(values), library, told(folder, way, *map(repr, values.values()))
    is_floating = library.robot.tree.is_floating
    of_base = "floating" if is_floating else "fixed"
    for check in (
        "the_matrices", f"dynamics_of_a_{of_base}_base", "what_links_do",
        "transforms_and_jacobians", "inertia",
    ):  # fmt: skip
        getattr(test_classes, f"test_{check}")(case)
