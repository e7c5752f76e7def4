"""Libraries of code for tests."""

from pathlib import Path

import numpy as np
from tests.dynamics.random_bodies import random_bodies

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.generation.functions import QUANTITIES
from kindsl.mechanics.dynamics.generation.jacobians import feet
from kindsl.mechanics.dynamics.generation.robot import robot_of
from kindsl.products.codegen.language import language_named
from kindsl.products.codegen.languages.c import c_files
from kindsl.products.codegen.library import Library, Options, Stamp, library_of
from kindsl.products.codegen.reference import Reference, independent_contacts, sample

PLAIN = tuple(name for name, quantity in QUANTITIES.items() if not quantity.group)
CONTROL = tuple(name for name, quantity in QUANTITIES.items() if quantity.group == "control")
ALL = tuple(QUANTITIES)
STAMP = Stamp("kindsl test", "robot.kindsl", "0" * 64, "none")


def bodies_of_seed(seed: int, most_links: int = 6) -> Bodies:
    """Return a random tree with revolute and prismatic joints, floating for odd seeds."""
    generator = np.random.default_rng(seed)
    n_links = int(generator.integers(1, most_links + 1))
    return random_bodies(generator, n_links, is_floating=bool(seed % 2))


def library(bodies: Bodies, quantities: tuple[str, ...] = PLAIN, **options: object) -> Library:
    """Return the library of a mechanism."""
    chosen = {
        "language": "c", "quantities": quantities, "real": "double", "is_single_header": False,
        "parameters": "unbound", "prefix": "robot", **options,
    }  # fmt: skip
    has_loops = language_named(str(chosen["language"])).has_loops
    return library_of(robot_of(bodies), "robot", {}, Options(**chosen), STAMP, has_loops=has_loops)


def reference(bodies: Bodies) -> Reference:
    """Return the right answers for a mechanism."""
    mechanics, values = Mechanics(bodies), sample(bodies)
    contacts = [foot.name for foot in feet(robot_of(bodies))]
    values["active"] = independent_contacts(mechanics, values["q"], contacts)
    return Reference(mechanics, values)


def write_c(bodies: Bodies, folder: Path, quantities: tuple[str, ...] = PLAIN, **options) -> Path:
    """Write a mechanism's library in C."""
    files = c_files(library(bodies, quantities, **options), reference(bodies))
    folder.mkdir(exist_ok=True)
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    return folder
