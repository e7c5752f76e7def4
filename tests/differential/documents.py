"""Random documents of the language, and mistakes in them: what generators may disagree on."""

import random
from collections.abc import Iterator
from typing import NamedTuple

CLEAN = ("1.0", "0.5", ".5", "-1.0", "+1.0", "007.50", "0.0", "PI", "-PI", "PI/2.0", "x", "-x")
VALUES = (
    *CLEAN, "-PI/2.0", "x/2.0", "l1_x", "1.0e3", ".5e2", "1.0E5", "1e3", "1e-3", "1.0e-3", "1.",
    "1.e5", "- 1.0", "--1.0", "+ 1.0", "1", "0", "-3", "1,5", "1.0.0", "0x10", "1_0.0", "pi", "Pi",
    "pI", "pi/2.0", "-pi/2", "PI/2", "PI/2.", "PI/1e1", "PI/0.0", "PI/0", "1.0/0.0", "1.0/0",
    "2.0*PI", "-2.0*PI", "- 2.0*PI", "2*PI", "2.*PI", "1e1*x", "PI*2.0", "2.0 PI", "-2.0PI",
    "2.0 -PI", "2.0 - PI", "2.0 -x", "2.0-x", "-2.0 - x", "2.0 - x/2.0", "2.0 PI/2.0", "2.0 -^x",
    "1.0 e3", "1.0e", "1.0f", "2.0e3x", "2.0 ^x", "^x", "-^PI", "^mass", "pitch", "PI_2",
    "2.0 pitch", "2.0*pitch", "pitch[1.0]", "mass", "id", "link", "children", "ref_frame", "via",
    "PIPE", "p|",
    "|i/2.0", "2.0*x", "-2.0*x", "x/2", "-x/2", "x*y", "x+1.0", "1.0+2.0", "1.0-2.0", "2.0*3.0",
    "2*3", "2*3.0", "1/3", "1.0/3", "(1.0)", "(PI)", "x[1.0]", "x[1]", "x [ -1e3 ]", "-x[1.0]/2",
    "2.0*x[.5]", "x[PI]", "x[]", "x[1.0][2.0]", "<k=1.0>", "<k=2.0>", "<k>", "-<k>/2", "2*<k>",
    "<k=PI>", "<k=1>", "<link=1.0>", "<pi=1.0>", "<pi>", "½", "größe", "α", "a٣", "٣.٥", "1٫5",
    "1.0m", "1.0 deg", "true", "inf", "nan", "sqrt(2.0)", "", "1.0;", "x'", "$x", "1.0\xa0", "−1.0",
)  # fmt: skip
NAMES = (
    "a", "b1", "_", "__", "link", "Robot", "RobotBase", "via", "mass", "CoM", "id", "floating",
    "children", "frames", "r_joint", "p_joint", "ref_frame", "translation", "rotation", "Ix", "Ixy",
    "inertia_params", "inertia_properties", "PI", "pi", "PIx", "pitch", "^link", "^a", "linkx",
    "xlink", "true", "class", "fr_l1", "e3", "E", "base", "l1", "l2", "j1", "j2", "R", "ü", "名",
    "ß", "a٣", "ａ", "a-b", "1a", "a b", "'a'", "", "^", "a^", "idx", "massage", "viaduct", "Ixx",
)  # fmt: skip
MOMENTS = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")
KEYWORDS = (
    "Robot", "RobotBase", "link", "r_joint", "p_joint", "floating", "id", "inertia_params", "mass",
    "CoM", *MOMENTS, "ref_frame", "children", "via", "frames", "translation", "rotation", "PI",
)  # fmt: skip


class Document(NamedTuple):
    """A document, and how it was made."""

    kind: str
    text: str


class Body(NamedTuple):
    """A link, or with the id 0 the base."""

    name: str
    id: str
    inertia: str
    children: list[tuple[str, str]]
    frames: list[str]


