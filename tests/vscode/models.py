"""Robots for the tests in the editor."""

ARM = """Robot arm {
    RobotBase pedestal {
        children { upper via shoulder }
    }
    link upper {
        id = 1
        inertia_params {
            mass = 2.0
            CoM = (0.2, 0.0, 0.0)
            Ix = 0.01 Iy = 0.11 Iz = 0.11 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0
        }
        children { lower via elbow }
    }
    link lower {
        id = 2
        inertia_params {
            mass = 1.2
            CoM = (0.15, 0.0, 0.0)
            Ix = 0.006 Iy = 0.05 Iz = 0.05 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0
        }
        children { }
        frames { tip { translation = (0.3, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
    }
    r_joint shoulder {
        ref_frame {
            translation = (0.0, 0.0, 0.3)
            rotation = (PI/2.0, 0.0, 0.0)
        }
    }
    r_joint elbow {
        ref_frame {
            translation = (0.4, 0.0, 0.0)
            rotation = (0.0, 0.0, 0.0)
        }
    }
}
"""

OTHER = """Robot other {
    RobotBase stand {
        children { pole via slide }
    }
    link pole {
        id = 1
        inertia_params {
            mass = 2.0
            CoM = (0.2, 0.0, 0.0)
            Ix = 0.01 Iy = 0.11 Iz = 0.11 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0
        }
        children { }
    }
    p_joint slide {
        ref_frame {
            translation = (0.0, 0.0, 0.3)
            rotation = (0.0, 0.0, 0.0)
        }
    }
}
"""
"""Another robot, of one degree of freedom."""

BROKEN = ARM.replace("lower via elbow", "lower via elbov").replace("mass = 2.0", "mass = 2")
"""The arm with an integer for a mass, and a joint's name misspelt."""
