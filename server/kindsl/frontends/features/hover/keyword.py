"""The hover of a keyword: its meaning in this language, conventions first."""

_ROTATION = (
    "Three angles in radians: turn about x, then about the **new** y, then about the **new** z "
    "(intrinsic), after the translation. The matrix `Rx·Ry·Rz` takes coordinates of the new frame "
    "to those of the old one."
)
_TRANSLATION = "Where the frame's origin is: x, y, z in metres."
_INERTIA = (
    "The mass properties of this body: mass, centre of mass, then moments and products of inertia, "
    "all in the **link frame**: about its origin (not about the CoM) and along its axes, unless a "
    "`ref_frame` names another frame of the link. A fixed base's inertia does not matter."
)
_MOMENT = (
    "Moment of inertia about the {axis} axis of the link frame (or of `ref_frame`): "
    "`{name} = Σ m ({squares})`, kg·m². About the frame's origin, not about the CoM."
)
_PRODUCT = (
    "Product of inertia `{name} = Σ m {a} {b}`, kg·m², about the origin of the link frame (or of "
    "`ref_frame`). The entry of the inertia tensor is **minus** this number, so the sign is "
    "opposite to the one in a URDF or an MJCF model."
)
_JOINT = (
    "A {kind} joint: it {motion} the z axis of its frame. At zero, the link that it moves has its "
    "link frame exactly on the joint frame."
)
_PAGES = {
    "Robot": "A robot: one base, then all links, then all joints. Units are metres, radians, "
    "kilograms and kg·m².",
    "RobotBase": "The body that carries the tree, number 0. Its frame may lie anywhere in it.",
    "floating": "The base is free to move: six more degrees of freedom, and its inertia matters.",
    "link": "A moving body. Its frame has its z axis on the axis of its supporting joint, and "
    "coincides with the joint frame while the joint is at zero.",
    "id": "The link's number: 1 to n without gaps, a child's greater than its parent's. Generated "
    "code orders links and joint variables by it. On a joint it is optional and ignored.",
    "mass": "The body's mass in kilograms.",
    "CoM": "The centre of mass: x, y, z in metres, in the link frame (or in `ref_frame`).",
    "children": "The links that this body carries, each as `link via joint`.",
    "via": "The joint between this body (its predecessor) and the child (its successor).",
    "frames": "Further frames fixed to this body, each by translation and rotation from the link "
    "frame: for sensors, feet, tools.",
    "ref_frame": "In a joint: the joint frame, fixed to the predecessor and given in its link "
    "frame, z along the joint axis. In an inertia section: the frame of this link that CoM and "
    "moments are given in (robcogen2 ignores it in its numbers).",
    "translation": _TRANSLATION,
    "rotation": _ROTATION,
    "inertia_params": _INERTIA,
    "inertia_properties": f"{_INERTIA} Means the same as `inertia_params`.",
    "r_joint": _JOINT.format(kind="revolute", motion="turns about"),
    "p_joint": _JOINT.format(kind="prismatic", motion="slides along"),
    "PI": "The number pi. Both generators take `PI`, `-PI`, `PI/2.0` and `-PI/2.0`.",
    "Ix": _MOMENT.format(axis="x", name="Ix", squares="y² + z²"),
    "Iy": _MOMENT.format(axis="y", name="Iy", squares="x² + z²"),
    "Iz": _MOMENT.format(axis="z", name="Iz", squares="x² + y²"),
    "Ixy": _PRODUCT.format(name="Ixy", a="x", b="y"),
    "Ixz": _PRODUCT.format(name="Ixz", a="x", b="z"),
    "Iyz": _PRODUCT.format(name="Iyz", a="y", b="z"),
}
_LOWER_PI = (
    "`{word}` is the number pi for robcogen2 and a parameter of that name for robcogen. "
    "Write `PI` for the number."
)


def keyword_hover(word: str) -> str | None:
    """Return what a keyword means, or None if the word is none."""
    if word.lower() == "pi" and word != "PI":
        return _LOWER_PI.format(word=word)
    page = _PAGES.get(word)
    return f"**`{word}`**\n\n{page}" if page is not None else None