class Robot:
    """What a document is made of; each part may be spoilt before it is written."""

    def __init__(self, generator: random.Random) -> None:
        self.random = generator
        self.values: tuple[str, ...] = CLEAN
        self.odd = 0.0
        self.name = "R"
        self.floating = generator.random() < 0.4
        count = generator.randint(1, 4)
        self.names = ["base", *(f"l{i}" for i in range(1, count + 1))]
        self.ids = [str(i) for i in range(count + 1)]
        self.joints = [f"j{i}" for i in range(1, count + 1)]
        self.pairs = [
            [generator.randint(0, i - 1), self.names[i], self.joints[i - 1]]
            for i in range(1, count + 1)
        ]
        self.frames = {
            i: [f"f{i}_{n}" for n in range(generator.randint(1, 2))]
            for i in range(count + 1)
            if generator.random() < 0.4
        }
        self.inertia_frames = {
            i: names[0] for i, names in self.frames.items() if generator.random() < 0.4
        }
        self.without_inertia = {i for i in range(count + 1) if generator.random() < 0.04}

    def text(self) -> str:
        """Return the document."""
        bodies = "".join(self._body(i) for i in range(len(self.names)))
        joints = "".join(self._joint(i, name) for i, name in enumerate(self.joints, 1))
        return f"Robot {self.name} {{\n{bodies}{joints}}}\n"

    def value(self) -> str:
        return self.random.choice(VALUES if self.random.random() < self.odd else self.values)

    def _vector(self) -> str:
        blank = self.random.choice(("", " "))
        return f"({blank}{self.value()},{blank}{self.value()}, {self.value()})"

    def _pose(self) -> str:
        blank = self.random.choice("\n ")
        return f"translation = {self._vector()}{blank}rotation = {self._vector()}"

    def _body(self, index: int) -> str:
        name = self.names[index]
        floating = " floating" if self.floating else ""
        head = f"link {name} {{\n id = {self.ids[index]}\n"
        if index == 0:
            head = f"RobotBase {name}{floating} {{\n"
        inertia = "" if index in self.without_inertia else self._inertia(index)
        children = " ".join(f"{link} via {joint}" for at, link, joint in self.pairs if at == index)
        return f"{head}{inertia}children {{ {children} }}\n{self._frames(index)}}}\n"

    def _inertia(self, index: int) -> str:
        keyword = self.random.choice(("inertia_params", "inertia_properties"))
        blank = self.random.choice("\n ")
        moments = list(MOMENTS)
        if self.random.random() < 0.3:
            self.random.shuffle(moments)
        rows = [f"mass = {self.value()}", f"CoM = {self._vector()}"]
        rows += [f"{m}{self.random.choice(('=', ' = '))}{self.value()}" for m in moments]
        if index in self.inertia_frames:
            rows.append(f"ref_frame = {self.inertia_frames[index]}")
        return f"{keyword} {{{blank}{blank.join(rows)}{blank}}}\n"

    def _frames(self, index: int) -> str:
        names = self.frames.get(index)
        if not names:
            return ""
        join = self.random.choice((" ", "}{"))
        return "frames {" + join.join(f"{n} {{ {self._pose()} }}" for n in names) + "}\n"

    def _joint(self, number: int, name: str) -> str:
        keyword = self.random.choice(("r_joint", "p_joint"))
        id_ = self.random.choice((f"id = {number} ", "", ""))
        return f"{keyword} {name} {{ {id_}ref_frame {{ {self._pose()} }} }}\n"


def documents(seed: int) -> Iterator[Document]:
    """Yield documents without end, the same for the same seed."""
    generator = random.Random(seed)
    while True:
        kind = generator.choice(tuple(_KINDS))
        yield Document(kind, _KINDS[kind](generator))


def _rand(generator: random.Random) -> str:
    robot = Robot(generator)
    robot.odd = generator.choice((0.01, 0.02, 0.05))
    return robot.text()


def _clean(generator: random.Random) -> str:
    return Robot(generator).text()


def _one_value(generator: random.Random) -> str:
    """Return a document with one odd value, or one odd value twice."""
    robot = Robot(generator)
    places = robot.text().count("1.0")
    text = robot.text()
    value = generator.choice(VALUES)
    for _ in range(generator.randint(1, 2)):
        place = generator.randrange(max(places, 1))
        parts = text.split("1.0")
        if len(parts) > place + 1:
            text = "1.0".join(parts[: place + 1]) + value + "1.0".join(parts[place + 1 :])
    return text


