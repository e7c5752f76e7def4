"""A robot with the names that RobCoGen's C++ has for its parts, and its functions as templates."""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from kindsl.language.semantics.declarations import ValueKind
from kindsl.language.text.distinct import distinct
from kindsl.mechanics.dynamics.generation.emitters.c import CBody, Dialect, c_definition
from kindsl.mechanics.dynamics.generation.relative_frames import relative_pose
from kindsl.mechanics.dynamics.generation.robot import PlacedFrame
from kindsl.mechanics.dynamics.generation.terms import Scalar, Term, needed
from kindsl.mechanics.dynamics.generation.tree import Tree
from kindsl.mechanics.dynamics.generation.vectors import Matrix, Vector
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.names_in_code import identifiers, prefix_of, whole_name

if TYPE_CHECKING:
    from jinja2 import Environment

MOST_JOINTS_OF_SMALL = 20
LAYOUT_OF_0_5 = "robcogen-0.5"

_TEMPLATES = Path(__file__).parents[1] / "templates" / "robcogen"

# Enumerators of these names would be hidden where classes use them.
_TYPES_IN_CLASSES = ("TRAIT", "SCALAR")

DIALECT = Dialect(
    "S",
    sign="",
    number="S({})",
    scope="TRAIT::",
    parameter="TRAIT",
    scalar="typename TRAIT::Scalar",
)


class GeneratedParameter(NamedTuple):
    """A run-time parameter.

    Attributes:
        place: In the list of all parameters.
        name: In code.
        value: That it had when the code was generated, None where it had none.
    """

    place: int
    name: str
    value: float | None


