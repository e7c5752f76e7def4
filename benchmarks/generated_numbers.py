"""How far generated code is from the book's algorithms: the greatest differences that there are.

    python benchmarks/generated_numbers.py [--trees N] [--extreme N] [--corpus FOLDER]

Each library is generated with all quantities, compiled (cc -O0), called, and compared with
the book's algorithms, which share no code with what is generated. A difference is relative to
the greatest entry of a result, or to one. C and NumPy do all trees; CasADi and JAX, whose
operations are slow one by one, some.

Three tables: random trees (fixed and floating, prismatic joints, branches); documents with their
parameters bound and as inputs of the code; and extreme values: masses between 1e-8 and 1e8, angles
near 1e4 and of 1e8. There differences are relative to the greatest entry of all results of a
function, and those of what solves for accelerations are told in units of rounding times the
condition of the inertia matrix, each variable in units of its own inertia.
"""

import argparse
import subprocess
import sys
import tempfile
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import NamedTuple, TypeAlias

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tests.codegen.loaded import Loaded
from tests.codegen.robots import ALL, bodies_of_seed, library

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation import book
from kindsl.mechanics.dynamics.evaluation.book import Request
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.generation.function import Function
from kindsl.mechanics.spatial.arrays import Array
from kindsl.products.codegen.c_test_program import parameter_values
from kindsl.products.codegen.generating import Source, generate
from kindsl.products.codegen.language import language_named
from kindsl.products.codegen.library import GenerationError, Library, Options
from kindsl.products.codegen.reference import Reference, sample
from kindsl.robots.mechanism.errors import ModelError

ROOT = Path(__file__).resolve().parents[1]
KEYWORDS = {"v0": "base_velocity", "a0": "base_acceleration", "g": "gravity"}
SOLVING = ("forward_dynamics", "forward_dynamics_derivatives", "inertia_factorization")
ROUNDING = float(np.finfo(float).eps)

# The greatest difference of each kind, and where it is.
Worst: TypeAlias = dict[str, tuple[float, str]]
Caller: TypeAlias = Callable[[Function, Mapping[str, Array], bool], list[Array]]


class Answers(NamedTuple):
    """What a function gave in one language, and what it should give."""

    function: Function
    found: list[Array]
    expected: list[Array]


class _Book:
    """Evaluates by the book's algorithms, always."""

    def __init__(self, bodies: Bodies) -> None:
        self._bodies = bodies

    def evaluate(self, request: Request) -> Array:
        return book.evaluate(self._bodies, request)


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--trees", metavar="N", type=int, default=100)
    parser.add_argument("--first", metavar="SEED", type=int, default=0, help="of the first tree")
    parser.add_argument("--extreme", metavar="N", type=int, default=30)
    parser.add_argument("--links", metavar="N", type=int, default=4, help="most links of a tree")
    parser.add_argument("--corpus", metavar="FOLDER", type=Path)
    args = parser.parse_args()
    random_trees(range(args.first, args.first + args.trees), args.links)
    given = sorted(args.corpus.glob("*.kindsl")) if args.corpus else []
    documents([*_own_documents(), *given])
    extreme_values(args.extreme)


def random_trees(seeds: range, links: int) -> None:
    """Print the greatest difference of each language over random trees."""
    worst: Worst = {}
    done: dict[str, int] = defaultdict(int)
    for seed in seeds:
        bodies = bodies_of_seed(seed, links)
        expected = _book(bodies)
        made = {"c": library(bodies, ALL), "python": library(bodies, ALL, language="python")}
        if seed % 10 < 2:
            made["casadi"] = library(bodies, ALL, language="casadi")
        if seed % 50 < 2:
            made["jax"] = library(bodies, ALL[:6], language="jax")
        for language, one in made.items():
            done[language] += 1
            for answers in _answers(one, _caller(one, _files(one, expected), {}), expected):
                _keep(worst, language, answers, f"seed {seed}")
        print(f"tree {seed} is done", end="\r", file=sys.stderr, flush=True)
    for language, (difference, where) in worst.items():
        _row("random trees", f"{done[language]} in {language}", difference, where)


def documents(paths: list[Path]) -> None:
    """Print the greatest difference for each document, its parameters bound and as inputs."""
    for path in paths:
        analysis = analyse(path.read_text(encoding="utf-8", errors="surrogateescape"))
        for choice in ("unbound", "all") if analysis.model.parameters else ("unbound",):
            try:
                worst = _document(path, analysis, choice)
            except (GenerationError, ModelError) as error:
                print(f"{path.stem[:34]:36} {choice:12} {error}")
                continue
            for language, (difference, where) in worst.items():
                _row(path.stem[:34], f"{choice} in {language}", difference, where)


def _document(path: Path, analysis: Analysis, choice: str) -> Worst:
    worst: Worst = {}
    for language in ("c", "python"):
        options = Options(language, ALL, "double", False, choice, "robot")
        made, files = generate(Source(path.name, analysis, {}), options)
        values = parameter_values(made.defaults.items())
        expected = _book(analysis.mechanism(values).bodies)
        for answers in _answers(made, _caller(made, files, values), expected):
            _keep(worst, language, answers, "")
    return worst


