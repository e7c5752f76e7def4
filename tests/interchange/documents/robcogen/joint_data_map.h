out << "   Turn = " << map[TURN] << "   push = " << map[PUSH];
