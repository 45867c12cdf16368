#include "core/coordination/diagram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <set>

#include "core/coordination/start_times.h"
#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Both arms of a problem with their fastest motions, or with motions of their own.
struct Pair {
  explicit Pair(const Problem& problem) : systems{SingleJointArm(problem.arms[0]), SingleJointArm(problem.arms[1])} {
    for (int i = 0; i < kArmCount; ++i) {
      auto motion = fastest_motion(systems[i], problem.tasks[i].start.position, problem.tasks[i].goal.position);
      if (auto* fastest = std::get_if<FastestMotion>(&motion)) profiles.push_back(std::move(fastest->profile));
    }
  }

  /// A motion of an arm that rests at each of the positions: it turns back where they do.
  std::optional<Profile> wandering(int arm, const std::vector<double>& positions) const {
    std::vector<Arc> arcs;
    for (std::size_t i = 0; i + 1 < positions.size(); ++i) {
      const auto motion = fastest_motion(systems[arm], positions[i], positions[i + 1], Swings::kSkip);
      const auto* fastest = std::get_if<FastestMotion>(&motion);
      if (fastest == nullptr) return std::nullopt;
      arcs.insert(arcs.end(), fastest->profile.arcs().begin(), fastest->profile.arcs().end());
    }
    return arcs.empty() ? Profile(systems[arm], positions.front()) : Profile(systems[arm], std::move(arcs));
  }

  std::array<SingleJointArm, kArmCount> systems;
  std::vector<Profile> profiles;
};

/// Whether two motions collide at one delay, by looking at many instants. Positions are taken from tables, not from the
/// diagram's own-clock times.
class BruteForce {
 public:
  BruteForce(const Problem& problem, double clearance, const Pair& pair)
      : forbidden_(problem, clearance), pair_(pair), step_(0.0) {
    const double longest = std::max(pair.profiles[0].duration(), pair.profiles[1].duration());
    step_ = longest / 400.0;
    for (const Profile& profile : pair.profiles) {
      std::vector<double> table;
      for (int i = 0; step_ * i < profile.duration() + step_; ++i) table.push_back(profile.at(step_ * i).position);
      tables_.push_back(std::move(table));
    }
  }

  /// Delay in steps of the time grid.
  bool collides(int delay) const {
    const int from = std::min(0, delay);
    const int to = std::max(static_cast<int>(tables_[0].size()), static_cast<int>(tables_[1].size()) + delay);
    for (int i = from; i <= to; ++i) {
      const auto position = [&](int arm, int at) {
        return tables_[arm][std::clamp<int>(at, 0, static_cast<int>(tables_[arm].size()) - 1)];
      };
      if (forbidden_.contains(position(0, i), position(1, i - delay))) return true;
    }
    return false;
  }

  double step() const { return step_; }

 private:
  ForbiddenSet forbidden_;
  const Pair& pair_;
  double step_;
  std::vector<std::vector<double>> tables_;
};

/// Delays against the scan, both ways: coarsely over all of them, and every step near the ends.
void expect_like_brute_force(const BruteForce& brute, const IntervalSet& delays) {
  std::set<int> tried;
  for (int delay = -450; delay <= 450; delay += 30) tried.insert(delay);
  for (const Interval& interval : delays.intervals()) {
    for (const double end : {interval.lower, interval.upper}) {
      if (!std::isfinite(end)) continue;
      for (int offset = -6; offset <= 6; ++offset) tried.insert(static_cast<int>(end / brute.step()) + offset);
    }
  }
  for (const int delay : tried) {
    const double value = delay * brute.step();
    const bool collides = brute.collides(delay);
    // Never smaller: what the scan sees colliding lies inside the forbidden set.
    EXPECT_TRUE(!collides || delays.contains(value)) << "delay " << value;
    // None missed: what is forbidden with room to spare on both sides, the scan sees, too. It may look away for a
    // step, during which the arms may touch by less than they travel in it.
    const bool deep = delays.covers({value - 2.0 * brute.step(), value + 2.0 * brute.step()});
    if (deep && !collides) {
      bool near = false;
      for (int other = delay - 2; other <= delay + 2; ++other) near = near || brute.collides(other);
      EXPECT_TRUE(near) << "delay " << value;
    }
  }
}

