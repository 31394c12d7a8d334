// The result of a call, a struct, stays until the call is done, whatever those behind it compute.
// top: calls_struct_result
// calls: 60
struct Pair {
  int sum;
  short low;
  unsigned char flag;
  long more, next;
};
Pair calls_struct_result(int a, int b, Pair p) {  // expect: loop II=1
#pragma HLS PIPELINE
  Pair made;
  made.sum = a * b + p.sum;
  made.low = a;
  made.flag = b < 0;
  made.more = p.more * a;
  made.next = made.more + p.next;
  if (a < 0) made.low = p.low;
  return made;
}
