int thread_local_state(int x) {
  thread_local int sum = 0;
  sum += x;
  return sum;
}