/// Just outside a finite end the motions keep the clearance, just inside they break it: sought by the finest scan near
/// the touch instead of by projection. Returns the number of ends.
int expect_exact_ends(const Problem& problem, const Pair& pair) {
  const Profile& first = pair.profiles[0];
  const Profile& second = pair.profiles[1];
  const ForbiddenSet forbidden(problem, problem.options.clearance);
  const auto collides = [&](double delay) {
    const double from = std::min(0.0, delay);
    const double to = std::max(first.duration(), second.duration() + delay);
    for (int i = 0; i <= 4000; ++i) {
      const double time = from + (to - from) * i / 4000.0;
      if (forbidden.contains(first.at(time).position, second.at(time - delay).position)) return true;
    }
    return false;
  };
  int ends = 0;
  for (const Interval& interval : forbidden_delays(forbidden, first, second, Budget()).value().intervals()) {
    for (const double end : {interval.lower, interval.upper}) {
      if (!std::isfinite(end)) continue;
      ++ends;
      const double outward = end == interval.lower ? -1.0 : 1.0;
      EXPECT_FALSE(collides(end + outward * 1e-7)) << "end " << end;
      EXPECT_TRUE(collides(end - outward * 2e-3 * first.duration())) << "end " << end;
    }
  }
  return ends;
}

/// Two arms that wander: up to three rests on the way, turning back or not; nothing where an arm cannot.
std::vector<Profile> wandering_motions(const Problem& problem, const Pair& pair, std::mt19937_64& generator) {
  std::vector<Profile> profiles;
  for (int arm = 0; arm < kArmCount; ++arm) {
    const Task& task = problem.tasks[arm];
    std::vector<double> positions = {task.start.position};
    for (std::uint64_t rests = generator() % 4; rests > 0; --rests) {
      const double reach = std::uniform_real_distribution<double>(-0.5, 0.5)(generator);
      const double position = std::clamp(positions.back() + reach, 0.0, std::numbers::pi);
      if (position != positions.back()) positions.push_back(position);
    }
    if (task.goal.position != positions.back()) positions.push_back(task.goal.position);
    auto profile = pair.wandering(arm, positions);
    if (!profile) return {};
    profiles.push_back(std::move(*profile));
  }
  return profiles;
}

TEST(ForbiddenDelays, OfThePapersArmsEndAtTheWorkedDelays) {
  // theory.md, section 4: best delay plan of each row, r = 0.
  const double rows[][5] = {{30, 60, 60, 30, 1.500925},
                            {20, 90, 90, 20, 1.793744},
                            {20, 70, 60, 20, 1.795627},
                            {10, 80, 60, 15, 1.970339},
                            {5, 60, 50, 10, 2.208863}};
  for (const auto& [start1, start2, goal1, goal2, seconds] : rows) {
    const Problem problem = paper_problem({start1, start2}, {goal1, goal2}, 1e-9);
    const Pair pair(problem);
    const IntervalSet delays =
        *forbidden_delays(ForbiddenSet(problem, 0.0), pair.profiles[0], pair.profiles[1], Budget());
    const auto times = best_start_times(delays.complement({-kInfinity, kInfinity}), timing_of(pair.profiles[0]),
                                        timing_of(pair.profiles[1]), kInfinity);
    ASSERT_TRUE(times);
    EXPECT_NEAR(times->duration, seconds, 1e-6) << start1 << " " << start2;
  }
}

TEST(ForbiddenDelays, AreAllOfThemForTheRetreat) {
  const Problem problem = paper_problem({10, 40}, {40, 10}, 1e-9);
  const Pair pair(problem);
  const IntervalSet delays =
      *forbidden_delays(ForbiddenSet(problem, 0.0), pair.profiles[0], pair.profiles[1], Budget());
  EXPECT_TRUE(delays.covers({-kInfinity, kInfinity}));
}

TEST(ForbiddenDelays, OfAnArmThatStandsInTheWayAreAllOfThem) {
  const Problem problem = paper_problem({20, 70}, {20, 5}, 0.05);
  const Pair pair(problem);
  const IntervalSet delays =
      *forbidden_delays(ForbiddenSet(problem, 0.0), pair.profiles[0], pair.profiles[1], Budget());
  EXPECT_TRUE(delays.covers({-kInfinity, kInfinity}));
}

