// Results by reference.
// top: call_reference_out
static void split(int v, int& quotient, int& remainder) {
  quotient = v / 10;
  remainder = v % 10;
}
void call_reference_out(int a, int& tens, int& ones) { split(a, tens, ones); }
