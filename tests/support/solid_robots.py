"""Honest robots that exist nowhere: solids of known matter, joined in the ways of a dozen designs.

Links are boxes, rods, tubes and balls of metal and plastic with motors at their joints; sides are
mirrored, rows repeated, numbers rounded as people and CAD programs round them.
"""

from collections.abc import Callable, Iterator, Sequence
from itertools import product
from math import atan2, cos, pi, sin
from random import Random
from typing import NamedTuple

import numpy as np

Vector = Sequence[float]
Matrix = np.ndarray
ORIGIN = (0.0, 0.0, 0.0)
X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
# In kg/m³, those of hollow parts as they seem.
ALUMINIUM, STEEL, PLASTIC, CARBON, MOTOR, HOLLOW = 2700, 7850, 1150, 1550, 4200, 420
HALF = pi / 2


class Body(NamedTuple):
    """A mass, its centre and the tensor about that, along the link's axes."""

    mass: float
    com: Matrix
    tensor: Matrix

    def __add__(self, other: "Body") -> "Body":  # type: ignore[override]
        mass = self.mass + other.mass
        com = (self.mass * self.com + other.mass * other.com) / mass
        parts = ((each, each.com - com) for each in (self, other))
        tensor = sum(b.tensor + b.mass * (d @ d * np.eye(3) - np.outer(d, d)) for b, d in parts)
        return Body(mass, com, np.asarray(tensor))

    def at(self, place: Vector, turn: Matrix | None = None) -> "Body":
        turn = np.eye(3) if turn is None else turn
        return Body(self.mass, turn @ self.com + np.array(place), turn @ self.tensor @ turn.T)

    def mirrored(self, axis: int = 1) -> "Body":
        mirror = np.diag([-1.0 if i == axis else 1.0 for i in range(3)])
        return Body(self.mass, mirror @ self.com, mirror @ self.tensor @ mirror)


def box(x: float, y: float, z: float, density: float, place: Vector = ORIGIN) -> Body:
    mass = density * x * y * z
    tensor = mass / 12 * np.diag([y * y + z * z, x * x + z * z, x * x + y * y])
    return Body(mass, np.zeros(3), tensor).at(place)


def tube(
    radius: float, height: float, density: float, place: Vector = ORIGIN, hole: float = 0.0
) -> Body:
    mass, squares = density * pi * (radius**2 - hole**2) * height, radius**2 + hole**2
    across = mass / 12 * (3 * squares + height**2)
    return Body(mass, np.zeros(3), np.diag([across, across, mass / 2 * squares])).at(place)


def ball(radius: float, density: float, place: Vector = ORIGIN) -> Body:
    mass = density * 4 / 3 * pi * radius**3
    return Body(mass, np.zeros(3), 0.4 * mass * radius**2 * np.eye(3)).at(place)


def turned_to(way: Vector) -> Matrix:
    """Return a rotation of z to a direction."""
    z = np.array(way, float)
    x = np.cross([1.0, 0.0, 0.0] if abs(z[0]) < 0.9 else [0.0, 1.0, 0.0], z)
    return np.stack([x / np.linalg.norm(x), np.cross(z, x / np.linalg.norm(x)), z], 1)


def member(chance: Random, length: float, width: float, way: Vector) -> Body:
    """Return a link that reaches from its joint along a way, perhaps with motors and a cover."""
    turn, end = turned_to(way), length * np.array(way)
    density = chance.choice([ALUMINIUM, PLASTIC, CARBON, HOLLOW, 900])
    body = chance.choice([
        box(width, width * chance.uniform(0.5, 1), length, density),
        tube(width / 2, length, density),
        tube(width / 2, length, 3 * density, hole=0.4 * width),
    ]).at(end / 2, turn)  # fmt: skip
    if chance.random() < 0.6:
        body += tube(width * chance.uniform(0.4, 0.7), width * chance.uniform(0.4, 1), MOTOR)
    if chance.random() < 0.4:
        body += tube(0.45 * width, 0.6 * width, 0.7 * MOTOR, end)
    if chance.random() < 0.3:
        cover = box(0.3 * width, 0.8 * width, 0.4 * length, PLASTIC, (0.6 * width, 0.0, 0.0))
        body += cover.at(end * chance.uniform(0.2, 0.8), turn)
    return body


