// A state machine as switch over a static enum.
// top: state_fsm
// calls: 40
unsigned char state_fsm(unsigned char symbol) {
  enum State { IDLE, ONE, TWO, FOUND };
  static State state = IDLE;
  bool bit = symbol & 1;
  switch (state) {
    case IDLE: state = bit ? ONE : IDLE; break;
    case ONE: state = bit ? ONE : TWO; break;
    case TWO: state = bit ? FOUND : IDLE; break;
    case FOUND: state = bit ? ONE : TWO; break;
  }
  return state == FOUND;
}
