#include <Eigen/Dense>
#include <iit/rbd/rbd.h>
{% if robot.has_names_of_0_5 %}
#include "rbd_types.h"
{% endif %}

@opening@

static const int JointSpaceDimension = @robot.n_joints@;
static const int jointsCount = @robot.n_joints@;
/** How many bodies there are, with the base. */
static const int linksCount = @robot.bodies|length@;

namespace tpl {

template <typename SCALAR>
using Column@robot.n_joints@d = Eigen::Matrix<SCALAR, @robot.n_joints@, 1>;

template <typename SCALAR>
using JointState = Column@robot.n_joints@d<SCALAR>;

}

using Column@robot.n_joints@d = tpl::Column@robot.n_joints@d<@real@>;
typedef Column@robot.n_joints@d JointState;

enum JointIdentifiers {
{% for id in robot.joint_ids %}
    @id@ = @loop.index0@@'' if loop.last else ','@
{% endfor %}
};

enum LinkIdentifiers {
{% for id in robot.body_ids %}
    @id@ = @loop.index0@@'' if loop.last else ','@
{% endfor %}
};

static const JointIdentifiers orderedJointIDs[jointsCount] = {@robot.joint_ids|join(', ')@};

static const LinkIdentifiers orderedLinkIDs[linksCount] = {@robot.body_ids|join(', ')@};

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

@closing@
