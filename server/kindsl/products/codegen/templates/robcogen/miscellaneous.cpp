// @stamp.origin@
// @stamp.licence@
#include "miscellaneous.h"

@vector3@ @space@::getWholeBodyCOM(
    const dyn::InertiaProperties& inertia, const HomogeneousTransforms& transforms)
{
    typedef HomogeneousTransforms::MatrixType Pose;
    @vector3@ sum = @"inertia.getMass_" ~ base ~ "() * inertia.getCOM_" ~ base ~ "()" if robot.is_floating else vector3 ~ "::Zero()"@;
{% for i in links %}
{% set name = robot.bodies[i] %}
{% set parent = robot.tree.parents[i] %}
    const Pose pose@i@ = @"pose" ~ parent ~ " * " if parent else ""@transforms.@robot.back_across(i)@;
    sum += inertia.getMass_@name@()
        * (pose@i@.topLeftCorner<3, 3>() * inertia.getCOM_@name@()
            + pose@i@.topRightCorner<3, 1>());
{% endfor %}
    return sum / inertia.getTotalMass();
}

@vector3@ @space@::getWholeBodyCOM(
    const dyn::InertiaProperties& inertia, const JointState& q, HomogeneousTransforms& transforms)
{
{% for i in links %}
    transforms.@robot.back_across(i)@(q);
{% endfor %}
    return getWholeBodyCOM(inertia, transforms);
}
