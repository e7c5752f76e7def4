"""Documents in which KD310 finds nothing, and in which it finds something."""

from tests.support.examples import link, placed_joint, robot

_INERTIA = """inertia_params {
        mass = 1.0
        CoM = (0.0, 0.0, 0.0)
        Ix=%s Iy=%s Iz=%s Ixy=0.0 Ixz=0.0 Iyz=0.0
    }"""

_SAME = _INERTIA % ("0.01", "0.01", "0.01")


def _arm(third: str) -> str:
    links = (
        link("upper", 1, "lower via elbow", _SAME),
        link("lower", 2, "hand via wrist", _SAME),
        link("hand", 3, inertia=third),
    )
    return robot(*links, base="upper via shoulder", joints="shoulder elbow wrist")


_OF_AN_ARM = """inertia_params { mass = 1.214 CoM = (0.0, 0.1313, 0.0)
        Ix=0.03217 Iy=0.00062 Iz=0.03196 Ixy=0.0 Ixz=0.0 Iyz=0.0 }"""
_OF_A_CHAIN = _INERTIA.replace("0.0, 0.0, 0.0", "0.0, 0.0, 0.054") % (
    "0.005217",
    "0.00629",
    "0.0013",
)


def _chain(first: str, second: str) -> str:
    """Return two links of one design, the one on the other, and a hand of another one."""
    links = (
        link(first, 1, f"{second} via elbow", _OF_A_CHAIN),
        link(second, 2, "hand via wrist", _OF_A_CHAIN),
        link("hand", 3),
    )
    return robot(*links, base=f"{first} via shoulder", joints="shoulder elbow wrist")


def _branches(*names: str) -> str:
    links = [link(name, i, inertia=_SAME) for i, name in enumerate(names, 1)]
    carried = " ".join(f"{name} via {name}_joint" for name in names)
    return robot(*links, base=carried, joints=" ".join(f"{name}_joint" for name in names))


def _arms(one: str, other: str) -> str:
    """Return two arms of one design, on either side, which is told by no word that is known."""
    links = [
        link(name, i, f"hand{i} via wrist{i}", _OF_AN_ARM) for i, name in ((1, one), (2, other))
    ]
    hands = link("hand1", 3), link("hand2", 4)
    wrists = placed_joint("wrist1", "0.0, 0.3, 0.0", "0.0, 0.0, 0.0") + placed_joint(
        "wrist2", "0.0, -0.3, 0.0", "0.0, 0.0, 0.0"
    )
    carried = f"{one} via shoulder1 {other} via shoulder2"
    text = robot(*links, *hands, base=carried, joints="shoulder1 shoulder2")
    return text[: text.rindex("}")] + wrists + "}\n"


GOOD = (
    _arms("hidari_arm", "migi_arm"),
    _arm(_INERTIA % ("0.02", "0.02", "0.02")),
    _chain("seg_a1", "seg_b1"),
    _branches("index_knuckle", "middle_knuckle", "ring_knuckle"),
    _branches("wheel_x_link", "wheel_y_link", "wheel_z_link"),
)
BAD = (
    _arm(_SAME),
    _branches("camera_link", "lidar_link", "imu_link"),
    _chain("upper", "lower"),
    _arms("boom", "tail"),
    link("upper", 1, inertia=_INERTIA % ("1.0", "1.0", "1.0")),
)
