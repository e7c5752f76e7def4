HomogeneousTransforms::Type_fr_hull_X_fr_arm::Type_fr_hull_X_fr_arm()
{
    (*this)(0,3) = tx_turn;
    (*this)(2,0) = 0;
    (*this)(2,2) = 1;
}
const HomogeneousTransforms::Type_fr_hull_X_fr_arm& HomogeneousTransforms::Type_fr_hull_X_fr_arm::update(const JState& q) {
    s_q_turn = ScalarTraits::sin( q(TURN));
    c_q_turn = ScalarTraits::cos( q(TURN));
    (*this)(0,0) = c_q_turn;
    (*this)(0,1) = - s_q_turn;
    (*this)(1,0) = s_q_turn;
    (*this)(1,1) = c_q_turn;
    return *this;
}
const HomogeneousTransforms::Type_fr_rod_X_fr_arm& HomogeneousTransforms::Type_fr_rod_X_fr_arm::update(const JState& q) {
    (*this)(0,0) = 0;
    (*this)(0,1) = 1;
    (*this)(0,3) = -( 0.5 / 2.0);
    (*this)(1,0) = - 1;
    (*this)(1,1) = 0;
    (*this)(1,3) = 3.0 * 0.25 + 0.25 - 0.5;
    (*this)(2,3) = - q(PUSH) - 0.125;
    return *this;
}
const HomogeneousTransforms::Type_fr_rod_X_fr_hull& HomogeneousTransforms::Type_fr_rod_X_fr_hull::update(const JState& q) {
    s_q_turn = ScalarTraits::sin( q(TURN));
    c_q_turn = ScalarTraits::cos( q(TURN));
    (*this)(0,0) = - s_q_turn;
    (*this)(1,1) = - c_q_turn;
    (*this)(2,3) = - q(PUSH) - 0.125;
    return *this;
}
const HomogeneousTransforms::Type_fr_hull_X_fr_tool& HomogeneousTransforms::Type_fr_hull_X_fr_tool::update(const JState& q) {
    (*this)(0,3) = unknown_parameter;
    return *this;
}
