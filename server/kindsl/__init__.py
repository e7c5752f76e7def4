"""Language tools and mechanics for the Kinematics-DSL."""
