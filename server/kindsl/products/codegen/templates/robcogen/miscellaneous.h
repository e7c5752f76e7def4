#include "inertia_properties.h"
#include "transforms.h"

@opening@

/** The centre of mass of all links in base coordinates, by transforms as they are. */
@vector3@ getWholeBodyCOM(
    const dyn::InertiaProperties& inertia, const HomogeneousTransforms& transforms);

/** The same after updating transforms. */
@vector3@ getWholeBodyCOM(
    const dyn::InertiaProperties& inertia, const JointState& q, HomogeneousTransforms& transforms);

@closing@
