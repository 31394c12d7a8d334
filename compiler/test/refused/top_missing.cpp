int not_the_top(int x) { return x; }
