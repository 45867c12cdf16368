#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/model/budget.h"
#include "core/passage/forbidden_plane.h"
#include "core/passage/gate.h"

namespace dualarm {

/// A connected part of the forbidden set around which motions have to find a way, proven by slices that cross each
/// other, each of them exact. Two rays from it to infinity, with the way inside it from one to the other, are a curve
/// that cuts the plane in two. Counting how often the curve crosses a reference path from the start to the goal tells
/// whether it parts them: it does where the count is odd. So each ray belongs to one of two sides (0 or 1): a pair of
/// rays parts start and goal if and only if their sides differ, whatever the shape of the set. Where the obstacle
/// touches the border of the joint rectangle, motions cannot pass on that ray at all. Theory, section 4.
class Obstacle {
 public:
  /// Around a forbidden slice. `start` and `goal` (rad) are the positions of both arms. Refers to the plane. When the
  /// budget runs out, less of the obstacle is known.
  Obstacle(const ForbiddenPlane& plane, std::array<double, kArmCount> start, std::array<double, kArmCount> goal,
           const Slice& seed, const Budget& budget = Budget());

  /// The side (0 or 1) of a ray that begins in an end of `slice`, if the slice is proven to belong to the obstacle.
  /// What was walked to prove it is remembered.
  std::optional<int> side_of(const Slice& slice, bool runs_up);

  /// Whether the obstacle closes a side: its border contacts.
  bool is_closed(int side) const { return closed_[side]; }

  /// Slices known to belong to it.
  std::vector<Slice> slices() const;

  /// The positions (rad) of an arm in them.
  Interval extent(int arm) const;

 private:
  struct Point {
    double first = 0.0;   ///< rad, of arm 1
    double second = 0.0;  ///< rad, of arm 2
  };

  /// A slice that belongs to the obstacle, with the parity of the way from the seed to its anchor, a point on it.
  struct Piece {
    Slice slice;
    double anchor = 0.0;  ///< rad, position of the arm that is not pinned
    bool parity = false;
  };

  void walk(Piece from, double first_sign, double second_sign, const Budget& budget);
  std::optional<Piece> joined(const Slice& slice) const;
  std::optional<Piece> walked(const Slice& slice);
  bool parity_at(const Piece& piece, double position) const;
  void note_contacts(const Piece& piece);
  static Point point_on(const Slice& slice, double position);
  bool crosses_reference(const Slice& line, double from, double to) const;

  const ForbiddenPlane* plane_;
  Point start_;
  Point goal_;
  std::vector<Piece> pieces_;
  std::array<bool, 2> closed_ = {false, false};
};

}  // namespace dualarm
