// Two source files.
// top: language_two_files
// file: second/language_two_files_helper.cpp
int scale_by_table(int value, int index);
int language_two_files(int value, int index) { return scale_by_table(value, index & 7) + 1; }
