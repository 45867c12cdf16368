#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "core/coordination/flat_pair.h"
#include "core/coordination/upright.h"
#include "core/model/interval_set.h"
#include "core/model/problem.h"

namespace dualarm {

/// The set of joint positions (theta1, theta2), rad, at which the two arms with all they carry come closer than a
/// clearance. Slices are in closed form for upright bodies (planes may differ in height), and traced with a proof for
/// pairs with one that is not: then they are a superset, with ends to 1e-10 rad and the shortest gaps closed (kGap,
/// kLeastGap between capsules).
/// With RegionModel::kPaper the paper's conservative set R_c is added. Theory, section 2 [paper, figure 2].
class ForbiddenSet {
 public:
  /// `clearance` (m, >= 0) between the surfaces of the bodies.
  ForbiddenSet(const Problem& problem, double clearance);

  /// The forbidden theta2 in `window` at one theta1.
  IntervalSet slice(double theta1, Interval window) const;

  /// A superset of the slices at all theta1 of an interval; equal to the slice in the limit of short ones.
  IntervalSet slice_over(Interval theta1, Interval window) const;

  /// The pieces of such a slice over all theta1 no farther than `spread` (rad, >= 0) from one: in any order, and they
  /// may overlap. For those who ask often.
  IntervalList pieces(double theta1, double spread, Interval window) const;

  bool contains(double theta1, double theta2) const;

  /// Whether both joints, each from a state on, are proven to stay out of the set at any times in the convex hull of
  /// `times`. A proof to second order, for upright bodies only: others, and the paper's set, are not proven.
  bool stays_apart(const Course& first, const Course& second, std::span<const TimePair> times) const;

 private:
  /// Bodies of which one leans, in their link frames.
  struct SolidPair {
    Shape of_first;
    Shape of_second;
    double reach;  ///< m, of of_first from the joint of arm 1
  };

  Interval paper_slice(Interval theta1) const;

  Base first_base_;
  Base second_base_;
  double clearance_;
  std::vector<FlatPair> flat_pairs_;
  std::vector<SolidPair> solid_pairs_;
  bool add_paper_set_;
  double first_length_;
  double second_length_;
};

/// The positions (rad) in `window` of one arm at which what moves with it, in its link frame, comes closer than
/// `clearance` (m) to a body that stands still, in the world; as exact as the slices of a ForbiddenSet. Theory,
/// section 2.
IntervalSet blocked_positions(const Base& base, const Shape& moving, const Shape& fixed, double clearance,
                              Interval window);

}  // namespace dualarm
