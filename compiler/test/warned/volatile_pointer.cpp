// What a volatile pointer leads to is read once.
// top: volatile_pointer
int volatile_pointer(volatile int* port) {
  int a = *port;
  int b = *port;
  return a - b;
}
// warning: 4:11: 'volatile' has no effect: what is accessed here does not change during a run; use an hls::stream for values that do
// warning: 5:11: 'volatile' has no effect: what is accessed here does not change during a run; use an hls::stream for values that do
