#include <typeinfo>
struct Base {
  virtual ~Base() {}
};
int typeid_use(Base& b) { return typeid(b) == typeid(Base); }
// error: 5:34: use of typeid requires -frtti
