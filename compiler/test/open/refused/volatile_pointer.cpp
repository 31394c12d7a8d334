int volatile_pointer(volatile int* port) {
  int a = *port;
  int b = *port;
  return a - b;
}
