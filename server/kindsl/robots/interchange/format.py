"""A format of other tools: its name, its reader, its writer."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from importlib import import_module
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

from kindsl.language.text.phrases import alternatives, counted
from kindsl.mechanics.dynamics.quantities import STANDARD_GRAVITY

if TYPE_CHECKING:
    from kindsl.language.semantics.parameters import JointProperties
    from kindsl.robots.interchange.written_numbers import FileNumbers
    from kindsl.robots.mechanism.linkage import Linkage

    Joints = Mapping[str, JointProperties]


class FormatError(ValueError):
    """A file is not in its format, or not supported by the other one; one sentence."""


class ReadRobot(NamedTuple):
    """A robot that was read.

    Attributes:
        robot: All that a document says of it.
        remarks: Notes on parts that could not be kept.
        joints: Properties in the configuration, by joint name.
        tells_base: Whether the file says that the root floats, or that it is fixed.
        comments: Lines of text on the robot (without a name), on links and joints, by `"robot"`,
            `"link"` or `"joint"` and the name.
        find_numbers: Finds the numbers in its text, for comparing; none where that is not known.
        refused: Why it can be shown, but neither converted nor computed: sentences, mostly none.
        unknown: Links whose inertia is there and cannot be read.
    """

    robot: "Linkage"
    remarks: tuple[str, ...]
    joints: "Joints" = MappingProxyType({})
    tells_base: bool = False
    comments: Mapping[tuple[str, str], tuple[str, ...]] = MappingProxyType({})
    find_numbers: "Callable[[], FileNumbers]" = dict
    refused: tuple[str, ...] = ()
    unknown: frozenset[str] = frozenset()


class WrittenRobot(NamedTuple):
    """A text in another format.

    Attributes:
        remarks: Notes on what is more or less in it.
        joints: Properties to write into a configuration, by the document's joint names.
        names: What links, joints and frames of a document are called in it, by `"link"`, `"joint"`
            or `"frame"` and their names; links that are fixed to a link as that.
    """

    text: str
    remarks: tuple[str, ...]
    joints: "Joints" = MappingProxyType({})
    names: Mapping[tuple[str, str], str] = MappingProxyType({})


class ReadingChoices(NamedTuple):
    """Options of reading; each format takes what concerns it.

    Attributes:
        floating: Whether the root floats, whatever the file says.
        package_paths: Folders with packages, for a xacro file.
        arguments: Of a xacro file, by their names.
        model_paths: Folders with models, for an SDF.
    """

    floating: bool = False
    package_paths: tuple[Path, ...] = ()
    arguments: Mapping[str, str] = MappingProxyType({})
    model_paths: tuple[Path, ...] = ()


class WritingChoices(NamedTuple):
    """Options of a format, and values that the document does not have.

    Attributes:
        endless_joints: Whether revolute joints are written as endless ones where a format has
            these, or as ordinary ones.
        joints: Properties in the configuration, by joint name.
        fixed_base_mass: Of the document's base, if it is fixed, kg.
    """

    endless_joints: bool = False
    joints: "Joints" = MappingProxyType({})
    fixed_base_mass: float = 0.0


_INDEPENDENT = ": it is now independent"
AS_WRITTEN = ReadingChoices()
ORDINARY = WritingChoices()


def told_joints(joints: "Iterable[tuple[str, JointProperties]]") -> "Joints":
    """Return the properties of the joints of which anything is told, by joint name."""
    return {name: own for name, own in joints if any(value is not None for value in own)}


def joints_dropped(joints: "Joints") -> str:
    """Return the note on limits and friction of joints, which the language does not support."""
    where = "kindsl.toml takes them, as [joints.NAME]"
    return f"limits, friction and armature of {counted(len(joints), 'joint')} dropped: {where}"


def fixed_base_dropped(base: str, choices: WritingChoices) -> Iterator[str]:
    """Yield the note on a fixed base's mass, which a file does not get."""
    if choices.fixed_base_mass:
        mass = f"{choices.fixed_base_mass:.6g} kg"
        yield f"mass and inertia of the fixed base '{base}' ({mass}) dropped: they move nothing"