class Robot:
    """A robot that grows; joints turn about z unless they say otherwise."""

    def __init__(self, chance: Random, base: str, body: Body) -> None:
        self.chance = chance
        self.links = {base: body}
        self.joints: list[tuple[str, str, Vector, Vector, str, Vector]] = []

    def add(
        self, parent: str, name: str, body: Body, place: Vector, axis: Vector = Z,
        turn: Vector = ORIGIN, kind: str = "revolute",
    ) -> str:  # fmt: skip
        self.links[name] = body
        self.joints.append((parent, name, place, turn, kind, axis))
        return name

    def chain(
        self, parent: str, names: Sequence[str], bodies: Sequence[Body], places: Sequence[Vector],
        axes: Sequence[Vector], turn: Vector = ORIGIN,
    ) -> str:  # fmt: skip
        for name, body, place, axis in zip(names, bodies, places, axes, strict=True):
            parent = self.add(parent, name, body, place, axis, turn)
            turn = ORIGIN
        return parent

    def urdf(self, *, is_exact: bool = False) -> str:
        """Return the robot's text, numbers rounded in one manner."""
        rounded = self.chance.choice(["%.3g", "%.4g", "%.5g", "%.17g"])
        of_tensor = self.chance.choice(["%.3g", "%.4g", "%.6g", "%.17g", "%.8f"])
        rounded, of_tensor = ("%.17g", "%.17g") if is_exact else (rounded, of_tensor)
        lines = ['<robot name="solid">']
        for name, (mass, com, tensor) in self.links.items():
            entries = zip(
                ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"), tensor[np.triu_indices(3)], strict=True
            )
            given = " ".join(f'{key}="{of_tensor % (value + 0.0)}"' for key, value in entries)
            place = " ".join(rounded % (c + 0.0) for c in com)
            lines.append(
                f'<link name="{name}"><inertial><origin xyz="{place}"/><mass value="{mass:.4g}"/>'
                f"<inertia {given}/></inertial></link>"
            )
        for parent, name, place, turn, kind, axis in self.joints:
            xyz, rpy, way = (" ".join(f"{c:.9g}" for c in each) for each in (place, turn, axis))
            lines.append(
                f'<joint name="{name}_joint" type="{kind}"><parent link="{parent}"/>'
                f'<child link="{name}"/><origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{way}"/>'
                '<limit lower="-0.5" upper="0.5" effort="50" velocity="5"/></joint>'
            )
        return "\n".join([*lines, "</robot>\n"])


def arm(chance: Random) -> Robot:
    size = chance.choice([0.15, 0.3, 1.0])
    robot = Robot(chance, "base", tube(0.3 * size, 0.3 * size, ALUMINIUM, (0, 0, 0.15 * size)))
    parent, place, turn = "base", (0.0, 0.0, 0.3 * size), ORIGIN
    for number in range(1, chance.randint(4, 7)):
        way, length = chance.choice([X, Y, Z]), size * chance.uniform(0.3, 1)
        body = member(chance, length, size * (0.25 - 0.02 * number), way)
        parent = robot.add(parent, f"link{number}", body, place, turn=turn)
        place, turn = [length * c for c in way], (chance.choice([0.0, HALF, -HALF]), 0.0, 0.0)
    palm = box(0.15 * size, 0.3 * size, 0.1 * size, ALUMINIUM, (0, 0, 0.05 * size))
    robot.add(parent, "gripper", palm, place)
    finger = box(0.05 * size, 0.04 * size, 0.2 * size, PLASTIC, (0, 0.02 * size, 0.1 * size))
    for side, sign in (("left", 1), ("right", -1)):
        body = finger if sign > 0 else finger.mirrored()
        place = (0, sign * 0.05 * size, 0.1 * size)
        robot.add("gripper", f"finger_{side}", body, place, (0, sign, 0), kind="prismatic")
    return robot


def quadruped(chance: Random) -> Robot:
    size = chance.choice([0.2, 0.4, 0.6])
    trunk = box(1.8 * size, 0.5 * size, 0.4 * size, HOLLOW)
    robot = Robot(
        chance, "trunk", trunk + box(0.4 * size, 0.3 * size, 0.2 * size, 2200, (0.02, 0.01, 0))
    )
    hip = member(chance, 0.25 * size, 0.18 * size, Y)
    thigh, shank = (member(chance, 0.8 * size, w * size, (0, 0, -1)) for w in (0.16, 0.09))
    for (row, x), (side, y) in product((("F", 0.9), ("H", -0.9)), (("L", 1), ("R", -1))):
        own = [each if y > 0 else each.mirrored() for each in (hip, thigh, shank)]
        own[0] = own[0] if x > 0 else own[0].mirrored(0)
        places = [(x * size, 0.3 * y * size, 0), (0, 0.25 * y * size, 0), (0, 0, -0.8 * size)]
        names = [f"{side}{row}_{part}" for part in ("hip", "upper", "lower")]
        robot.chain("trunk", names, own, places, (X, Y, Y))
    return robot