def _names(generator: random.Random) -> str:
    robot = Robot(generator)
    for _ in range(generator.randint(1, 3)):
        old = generator.choice([robot.name, *robot.names, *robot.joints, *_flat(robot.frames)])
        _rename(robot, old, generator.choice(NAMES))
    return robot.text()


def _ids(generator: random.Random) -> str:
    robot = Robot(generator)
    for _ in range(generator.randint(1, 2)):
        at = generator.randrange(1, len(robot.ids))
        robot.ids[at] = generator.choice(
            ("0", "-1", "+2", "02", "2.0", "1e1", "x", "", "1_0", "٢", "99999999999", "2147483647",
             "1 0", *map(str, range(1, 6)))
        )  # fmt: skip
    return robot.text()


def _tree(generator: random.Random) -> str:
    robot = Robot(generator)
    for _ in range(generator.randint(1, 2)):
        _spoil_tree(robot, generator)
    return robot.text()


def _spoil_tree(robot: Robot, generator: random.Random) -> None:
    pairs, names, joints = robot.pairs, robot.names, robot.joints
    pair = generator.choice(pairs) if pairs else [0, names[-1], joints[-1]]
    slip = generator.randrange(16)
    if slip == 0 and pairs:
        pairs.remove(pair)
    elif slip == 1:
        pairs.append([generator.randrange(len(names)), pair[1], generator.choice(joints)])
    elif slip == 2:
        pairs.append(list(pair))
    elif slip == 3:
        pair[1] = generator.choice([*names, "nobody"])
    elif slip == 4:
        pair[2] = generator.choice([*joints, "nothing"])
    elif slip == 5:
        pair[0] = generator.randrange(len(names))
    elif slip == 6:
        joints.append(f"j{len(joints) + 1}")
    elif slip == 7 and len(joints) > 1:
        joints.remove(generator.choice(joints))
    elif slip == 8:
        robot.ids.reverse()
        robot.ids[0] = "0"
    elif slip == 9:
        one, other = generator.sample(range(len(robot.ids)), 2)
        robot.ids[one], robot.ids[other] = robot.ids[other], robot.ids[one]
    elif slip == 10:
        at = generator.choice([pair[1], *joints])
        _rename(robot, at, generator.choice([*names, *joints]))
    elif slip == 11:
        names.append(generator.choice([f"l{len(names)}", *names]))
        robot.ids.append(str(len(names) - 1))
    elif slip == 12:
        robot.inertia_frames[generator.randrange(len(names))] = generator.choice(
            [*names, *joints, *_flat(robot.frames), "f"]
        )
    elif slip == 13:
        robot.frames[generator.randrange(len(names))] = ["f", generator.choice(("f", "g"))]
    elif slip == 14:
        robot.frames[generator.randrange(len(names))] = [generator.choice([*names, *joints, "f"])]
    else:
        robot.without_inertia.add(generator.randrange(len(names)))


def _same(generator: random.Random) -> str:
    """Return a document in which two things share a name."""
    robot = Robot(generator)
    things = [robot.name, *robot.names, *robot.joints, *_flat(robot.frames), "x"]
    one, other = generator.sample(things, 2)
    _rename(robot, one, other)
    return robot.text()


def _flat(frames: dict[int, list[str]]) -> list[str]:
    return [name for names in frames.values() for name in names]


def _rename(robot: Robot, old: str, new: str) -> None:
    robot.name = new if robot.name == old else robot.name
    robot.names = [new if name == old else name for name in robot.names]
    robot.joints = [new if name == old else name for name in robot.joints]
    for pair in robot.pairs:
        pair[1:] = [new if name == old else name for name in pair[1:]]
    robot.frames = {i: [new if n == old else n for n in ns] for i, ns in robot.frames.items()}
    robot.inertia_frames = {i: new if n == old else n for i, n in robot.inertia_frames.items()}


def _mutated(generator: random.Random) -> str:
    from tests.differential.mutations import mutated

    base = generator.choice((_clean, _clean, _rand, _names))(generator)
    for _ in range(generator.choice((1, 1, 1, 2))):
        base = mutated(base, generator)
    return base


_KINDS = {
    "rand": _rand,
    "clean": _clean,
    "value": _one_value,
    "names": _names,
    "ids": _ids,
    "tree": _tree,
    "same": _same,
    "mutated": _mutated,
    "mutated again": _mutated,
}