TEST(ForbiddenDelays, AreNoneForArmsOutOfEachOthersReach) {
  Problem problem = paper_problem({20, 70}, {60, 20}, 0.05);
  problem.arms[1].base.position.x() = 13.0;
  const Pair pair(problem);
  EXPECT_TRUE(
      forbidden_delays(ForbiddenSet(problem, 0.0), pair.profiles[0], pair.profiles[1], Budget()).value().empty());
}

TEST(MayMeet, SaysNoOnlyWhereNoDelayCollides) {
  int apart = 0;
  for (double base = 8.0; base <= 20.0; base += 0.5) {
    SCOPED_TRACE(base);
    Problem problem = paper_problem({20, 70}, {60, 20}, 0.05);
    problem.arms[1].base.position.x() = base;
    const Pair pair(problem);
    if (may_meet(ForbiddenSet(problem, 0.0), pair.profiles[0], pair.profiles[1])) continue;
    ++apart;
    const BruteForce brute(problem, 0.0, pair);
    for (int delay = -400; delay <= 400; delay += 10) ASSERT_FALSE(brute.collides(delay)) << delay;
  }
  EXPECT_GT(apart, 5);
  EXPECT_LT(apart, 20);
}

TEST(ForbiddenDelays, EqualABruteForceScanOnRandomScenes) {
  int constrained = 0;
  for (int scene = 0; constrained < 500; ++scene) {
    ASSERT_LT(scene, 20000) << "too few scenes need a delay";
    SCOPED_TRACE(scene);
    const Problem problem = random_problem(scene);
    const Pair pair(problem);
    if (pair.profiles.size() != 2) continue;
    const double clearance = problem.options.clearance;
    const IntervalSet delays =
        *forbidden_delays(ForbiddenSet(problem, clearance), pair.profiles[0], pair.profiles[1], Budget());
    if (delays.empty() || delays.covers({-kInfinity, kInfinity})) continue;
    ++constrained;
    expect_like_brute_force(BruteForce(problem, clearance, pair), delays);
  }
}

TEST(ForbiddenDelays, EqualABruteForceScanForMotionsThatTurnBack) {
  int constrained = 0;
  int turning = 0;
  for (int scene = 0; constrained < 300; ++scene) {
    ASSERT_LT(scene, 20000) << "too few scenes need a delay";
    SCOPED_TRACE(scene);
    const Problem problem = random_problem(scene);
    std::mt19937_64 generator(scene);
    Pair pair(problem);
    pair.profiles = wandering_motions(problem, pair, generator);
    if (pair.profiles.empty()) continue;
    const double clearance = problem.options.clearance;
    const IntervalSet delays =
        *forbidden_delays(ForbiddenSet(problem, clearance), pair.profiles[0], pair.profiles[1], Budget());
    if (delays.empty() || delays.covers({-kInfinity, kInfinity})) continue;
    ++constrained;
    if (pair.profiles[0].legs().size() > 1 && pair.profiles[1].legs().size() > 1) ++turning;
    expect_like_brute_force(BruteForce(problem, clearance, pair), delays);
  }
  EXPECT_GT(turning, 50);
}

TEST(ForbiddenDelays, OfMotionsThatTurnBackEndWhereTheyTouchExactly) {
  int ends = 0;
  for (int scene = 0; ends < 100; ++scene) {
    ASSERT_LT(scene, 20000);
    SCOPED_TRACE(scene);
    const Problem problem = random_problem(scene);
    std::mt19937_64 generator(scene);
    Pair pair(problem);
    pair.profiles = wandering_motions(problem, pair, generator);
    if (!pair.profiles.empty()) ends += expect_exact_ends(problem, pair);
  }
}

