InertiaProperties::InertiaProperties()
{
    com_hull = Vector3d(0.0, 0.0, - 0.125);
    tensor_hull.fill(12.5, com_hull,
        Utils::buildInertiaTensor(1.0, 2.0, 2.5, 0.0, 0.0, 0.0) );
    com_arm = Vector3d(tx_turn, 0.0, -tx_turn);
    tensor_arm.fill(1.5, com_arm,
        Utils::buildInertiaTensor(.5, 2.0E-1, +0.75, 0.01, -0.02, - 0.03) );
    com_rod = Vector3d(- ROD_X, 0.0, 0.0);
    tensor_rod.fill(0.5, com_rod,
        Utils::buildInertiaTensor(0.1, 0.2, 0.2, 0.0, 0.0, 0.0) );
}
