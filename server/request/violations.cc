#include "server/request/violations.h"

#include <utility>

namespace dualarm {

void Violations::add(FieldViolation violation) {
  if (kept_.size() < kMostKept) kept_.push_back(std::move(violation));
  ++count_;
}

}  // namespace dualarm
