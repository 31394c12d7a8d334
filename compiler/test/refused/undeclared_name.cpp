int undeclared_name(int x) { return x + missing; }
// error: 1:41: use of undeclared identifier 'missing'; did you mean 'using'?
