int elsewhere(int x);
int external_function(int x) { return elsewhere(x) + 1; }
// error: 2:39: the call of 'elsewhere(int)' cannot be inlined; give the function's source among the files
