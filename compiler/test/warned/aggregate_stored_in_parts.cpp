// AGGREGATE on an array of structs that is stored member by member.
// top: aggregate_stored_in_parts
struct Pair {
  short first;
  short second;
};
int aggregate_stored_in_parts(const short in[16], int at) {
  Pair pairs[16];
#pragma HLS AGGREGATE variable=pairs
  for (int i = 0; i < 16; ++i) pairs[i].first = in[i];
  for (int i = 0; i < 16; ++i) pairs[i].second = -in[15 - i];
  return pairs[at & 15].first * pairs[(at + 1) & 15].second;
}
// warning: 10:47: AGGREGATE of 'pairs' has no effect: this stores a part of an element in a loop; store the whole struct, or load it in the same iteration before
