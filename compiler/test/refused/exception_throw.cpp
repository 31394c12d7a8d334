int exception_throw(int x) {
  if (x < 0) throw 1;
  return x;
}
// error: 2:14: cannot use 'throw' with exceptions disabled
