#include "inertia_properties.h"
#include "transforms.h"

@opening@

/** The centre of mass of all links in base coordinates, by transforms as they are. */
iit::rbd::Vector3d getWholeBodyCOM(
    const dyn::InertiaProperties& inertia, const HomogeneousTransforms& transforms);

/** The same after updating transforms. */
iit::rbd::Vector3d getWholeBodyCOM(
    const dyn::InertiaProperties& inertia, const JointState& q, HomogeneousTransforms& transforms);

@closing@
