extern "C" void bus_pointers(const int* from, int* to, int count);

int main() {
  int from[100], to[100];
  for (int i = 0; i < 100; ++i) from[i] = i * i;
  bus_pointers(from, to, 90);
  for (int i = 0; i < 90; ++i)
    if (to[i] != from[i] - (i < 4 ? 0 : from[i - 4])) return 1;
  return 0;
}