def armature_dropped(title: str, names: Iterable[str], joints: "Joints") -> Iterator[str]:
    """Yield the note on the armature of joints of these names, which a format does not support."""
    known = (joints[name].armature for name in names if name in joints)
    number = sum(armature is not None for armature in known)
    if number:
        yield f"armature of {counted(number, 'joint')} dropped: not supported by {title}"


def suffix_unknown(suffix: str, known: Iterable[str], otherwise: str = "") -> str:
    """Return the sentence on a file whose name does not tell its format.

    Args:
        suffix: The file's suffix.
        known: Those that do.
        otherwise: What else would.
    """
    told = f"the suffix '{suffix}'" if suffix else "a name without a suffix"
    return f"{told} does not determine the format: use {alternatives(known)}{otherwise}"


def mimic_dropped(joint: str, other: str) -> str:
    """Return the note on a joint that moves as another does."""
    return f"the joint '{joint}' mimics '{other}'{_INDEPENDENT}"


def n_mimics(remarks: Iterable[str]) -> int:
    """Return how many notes are on such joints."""
    return sum(remark.endswith(_INDEPENDENT) for remark in remarks)


def drawings_dropped(parent: Any) -> Iterator[str]:
    """Yield the note on the shapes of an element's links, which a document does not have."""
    drawn = {link for tag in ("visual", "collision") for link in parent.iterfind(f"link[{tag}]")}
    if number := len(drawn):
        yield f"visuals and collisions of {counted(number, 'link')} dropped"


def gravity_dropped(gravity: Sequence[float]) -> str:
    """Return the note on a gravity other than the usual one, m/s^2 in the world's frame."""
    numbers = ",".join(f"{component:.15g}" for component in gravity)
    usual = ", ".join(f"{component:g}" for component in STANDARD_GRAVITY)
    told = f"gravity ({numbers.replace(',', ', ')}) m/s² dropped"
    return f"{told}: kindsl computes with ({usual}) unless given --gravity={numbers}"


def repaired(skeleton: "Linkage") -> "tuple[Linkage, tuple[str, ...]]":
    """Return a robot whose bodies have the nearest possible inertia, and a note on each changed."""
    from kindsl.mechanics.rigid.body import nearest_possible

    masses = [None if b.mass is None else nearest_possible(b.mass) for b in skeleton.bodies]
    notes = tuple(
        f"inertia of '{name}' is impossible: the nearest possible one written"
        for name, old, new in zip(skeleton.body_names, skeleton.masses, masses, strict=True)
        if new is not None and new != old
    )
    return skeleton.with_masses(masses), notes


Reader = Callable[[Path, ReadingChoices], ReadRobot]
Parser = Callable[[bytes | str, str, ReadingChoices], ReadRobot]
Writer = Callable[[str, "Linkage", WritingChoices], WrittenRobot]


def lazily(function: str) -> Any:
    """Return what calls a function of this folder, `module:name`, which is loaded only then."""
    module, _, name = function.partition(":")
    folder = __name__.rpartition(".")[0]
    return lambda *args: getattr(import_module(f"{folder}.{module}"), name)(*args)


def file_reader(parse: Parser) -> Reader:
    """Return what reads files of a format whose texts say it all."""
    return lambda path, choices: parse(path.read_bytes(), path.stem, choices)


class Format(NamedTuple):
    """One format; a module of the folder `interchange` holds it as `FORMAT`.

    Attributes:
        name: Its name on the command line: `"urdf"`.
        title: Its name for people: `"URDF"`.
        suffixes: Of its files, in lower case, the usual one first.
        read: Takes a file and choices. Raises FormatError, OSError, and ModuleNotFoundError for
            what is not installed.
        parse: The same of a text, which names no other files, and what to call a robot without a
            name. None where it takes more than the text.
        write: Takes the robot's name, its skeleton and choices. Raises FormatError and
            ModuleNotFoundError.
    """

    name: str
    title: str
    suffixes: tuple[str, ...]
    read: Reader | None = None
    parse: Parser | None = None
    write: Writer | None = None
