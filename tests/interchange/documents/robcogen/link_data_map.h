out << "   hull = " << map[HULL] << "   arm = " << map[ARM]
    << "   rod = " << map[ROD];
