
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
