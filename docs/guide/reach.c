#include <reacher.h>
#include <stdio.h>

int main(void)
{
    reacher_parameters parameters = reacher_default_parameters();
    reacher_model model;
    double q[REACHER_NJ] = {0.0, 0.5}, g[3] = {0.0, 0.0, -9.81}, tau[REACHER_NV];
    parameters.payload = 2.0;
    reacher_model_init(&model, &parameters);
    reacher_gravity_torque(&model, q, g, tau);
    printf("%s holds %.3f N m\n", reacher_joint_name(REACHER_JOINT_shoulder), tau[0]);
    return 0;
}
