/// The one error that people see: a sentence that says what is wrong and what to do.
#ifndef FLOORLINE_HOST_ERROR_H
#define FLOORLINE_HOST_ERROR_H

#include <stdexcept>

namespace floorline {

class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace floorline

#endif
