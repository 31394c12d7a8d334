int syntax_error(int x) { return x + ; }
// error: 1:38: expected expression