def star(chance: Random) -> Robot:
    size, n_legs = chance.choice([0.08, 0.15, 0.3]), chance.choice([3, 5, 6, 8])
    robot = Robot(chance, "body", tube(size, 0.4 * size, HOLLOW))
    lengths = (0.4 * size, size, 1.2 * size)
    bodies = [
        member(chance, each, w * size, X)
        for each, w in zip(lengths, (0.25, 0.22, 0.15), strict=True)
    ]
    for number in range(n_legs):
        angle = 2 * pi * number / n_legs
        places = [(size * cos(angle), size * sin(angle), 0), (lengths[0], 0, 0), (lengths[1], 0, 0)]
        names = [f"{part}_{number + 1}" for part in ("coxa", "femur", "tibia")]
        robot.chain("body", names, bodies, places, (Z, Y, Y), (0, 0, atan2(sin(angle), cos(angle))))
    return robot


def humanoid(chance: Random) -> Robot:
    size = chance.choice([0.15, 0.3, 0.5])
    robot = Robot(chance, "pelvis", box(0.4 * size, 0.7 * size, 0.3 * size, 2 * HOLLOW))
    torso = box(0.4 * size, 0.8 * size, size, HOLLOW, (0, 0, size / 2))
    robot.add("pelvis", "torso", torso, (0, 0, 0.15 * size))
    robot.add("torso", "head", ball(0.3 * size, HOLLOW, (0.05 * size, 0, 0.3 * size)), (0, 0, size))
    down, wide = (0, 0, -1), 0.25 * size
    leg = [member(chance, each * size, wide, down) for each in (0.15, 0.9, 0.9)]
    leg.append(
        box(0.6 * size, 0.3 * size, 0.1 * size, PLASTIC, (0.1 * size, 0.01 * size, -0.1 * size))
    )
    limb = [member(chance, 0.15 * size, 0.8 * wide, Y)]
    limb += [member(chance, 0.7 * size, each * wide, down) for each in (0.8, 0.6)]
    for side, sign in (("left_", 1), ("right_", -1)):
        sides = [[b if sign > 0 else b.mirrored() for b in each] for each in (leg, limb)]
        places = [(0, 0.25 * sign * size, -0.15 * size)]
        places += [(0, 0, -each * size) for each in (0.1, 0.9, 0.9)]
        names = [side + part for part in ("hip", "thigh", "shank", "foot")]
        robot.chain("pelvis", names, sides[0], places, (X, Y, Y, Y))
        places = [
            (0, 0.4 * sign * size, 0.85 * size),
            (0, 0.15 * sign * size, 0),
            (0, 0, -0.7 * size),
        ]
        names = [side + part for part in ("shoulder", "upper_arm", "forearm")]
        robot.chain("torso", names, sides[1], places, (Y, X, Y))
    return robot


def hand(chance: Random) -> Robot:
    size = chance.choice([0.03, 0.05])
    robot = Robot(chance, "palm", box(2 * size, 0.6 * size, 2 * size, PLASTIC, (0, 0, size)))
    lengths = (size, 0.7 * size, 0.5 * size)
    bones = [
        member(chance, each, w * size, Z)
        for each, w in zip(lengths, (0.35, 0.32, 0.28), strict=True)
    ]
    fingers = ("index", "middle", "ring", "little")[: chance.randint(2, 4)]
    for number, finger in enumerate(fingers):
        names = [f"{finger}_{bone}" for bone in ("proximal", "medial", "distal")]
        places = [
            (0.5 * size * number - 0.8 * size, 0, 2 * size),
            *((0, 0, each) for each in lengths[:2]),
        ]
        robot.chain("palm", names, bones, places, (X, X, X))
    thumb = [member(chance, each * size, 0.4 * size, Z) for each in (0.9, 0.7)]
    places = [(size, 0, 0.5 * size), (0, 0, 0.9 * size)]
    robot.chain("palm", ["thumb_proximal", "thumb_distal"], thumb, places, (Y, Y), (0, 0.8, 0))
    return robot


def gantry(chance: Random) -> Robot:
    size = chance.choice([0.3, 1.0, 2.0, 6.0])
    robot = Robot(chance, "frame", box(size, size, 0.05 * size, 0.1 * STEEL))
    bridge = box(
        0.06 * size, size, 0.08 * size, 0.4 * ALUMINIUM, (0, chance.choice([0, size / 2]), 0)
    )
    carriage = box(0.1 * size, 0.1 * size, 0.12 * size, 0.6 * ALUMINIUM)
    ram = box(0.04 * size, 0.04 * size, size / 2, ALUMINIUM / 2, (0, 0, -0.1 * size))
    robot.add("frame", "bridge", bridge, (0, 0, size / 2), X, kind="prismatic")
    robot.add("bridge", "carriage", carriage, (0.05 * size, 0, 0), Y, kind="prismatic")
    robot.add("carriage", "ram", ram, (0, 0.02 * size, 0), (0, 0, -1), kind="prismatic")
    spindle = tube(0.03 * size, 0.1 * size, STEEL / 2, (0, 0, -0.05 * size))
    robot.add("ram", "spindle", spindle, (0, 0, -0.35 * size))
    return robot


