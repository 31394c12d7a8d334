// Labels of the source with the names of the compiler's own states.
// top: language_label_done
int language_label_done(int value, int limit) {
  int rounds = 0;
idle:
  if (value < 0) goto done;
  value -= (limit & 255) + 1;
  ++rounds;
  if (rounds < 20) goto idle;
done:
  return value * 32 + rounds;
}
