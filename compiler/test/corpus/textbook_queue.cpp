// A circular queue in a class with static storage: push or pop a call.
// top: textbook_queue
// calls: 40
class Queue {
 public:
  bool push(int value) {
    if (count_ == 8) return false;
    data_[(first_ + count_) & 7] = value;
    ++count_;
    return true;
  }
  int pop() {
    if (count_ == 0) return -1;
    int value = data_[first_];
    first_ = (first_ + 1) & 7;
    --count_;
    return value;
  }

 private:
  int data_[8];
  int first_ = 0, count_ = 0;
};
int textbook_queue(bool is_push, int value) {
  static Queue queue;
  return is_push ? queue.push(value) : queue.pop();
}