def crane(chance: Random) -> Robot:
    size = chance.choice([1.0, 3.0, 8.0])
    robot = Robot(chance, "chassis", box(size, 0.6 * size, 0.3 * size, 1200))
    slew = box(size / 2, size / 2, 0.4 * size, 1000, (-0.1 * size, 0.05 * size, 0.2 * size))
    slew += box(0.2 * size, 0.4 * size, 0.3 * size, STEEL, (-0.4 * size, 0, 0.2 * size))
    robot.add("chassis", "slew", slew, (0, 0, 0.2 * size))
    lengths = (1.5 * size, 1.1 * size, 0.4 * size)
    parts = [
        box(each, 0.12 * size, 0.1 * size, STEEL / 4, (each / 2, 0, 0))
        + tube(0.03 * size, each / 2, STEEL).at((0.4 * each, 0.09 * size, 0), turned_to(X))
        for each in lengths
    ]
    places = [(0.2 * size, 0, 0.4 * size), *((each, 0, 0) for each in lengths[:2])]
    robot.chain("slew", ["boom", "stick", "bucket"], parts, places, (Z, Z, Z), (HALF, 0, 0))
    return robot


def rover(chance: Random) -> Robot:
    size, n_rows = chance.choice([0.2, 0.5, 1.0]), chance.choice([1, 2, 3])
    robot = Robot(chance, "chassis", box(size, 0.6 * size, 0.2 * size, 1.5 * HOLLOW))
    wheel = tube(0.15 * size, 0.08 * size, PLASTIC).at(ORIGIN, turned_to(Y))
    wheel += tube(0.07 * size, 0.1 * size, ALUMINIUM).at((0, -0.01 * size, 0), turned_to(Y))
    for row, (side, sign) in product(range(n_rows), (("left", 1), ("right", -1))):
        x = 0.4 * size - row * 0.8 * size / max(n_rows - 1, 1) if n_rows > 1 else 0.0
        body, place = wheel if sign > 0 else wheel.mirrored(), (x, 0.35 * sign * size, -0.1 * size)
        name = f"{side}_wheel_{row + 1}" if n_rows > 1 else f"{side}_wheel"
        robot.add("chassis", name, body, place, Y)
    mast = tube(0.04 * size, 0.7 * size, ALUMINIUM, (0, 0, 0.35 * size), hole=0.03 * size)
    robot.add("chassis", "mast", mast, (0.3 * size, 0, 0.1 * size))
    camera = box(0.1 * size, 0.3 * size, 0.08 * size, PLASTIC, (0.03 * size, 0, 0))
    robot.add("mast", "camera", camera, (0, 0, 0.7 * size), Y)
    return robot


def snake(chance: Random) -> Robot:
    size = chance.choice([0.05, 0.1])
    body = member(chance, size, 0.6 * size, X)
    robot = Robot(chance, "segment0", body)
    for number in range(1, chance.randint(5, 12)):
        turn = (HALF if number % 2 else -HALF, 0, 0)
        robot.add(f"segment{number - 1}", f"segment{number}", body, (size, 0, 0), turn=turn)
    return robot


def copter(chance: Random) -> Robot:
    size = chance.choice([0.15, 0.3])
    hull, ways = box(size / 2, 0.4 * size, 0.15 * size, 2 * HOLLOW), []
    for number in range(4):
        angle = pi / 4 + number * HALF
        ways.append((cos(angle), sin(angle), 0.0))
        beam = tube(0.04 * size, size, CARBON).at(
            [size / 2 * c for c in ways[-1]], turned_to(ways[-1])
        )
        hull += beam + tube(0.08 * size, 0.1 * size, MOTOR, [size * c for c in ways[-1]])
    robot = Robot(chance, "hull", hull)
    propeller = box(0.8 * size, 0.08 * size, 0.01 * size, PLASTIC) + tube(
        0.04 * size, 0.03 * size, ALUMINIUM
    )
    for number, (x, y, _) in enumerate(ways):
        robot.add("hull", f"propeller_{number}", propeller, (size * x, size * y, 0.1 * size))
    return robot


DESIGNS: tuple[Callable[[Random], Robot], ...] = (
    arm, quadruped, star, humanoid, hand, gantry, crane, rover, snake, copter,
)  # fmt: skip


def solid_robots(number: int, seed: int, *, are_exact: bool = False) -> Iterator[tuple[str, str]]:
    """Yield names and URDFs, each design in its turn."""
    for index in range(number):
        design = DESIGNS[index % len(DESIGNS)]
        robot = design(Random(f"{seed} {index}"))
        yield f"{design.__name__}_{index}", robot.urdf(is_exact=are_exact)
