"""`declarations.h`: sizes, joint vectors, and the identifiers of joints and links."""

from kindsl.codegen.robcogen import rcg_names
from kindsl.codegen.robcogen.robot import GeneratedRobot

_TEXT = """
namespace iit {
namespace @NS@ {

static const int JointSpaceDimension = @NJ@;
static const int jointsCount = @NJ@;
/** How many bodies there are, with the base. */
static const int linksCount = @NB@;

namespace tpl {

template <typename SCALAR>
using Column@NJ@d = Eigen::Matrix<SCALAR, @NJ@, 1>;

template <typename SCALAR>
using JointState = Column@NJ@d<SCALAR>;

}

using Column@NJ@d = tpl::Column@NJ@d<double>;
typedef Column@NJ@d JointState;

enum JointIdentifiers {
    @JOINTS@
};

enum LinkIdentifiers {
    @LINKS@
};

static const JointIdentifiers orderedJointIDs[jointsCount] = {@JOINTS1@};

static const LinkIdentifiers orderedLinkIDs[linksCount] = {@LINKS1@};

/** A vector's numbers, which need not stand where Eigen wants them, as in a plain std::vector. */
template <typename V>
inline auto raw(V& v) -> decltype(v.data())
{
    auto first = v.data();
#if defined(__clang__)
    __asm__("" : "+r"(first)); // clang concludes from the reference that they are aligned
#endif
    return first;
}

namespace kernels {

/** Never true, but only known so when something is used. */
template <typename T>
struct Never {
    static const bool value = false;
};

}

}
}
"""


def declarations(robot: GeneratedRobot) -> dict[str, str]:
    """Return the header by its name."""
    body = robot.filled(
        _TEXT,
        JOINTS=",\n    ".join(_numbered(robot.joint_ids)),
        LINKS=",\n    ".join(_numbered(robot.body_ids)),
        JOINTS1=", ".join(robot.joint_ids),
        LINKS1=", ".join(robot.body_ids),
    )
    has_names = robot.library.options.layout == rcg_names.LAYOUT
    includes = ["<Eigen/Dense>", "<iit/rbd/rbd.h>", *['"rbd_types.h"'] * has_names]
    return {"declarations.h": robot.header("declarations.h", includes, body)}


def _numbered(names: list[str]) -> list[str]:
    return [f"{name} = {number}" for number, name in enumerate(names)]
