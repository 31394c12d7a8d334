// What one call hands to the next takes longer than the II.
// top: calls_interval_missed
int calls_interval_missed(int a) {
#pragma HLS PIPELINE II=1
  static int state = 1;
  state = state * state + a;
  return state;
}
// warning: 3: II = 1 is not reached, II is 3: 'sum' (calls_interval_missed.cpp:6:25) must be ready for 'state_2' (calls_interval_missed.cpp:3) of 1 call later; shorten the path between them
