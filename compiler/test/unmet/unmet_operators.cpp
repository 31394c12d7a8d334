// There is a multiplier.
// top: unmet_operators
// expect: operators multiply=0
int unmet_operators(short a, short b) { return a * b; }