def extreme_values(count: int) -> None:
    """Print the greatest differences for masses and angles of extreme sizes."""
    worst: Worst = {}
    for seed in range(count):
        bodies = bodies_of_seed(seed, 5)
        generator = np.random.default_rng(1000 + seed)
        factors = 10.0 ** generator.uniform(-8.0, 8.0, bodies.n_links + 1)
        heavy = replace(
            bodies,
            masses=bodies.masses * factors,
            inertias=bodies.inertias * factors[:, None, None],
        )
        _extremes(worst, heavy, {"masses 1e-8 .. 1e8": 1.0}, f"seed {seed}")
        angles = {"angles near 1e4": 1e4, "angles near 1e8": 1e8}
        _extremes(worst, bodies, angles, f"seed {seed}")
    for what, (difference, where) in sorted(worst.items()):
        _row("extreme values", what, difference, where)


def _extremes(worst: Worst, robot: Bodies, reaches: dict[str, float], where: str) -> None:
    made, values = library(robot, ALL), sample(robot)
    call = _caller(made, _files(made, _book(robot)), {})
    revolute = np.array([kind == "revolute" for kind in robot.joint_kinds])
    for what, reach in reaches.items():
        far = reach * (1.0 + 1e-3 * values["q"])
        expected = _book(
            robot, {**values, "q": np.where(revolute & (reach > 1.0), far, values["q"])}
        )
        rounding = ROUNDING * _condition(expected)
        for answers in _answers(made, call, expected):
            name = answers.function.name
            solves = name in SOLVING or (robot.is_floating and name == "inverse_dynamics")
            unit, kind = (rounding, "solved / (eps cond)") if solves else (1.0, "all else")
            _keep(worst, f"{what}, {kind}", answers, where, unit, least=0.0)


def _condition(expected: Reference) -> float:
    """Return the condition of the inertia matrix, each variable in units of its own inertia."""
    M = expected.mechanics.joint_space_inertia(expected.values["q"])
    units = np.sqrt(np.diagonal(M))
    return float(np.linalg.cond(M / np.outer(units, units)))


def _own_documents() -> list[Path]:
    fixtures = ROOT / "tests" / "fixtures"
    folders = (fixtures / "reference", fixtures / "robots", ROOT / "examples")
    return [path for folder in folders for path in sorted(folder.glob("*.kindsl"))]


def _book(bodies: Bodies, values: Mapping[str, Array] | None = None) -> Reference:
    mechanics = Mechanics(bodies)
    mechanics._forms = _Book(bodies)
    return Reference(mechanics, values or sample(bodies))


def _files(made: Library, expected: Reference) -> dict[str, str]:
    return language_named(made.options.language).files(made, expected)


def _answers(made: Library, call: Caller, expected: Reference) -> Iterator[Answers]:
    """Yield the answers of all functions, with and without external forces."""
    for function in made.all_functions:
        yield Answers(function, call(function, expected.values, False), expected.results(function))
        if function.loaded is not None:
            found = call(function, expected.values, True)
            yield Answers(function, found, expected.loaded_results(function))


def _caller(made: Library, files: Mapping[str, str], parameters: Mapping[str, float]) -> Caller:
    """Return what calls a library's functions, with external forces or without."""
    return (_compiled if made.options.language == "c" else _imported)(made, files, parameters)


def _compiled(made: Library, files: Mapping[str, str], parameters: Mapping[str, float]) -> Caller:
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        for name, text in files.items():
            (place / name).write_text(text, encoding="utf-8")
        sources = [str(p) for p in place.glob("*.c") if not p.name.endswith("_test.c")]
        options = ["-std=c11", "-O0", "-shared", "-fPIC", "-lm", "-o", str(place / "robot.so")]
        subprocess.run(["cc", *sources, *options], check=True)
        loaded = Loaded(place / "robot.so", made, parameters)
    return lambda function, values, is_loaded: loaded.call(
        function, values if is_loaded else {**values, "fext": None}
    )


def _imported(made: Library, files: Mapping[str, str], parameters: Mapping[str, float]) -> Caller:
    language = made.options.language
    (text,) = (text for name, text in files.items() if name.endswith(".py"))
    if language == "jax":
        import jax

        jax.config.update("jax_enable_x64", True)
    convert = __import__("casadi").DM if language == "casadi" else np.asarray
    module = ModuleType("robot")
    exec(compile(text, "robot.py", "exec"), module.__dict__)

    def call(function: Function, values: Mapping[str, Array], is_loaded: bool) -> list[Array]:
        given = {KEYWORDS.get(a.name, a.name): values[a.name] for a in function.arguments}
        if is_loaded:
            given["external_forces"] = values["fext"]
        numbers = {name: convert(value) for name, value in given.items()}
        more = {"parameters": parameters} if parameters else {}
        found = getattr(module, made.function_names[function.name])(**numbers, **more)
        return [np.asarray(x) for x in (found if isinstance(found, tuple) else (found,))]

    return call


def _keep(
    worst: Worst, key: str, answers: Answers, where: str, unit: float = 1.0, least: float = 1.0
) -> None:
    """Keep the greatest difference; what is finite on one side only counts as infinite."""
    # Of all results of a function: one of them may be nothing but rounding errors of the others.
    greatest = max(float(np.max(abs(x), initial=0.0)) for x in answers.expected)
    for found, expected in zip(answers.found, answers.expected, strict=True):
        found, expected = np.ravel(found), np.ravel(expected)
        own = float(np.max(abs(expected), initial=0.0)) if least else greatest
        scale = max(least, own) or 1.0
        difference = float(np.max(abs(found - expected), initial=0.0)) / scale / unit
        difference = difference if np.isfinite(difference) else np.inf
        if difference >= worst.get(key, (-1.0, ""))[0]:
            worst[key] = (difference, f"{answers.function.name} {where}")


def _row(what: str, kind: str, difference: float, where: str) -> None:
    print(f"{what:36} {kind:50} {difference:9.1e}  {where}", flush=True)


if __name__ == "__main__":
    main()
