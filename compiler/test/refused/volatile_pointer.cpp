int volatile_pointer(volatile int* port) {
  int a = *port;
  int b = *port;
  return a - b;
}
// error: 2:11: 'volatile' asks for an access each time, which a port without handshake cannot give; use an hls::stream for values that change during a run
