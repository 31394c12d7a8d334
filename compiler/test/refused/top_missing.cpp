int not_the_top(int x) { return x; }
// error: no function 'top_missing' is defined in the sources; give its name with --top
