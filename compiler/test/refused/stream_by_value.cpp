#include "hls_stream.h"
int stream_by_value(hls::stream<int> in) { return in.read(); }
// error: 2:38: stream 'in' is passed by value, but cannot be copied; pass it by reference
