#pragma once

#include <atomic>
#include <memory>

namespace dualarm {

/// How many may be served at once. Outlives what it gave.
class Places {
 public:
  explicit Places(int count) : free_(count) {}

  struct Return {
    void operator()(Places* places) const { ++places->free_; }
  };
  using Place = std::unique_ptr<Places, Return>;

  /// Empty if all are taken; given back with the object.
  Place take() {
    if (free_-- > 0) return Place(this);
    ++free_;
    return nullptr;
  }

 private:
  std::atomic<int> free_;
};

using Place = Places::Place;

}  // namespace dualarm