TEST(ForbiddenDelays, SeeAnArmThatSwingsIntoTheOtherAndBack) {
  // Start and goal of arm 1 are one position out of the way of arm 2, which stands; in between it swings into it.
  const Problem problem = paper_problem({100, 30}, {100, 30}, 0.05);
  Pair pair(problem);
  const auto degrees = [](double value) { return value * std::numbers::pi / 180.0; };
  pair.profiles[0] = pair.wandering(0, {degrees(100), degrees(20), degrees(100)}).value();
  const ForbiddenSet forbidden(problem, 0.0);
  ASSERT_TRUE(forbidden.contains(degrees(20), degrees(30)));
  EXPECT_TRUE(forbidden_delays(forbidden, pair.profiles[0], pair.profiles[1], Budget())
                  .value()
                  .covers({-kInfinity, kInfinity}));
  // The other way round: the arm that swings is the second one.
  const Problem exchanged = paper_problem({30, 100}, {30, 100}, 0.05);
  Pair other(exchanged);
  other.profiles[1] = other.wandering(1, {degrees(100), degrees(20), degrees(100)}).value();
  EXPECT_TRUE(forbidden_delays(ForbiddenSet(exchanged, 0.0), other.profiles[0], other.profiles[1], Budget())
                  .value()
                  .covers({-kInfinity, kInfinity}));
}

/// Every safe interval between forbidden ones is wide enough to be meant and free in its middle.
void expect_no_holes(const Problem& problem) {
  const Pair pair(problem);
  if (pair.profiles.size() != 2) return;
  const ForbiddenSet forbidden(problem, problem.options.clearance);
  const IntervalSet delays = forbidden_delays(forbidden, pair.profiles[0], pair.profiles[1], Budget()).value();
  const double longest = std::max(pair.profiles[0].duration(), pair.profiles[1].duration());
  for (const Interval& safe : delays.complement({-kInfinity, kInfinity}).intervals()) {
    if (!std::isfinite(safe.lower) || !std::isfinite(safe.upper)) continue;
    EXPECT_GT(safe.length(), 1.9e-4 * longest);
    const double delay = 0.5 * (safe.lower + safe.upper);
    for (int i = 0; i <= 4000; ++i) {
      const double time = -longest + 3.0 * longest * i / 4000.0;
      ASSERT_FALSE(forbidden.contains(pair.profiles[0].at(time).position, pair.profiles[1].at(time - delay).position))
          << "delay " << delay;
    }
  }
}

TEST(ForbiddenDelays, LeaveNoHolesWhereOneArmIsMuchSlower) {
  // A slow arm's slices are short in time: neighbouring ones forbid delays that hardly overlap.
  for (int scene = 0; scene < 400; ++scene) {
    SCOPED_TRACE(scene);
    Problem problem = random_problem(scene);
    problem.arms[scene % 2].velocity = {-0.05 * (1 + scene % 7), 0.05 * (1 + scene % 7)};
    expect_no_holes(problem);
  }
}

TEST(ForbiddenDelays, LeaveNoHolesWhereOneArmIsMuchHeavierAndCarriesABeam) {
  for (const double inertia : {3e3, 1e4, 3e4, 1e5}) {
    SCOPED_TRACE(inertia);
    Problem problem = paper_problem({20, 70}, {60, 20}, 0.05, 0.01);
    problem.arms[0].inertia = inertia;
    const Eigen::Isometry3d pose =
        Eigen::Translation3d(6.0, 0.0, 0.0) * Eigen::AngleAxisd(0.5 * std::numbers::pi, Eigen::Vector3d::UnitZ());
    problem.objects = {{"beam", Capsule{{-0.6, 0, 0}, {0.6, 0, 0}, 0.1}, AttachedPlacement{0, pose, 0.0}}};
    expect_no_holes(problem);
  }
}

TEST(ForbiddenDelays, AreNotGivenOnceTheBudgetIsGone) {
  const Problem problem = paper_problem({20, 70}, {60, 20}, 0.05);
  const Pair pair(problem);
  const Budget gone(Budget::Clock::now() - std::chrono::seconds(1));
  EXPECT_FALSE(forbidden_delays(ForbiddenSet(problem, 0.0), pair.profiles[0], pair.profiles[1], gone));
}

TEST(ForbiddenDelays, HaveEndsAtWhichTheMotionsTouchExactly) {
  int ends = 0;
  for (int scene = 0; ends < 100; ++scene) {
    ASSERT_LT(scene, 20000);
    SCOPED_TRACE(scene);
    const Problem problem = random_problem(scene);
    const Pair pair(problem);
    if (pair.profiles.size() == 2) ends += expect_exact_ends(problem, pair);
  }
}

}  // namespace
}  // namespace dualarm