class MatrixMember(NamedTuple):
    """A transform or Jacobian as a member of a class.

    Attributes:
        name: The member's name.
        columns: How many columns a Jacobian has.
        has_parameters: Whether it depends on parameters.
    """

    name: str
    columns: int
    has_parameters: bool


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
        """The innermost namespace: the robot's name, unless another was asked for."""
        name, prefix = self.library.robot_name, self.library.prefix
        if self.library.options.namespace:
            return self.namespaces[-1]
        return whole_name(name) if name and prefix == prefix_of(name, None) else prefix

    @property
    def namespaces(self) -> list[str]:
        """The namespaces around all names, the outermost first."""
        given = self.library.options.namespace
        return given.split("::") if given else ["iit", self.space]

    @property
    def has_names_of_0_5(self) -> bool:
        """True if the headers have the names of RobCoGen 0.5 and need its runtime only."""
        return self.library.options.layout == LAYOUT_OF_0_5

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
        space = names[0] if self.library.options.namespace else self.space
        in_code = zip(names, (space, *self._enumerators), strict=True)
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
        gives: Mapping[str, Sequence[Scalar | None]],
        *,
        has_comments: bool = True,
    ) -> str:
        """Return a function; where the robot has parameters, it takes them first."""
        parameters: list[Scalar] = [*self.library.robot.parameters.values()]
        first = {"p": parameters} if parameters else {}
        comments = self._comments if has_comments else {}
        body = CBody(name, {**first, **takes}, gives, comments=comments)
        return c_definition(self.library.robot.graph, body, DIALECT)

    @cached_property
    def _comments(self) -> dict[int, str]:
        """What the code of a link begins with, by the node of its joint's position."""
        both = zip(self.bodies[1:], self.joints, self.library.inputs.q, strict=True)
        return {q.index: f"{body}, by {joint}" for body, joint, q in both if isinstance(q, Term)}

    def matrix_kernels(self, name: str, columns: Sequence[Sequence[Scalar]]) -> list[str]:
        """Return two functions: of a matrix's constants other than zero, and of what varies."""
        return self.entry_kernels(name, {"X": [x for column in columns for x in column]})

    def entry_kernels(self, name: str, gives: Mapping[str, Sequence[Scalar | None]]) -> list[str]:
        """Return the same of matrices by their names; None are entries that are not theirs."""
        constants = {
            array: {k: repr(x) for k, x in enumerate(entries) if isinstance(x, float) and x}
            for array, entries in gives.items()
        }
        fixed = self.rendered("matrix_constants.h", name=name, constants=constants)
        varying = {a: [x if isinstance(x, Term) else None for x in gives[a]] for a in gives}
        return [fixed, self.kernel(name, {"q": self.library.inputs.q}, varying, has_comments=False)]

    @cached_property
    def parameters(self) -> list[GeneratedParameter]:
        """All parameters."""
        library = self.library
        both = zip(library.parameter_names.values(), library.defaults.values(), strict=True)
        return [GeneratedParameter(place, name, value) for place, (name, value) in enumerate(both)]

    def _parameters_of(self, kind: ValueKind) -> list[GeneratedParameter]:
        kinds = self.library.parameter_kinds
        both = zip(self.library.parameter_names, self.parameters, strict=True)
        return [parameter for name, parameter in both if kind in kinds[name]]

    @property
    def inertial(self) -> list[GeneratedParameter]:
        """The parameters of links' inertia."""
        return self._parameters_of(ValueKind.DYNAMICS)

    @cached_property
    def kinematic(self) -> dict[str, list[GeneratedParameter]]:
        """The parameters of frames, by their class."""
        kinds = {"lengths": ValueKind.LENGTH, "angles": ValueKind.ANGLE}
        return {group: self._parameters_of(kind) for group, kind in kinds.items()}

    @property
    def kinematic_groups(self) -> dict[str, list[GeneratedParameter]]:
        """The classes of them that the robot has."""
        return {group: found for group, found in self.kinematic.items() if found}

    @property
    def kinematic_parameters(self) -> list[str]:
        """All parameters as a transform lists them, which reads kinematic ones only."""
        texts = ["Scalar(0)"] * len(self.parameters)
        for group, found in self.kinematic.items():
            for parameter in found:
                texts[parameter.place] = f"Scalar({group}_values.{parameter.name})"
        return texts

    def header(self, file: str, template: str = "", /, **values: object) -> str:
        """Return a header: its guard, where it is from, a template's text."""
        space = "_".join(["IIT_ROBOT", *self.namespaces[self.namespaces[0] == "iit" :]])
        guard = f"{space.upper()}_{re.sub(r'[^A-Z]', '_', file.upper())}_"
        body = self.rendered(template or file, file=file.removesuffix(".h"), **values)
        stamp = self.library.stamp
        return (
            f"#ifndef {guard}\n#define {guard}\n"
            f"// {stamp.origin}\n// {stamp.licence}\n\n"
            f"{body.rstrip()}\n\n#endif\n"
        )

    def rendered(self, template: str, /, **values: object) -> str:
        """Return the text of a template, which sees the robot, what it often reads, and values.

        Raises:
            ModuleNotFoundError: Jinja is not installed.
        """
        has_p, real = self.has_parameters, self.library.options.real
        trait = f"{real.title()}Trait"
        text = templates().get_template(template)
        return text.render(
            robot=self,
            stamp=self.library.stamp,
            links=self.tree.links(),
            base=self.bodies[0],
            space="::".join(self.namespaces),
            opening="\n".join(f"namespace {name} {{" for name in self.namespaces),
            closing="\n".join("}" for _ in self.namespaces),
            real=real,
            trait=f"iit::rbd::{trait}s" if self.has_names_of_0_5 else f"iit::rbd::{trait}",
            trait_header="scalar_traits.h" if self.has_names_of_0_5 else f"traits/{trait}.h",
            vector3="iit::rbd::Vector3d" if real == "double" else "iit::rbd::Core<float>::Vector3",
            has_rcg_namespace=self.has_names_of_0_5 and not self.library.options.namespace,
            p="p, " if has_p else "",
            takes_p="const typename TRAIT::Scalar* p, " if has_p else "",
            **values,
        )


@cache
def templates() -> "Environment":
    """Return the templates, in Jinja's language with `@` around what is filled in."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    return Environment(
        variable_start_string="@",
        variable_end_string="@",
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        undefined=StrictUndefined,
        autoescape=False,
        loader=FileSystemLoader(_TEMPLATES, encoding="utf-8"),
    )
