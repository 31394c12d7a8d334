// A struct by const reference.
// top: interface_struct_const_reference
struct Settings {
  short gain;
  unsigned char shift;
  bool invert;
};
int interface_struct_const_reference(const Settings& settings, int value) {
  int scaled = (value * settings.gain) >> (settings.shift & 15);
  return settings.invert ? -scaled : scaled;
}
