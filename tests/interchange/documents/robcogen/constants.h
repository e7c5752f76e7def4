const double tx_turn = 0.25;
constexpr double ROD_X = 4E-2;
const int count;
