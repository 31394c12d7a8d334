int elsewhere(int x);
int external_function(int x) { return elsewhere(x) + 1; }
