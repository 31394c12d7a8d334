static int risky(int x) {
  if (x == 3) throw 2;
  return x;
}
int exception_try(int x) {
  try {
    return risky(x);
  } catch (int e) {
    return e;
  }
}
// error: 2:15: cannot use 'throw' with exceptions disabled
