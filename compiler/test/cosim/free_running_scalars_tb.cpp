#include "ap_int.h"

bool free_running_scalars(ap_uint<16> requests, ap_uint<5>* first, ap_uint<16>* grant);

int main() {
  for (unsigned call = 0; call < 40; ++call) {
    const unsigned requests = call % 7 == 3 ? 0 : (call * 40503u << (call % 5)) & 0xffff;
    ap_uint<5> first = 0;
    ap_uint<16> grant = 0;
    const bool odd = free_running_scalars(requests, &first, &grant);
    if (first != (requests ? __builtin_ctz(requests) : 16)) return 1;
    if (grant != (requests & -requests) || odd != __builtin_parity(requests)) return 1;
  }
  return 0;
}
