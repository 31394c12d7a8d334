int thread_local_state(int x) {
  thread_local int sum = 0;
  sum += x;
  return sum;
}
// error: 3:3: 'llvm.threadlocal.address.p0' has no hardware form; write it with integer operations
