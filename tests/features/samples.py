"""Small documents that the tests of the features share."""

from tests.support import robots

ARM = robots.ARM

PARAMETRIC = """\
Robot Gripper {
RobotBase palm floating {
    inertia_params {
        mass = m[1.5]
        CoM = (0.0, 0.0, <offset=0.05>)
        Ix=0.02 Iy=0.02 Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0
        ref_frame = grip
    }
    children { finger via slide }
    frames { grip { translation = (0.0, 0.0, width) rotation = (0.0, -tilt, 0.0) } }
}
link finger {
    id = 1
    inertia_params {
        mass = 0.1
        CoM = (0.0, 0.0, 2.0*<offset>)
        Ix=0.01 Iy=0.01 Iz=0.001 Ixy=0.0 Ixz=0.0 Iyz=0.0
    }
    children {}
}
p_joint slide { ref_frame { translation = (width/2.0, 0.0, 0.0) rotation = (0.0, 0.0, tilt) } }
}
"""

BROKEN = """\
Robot Half {
RobotBase base { children { a via ja b via jb } }
link a { id = 1 inertia_params { mass = 1.0 CoM = (0.0, 0.0 Ix=0.1
link b { id = 2 children { a via jb c } frames { f {
r_joint ja { ref_frame { translation = (x, ) rotation = (PI/, 0.0 } }
r_joint { ref_frame { } }
"""

COMMENTED = """\
Robot C { // see https://example.org/robot
/* a block
   comment */
RobotBase base { /* one */ children { /* none */ } }
// the first line
// the second line
link l { id = 1 children {} }
}
"""

ALL = (ARM, PARAMETRIC, BROKEN, COMMENTED)

TANGLED = """\
Robot Tangled {
RobotBase ^base {
    inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0) Ix=1.0 Iy=1.0 Iz=1.0 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children { a via j  b via k  nobody via nothing }
    frames { tip { translation = (1e999, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
link a { id = 1 children { b via j } frames { tip { translation = (x, x/0.0, <c>) } eye { } } }
link b {
    id = 2
    inertia_params {
        ref_frame = gone
        mass = 2.0*<d=0.5> CoM = (-x, PI/-y, +0.1) Ix=0.1 Iy=-0.1 Iz=(0.2) Ixy=0.01 Ixz=pi Iyz=0.0
    }
    children { c via m }
}
link c { id = 2 inertia_properties { mass = -1.0 } children { d via k } }
link d { children { c via n } }
link a { id = 7 }
r_joint j { id = 4 ref_frame { translation = (0.1, -0.2, 0.3) rotation = (-PI/2.0, y, 3.0*y) } }
p_joint k { ref_frame { translation = (0.0, x[0.5], 2 x) rotation = (0.0, 0.0, 0.0) } }
r_joint m { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 1.5708) } }
r_joint loose { ref_frame { translation = (0.0, 0.0, 0.0) } }
p_joint loose { }
}
"""
