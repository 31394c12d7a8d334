#include "hls_stream.h"
int stream_by_value(hls::stream<int> in) { return in.read(); }
