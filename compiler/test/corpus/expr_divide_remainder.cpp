// / and % of signed integers truncate towards zero.
// top: expr_divide_remainder
// range: b=1..1000
// expect: operators divide=0 remainder=0
int expr_divide_remainder(int a, int b) { return (a / b) * 7 + a % b; }
