int syntax_error(int x) { return x + ; }
