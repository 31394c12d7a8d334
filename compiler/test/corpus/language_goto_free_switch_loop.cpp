// A switch with fall-through inside a loop.
// top: language_goto_free_switch_loop
int language_goto_free_switch_loop(unsigned word) {
  int score = 0;
  for (int i = 0; i < 16; ++i) {
    switch ((word >> (2 * i)) & 3) {
      case 0:
        score += 1;
      case 1:
        score ^= i;
        break;
      case 2:
        score -= i;
        continue;
      default:
        score <<= 1;
    }
    score += 3;
  }
  return score;
}
