// One load at a subscript that is one of two constants, of an array of structs: LLVM chooses between two offsets in bytes.
// top: array_chosen_element
struct Sample {
  int value;
  unsigned char tag;
};
int array_chosen_element(const Sample samples[8], bool late) {
  return late ? samples[3].value : samples[7].value;
}
