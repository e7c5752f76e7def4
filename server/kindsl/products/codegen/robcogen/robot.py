"""A robot with the names that RobCoGen's C++ has for its parts, and its functions as templates."""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

from kindsl.language.text.distinct import distinct
from kindsl.mechanics.dynamics.generation.emitters.cpp_templates import (
    Template,
    TemplateDialect,
    template_function,
)
from kindsl.mechanics.dynamics.generation.relative_frames import relative_pose
from kindsl.mechanics.dynamics.generation.robot import PlacedFrame
from kindsl.mechanics.dynamics.generation.terms import Scalar, needed
from kindsl.mechanics.dynamics.generation.tree import Tree
from kindsl.mechanics.dynamics.generation.vectors import Matrix, Vector
from kindsl.products.codegen.filling import fill
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.names_in_code import identifiers, prefix_of, whole_name

MOST_JOINTS_OF_SMALL = 20

# Enumerators of these names would be hidden where classes use them.
_TYPES_IN_CLASSES = ("TRAIT", "SCALAR")

DIALECT = TemplateDialect("class TRAIT", "TRAIT::Scalar", "TRAIT", "TRAIT::{}({})")


@dataclass(frozen=True)
class GeneratedRobot:
    """The robot that the headers are written from.

    Attributes:
        library: The robot, its inputs, and where it comes from.
    """

    library: Library

    @property
    def tree(self) -> Tree:
        """The mechanism."""
        return self.library.robot.tree

    @property
    def is_floating(self) -> bool:
        """True if the base is free."""
        return self.tree.is_floating

    @cached_property
    def space(self) -> str:
        """The robot's namespace: its name as in the document, unless another was asked for."""
        name, prefix = self.library.robot_name, self.library.prefix
        return whole_name(name) if name and prefix == prefix_of(name, None) else prefix

    @cached_property
    def joints(self) -> list[str]:
        """The names of joints."""
        return list(identifiers(self.library.robot.joint_names).values())

    @cached_property
    def bodies(self) -> list[str]:
        """The names of bodies, base first."""
        return list(identifiers(self.body_names).values())

    @property
    def body_names(self) -> tuple[str, ...]:
        """The names of bodies in the document, base first."""
        return (self.library.robot.base_name, *self.library.robot.link_names)

    @cached_property
    def frame_names(self) -> dict[str, str]:
        """The names of frames in code: of bodies' and joints' own and of those that are listed."""
        own = (*self.body_names, *self.library.robot.joint_names)
        listed = chain(*self.library.wanted.transforms, *self.library.wanted.jacobians)
        names = [*(f"fr_{name}" for name in own), *(frame.name for frame in listed)]
        return identifiers(dict.fromkeys(names))

    @cached_property
    def renamed(self) -> dict[str, str]:
        """The names that are others in code; of a link or joint, that of its enumerator."""
        robot = self.library.robot
        names = (self.library.robot_name, *robot.joint_names, *self.body_names)
        in_code = zip(names, (self.space, *self._enumerators), strict=True)
        changed = [(name, safe) for name, safe in in_code if safe.upper() != name.upper()]
        others = {k: v for k, v in self.library.renamed.items() if k != names[0]}
        return {**others, **dict(changed)}

    @cached_property
    def _enumerators(self) -> list[str]:
        names = (name.upper() for name in (*self.joints, *self.bodies))
        unlike = distinct((*_TYPES_IN_CLASSES, *names))[len(_TYPES_IN_CLASSES) :]
        return list(identifiers(unlike).values())

    @property
    def joint_ids(self) -> list[str]:
        """The enumerators of joints."""
        return self._enumerators[: len(self.joints)]

    @property
    def body_ids(self) -> list[str]:
        """The enumerators of bodies."""
        return self._enumerators[len(self.joints) :]

    @property
    def n_joints(self) -> int:
        """Number of joints."""
        return len(self.joints)

    @property
    def n_velocities(self) -> int:
        """Rows of the joint-space inertia."""
        return self.library.robot.n_velocities

    @property
    def inertial_bodies(self) -> list[int]:
        """The bodies whose inertia matters: all but a fixed base."""
        return [i for i in range(len(self.bodies)) if i or self.is_floating]

    @property
    def is_large(self) -> bool:
        """True if compilers take so long for a text of its size that it is rather short."""
        return self.n_joints > MOST_JOINTS_OF_SMALL

    def pose_in(self, base: PlacedFrame, target: PlacedFrame) -> tuple[Matrix, Vector]:
        """Return rotation and position of a frame in another."""
        return relative_pose(self.library.robot, self.library.inputs.q, base, target)

    def frame(self, body: int) -> str:
        """Return the name of a body's own frame."""
        return self.frame_names[f"fr_{self.body_names[body]}"]

    def across(self, joint: int) -> str:
        """Return the name of the transform from a link's parent to it, by body index."""
        return f"{self.frame(joint)}_X_{self.frame(self.tree.parents[joint])}"

    def back_across(self, joint: int) -> str:
        """Return the name of the transform from a link to its parent, by body index."""
        return f"{self.frame(self.tree.parents[joint])}_X_{self.frame(joint)}"

    @property
    def has_parameters(self) -> bool:
        """True if anything is known only when the code runs."""
        return bool(self.library.robot.parameters)

    def depends_on_parameters(self, values: Iterable[Scalar]) -> bool:
        """Return whether values depend on parameters."""
        inputs = {p.index for p in self.library.robot.parameters.values()}
        return bool(inputs) and not inputs.isdisjoint(needed(self.library.robot.graph, values))

    def kernel(
        self,
        name: str,
        takes: Mapping[str, Sequence[Scalar]],
        gives: Mapping[str, Sequence[Scalar]],
        is_update: bool = False,
    ) -> str:
        """Return a function; where the robot has parameters, it takes them first."""
        parameters: list[Scalar] = [*self.library.robot.parameters.values()]
        first = {"p": parameters} if parameters else {}
        function = Template(name, {**first, **takes}, gives, is_update)
        return template_function(self.library.robot.graph, function, DIALECT)

    def matrix_kernels(self, name: str, columns: Sequence[Sequence[Scalar]]) -> list[str]:
        """Return two functions: of a matrix's constants other than zero, and of what varies."""
        entries = [x for column in columns for x in column]
        fixed = [
            f"    X[{place}] = S({entry!r});\n"
            for place, entry in enumerate(entries)
            if isinstance(entry, float) and entry
        ]
        alias = "    typedef typename TRAIT::Scalar S;\n"
        body = "".join([alias, *fixed]) if fixed else "    (void)X;\n"
        constants = (
            f"template <class TRAIT>\ninline void {name}_constants(typename TRAIT::Scalar* X)\n"
            f"{{\n{body}}}\n"
        )
        return [constants, self.kernel(name, {"q": self.library.inputs.q}, {"X": entries}, True)]

    def header(self, file: str, includes: Sequence[str], body: str) -> str:
        """Return a header: its guard, where it is from, its includes, its content."""
        guard = f"IIT_ROBOT_{self.space.upper()}_{re.sub(r'[^A-Z]', '_', file.upper())}_"
        listed = "".join(f"#include {name}\n" for name in includes)
        stamp = self.library.stamp
        return (
            f"#ifndef {guard}\n#define {guard}\n"
            f"// Generated by {stamp.generator} from {stamp.document}; do not edit.\n\n"
            f"{listed}\n{body.strip()}\n\n#endif\n"
        )

    def headers(
        self, file: str, includes: Sequence[str], body: str, functions: Iterable[str]
    ) -> dict[str, str]:
        """Return a header, and that of the functions that it calls, by their names."""
        own, impl = f"{file}.h", f"{file}.impl.h"
        text = "\n".join(functions)
        head = f"namespace iit {{\nnamespace {self.space} {{\nnamespace kernels {{\n"
        kernels = f"{head}\n{text}\n}}\n}}\n}}"
        return {
            own: self.header(own, [*includes, f'"{impl}"'], body),
            impl: self.header(impl, ['"declarations.h"'], kernels),
        }

    def filled(self, text: str, **values: object) -> str:
        """Return a text in which `@NAME@` stands for a value: a given one, or one of the robot."""
        has_p = self.has_parameters
        known: dict[str, object] = {
            "NS": self.space, "NJ": self.n_joints, "NV": self.n_velocities, "NB": len(self.bodies),
            "BASE": self.bodies[0], "P": "p, " if has_p else "",
            "TAKES": "const typename TRAIT::Scalar* p, " if has_p else "", **values,
        }  # fmt: skip
        return fill(text, **known)
