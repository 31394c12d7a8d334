/// Whole pipeline against golden: do both models find the same contact points?
#ifndef FLOORLINE_APPS_AGREEMENT_H
#define FLOORLINE_APPS_AGREEMENT_H

#include <vector>

#include "golden/polar.h"

namespace floorline::app {

/// Pairs the contact points of both models line by line. A contact without a partner disagrees, whichever
/// model it is from.
class Agreement {
 public:
  void add(const std::vector<golden::Contact>& golden, const std::vector<golden::Contact>& kernel);

  /// Contacts, of both models together, whose partner lies within 1 px in u and v. 1 when there are none at
  /// all.
  double share_within_1px() const;
  long contacts() const { return contacts_; }

  /// Of every pair: the greater of the distances in u and v, pixels.
  const std::vector<double>& distances() const { return distances_; }

 private:
  long contacts_ = 0;
  std::vector<double> distances_;
};

}  // namespace floorline::app

#endif
