#include <typeinfo>
struct Base {
  virtual ~Base() {}
};
int typeid_use(Base& b) { return typeid(b) == typeid(Base); }
