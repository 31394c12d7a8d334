int undeclared_name(int x) { return x + missing; }
