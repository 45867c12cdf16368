#include "tests/reference/motion_judge.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <vector>

#include "tests/reference/own_integration.h"

namespace dualarm {
namespace {

/// Positions and velocities are given in double: a few roundings of them are in every answer.
constexpr double kRoundings = 64.0 * std::numeric_limits<double>::epsilon();
/// Of a velocity: what a cruise may change on the way. Starts and goals this close to the limit are on it.
constexpr double kSteady = 1e-9;

template <typename... Parts>
std::string words(const Parts&... parts) {
  std::ostringstream text;
  text.precision(17);
  (text << ... << parts);
  return text.str();
}

template <typename Real>
class Judge {
 public:
  Judge(const Arm& arm, const std::vector<Arc>& arcs, const JudgeTolerances& tolerances)
      : arm_(arm), own_(arm), arcs_(arcs), tolerances_(tolerances) {
    for (const Arc& arc : arcs_) {
      fastest_ = std::max({fastest_, std::abs(arc.start.velocity), std::abs(arc.end.velocity)});
      farthest_ = std::max({farthest_, std::abs(arc.start.position), std::abs(arc.end.position)});
    }
  }

  std::vector<std::string> verdict(JointState start, JointState goal) {
    judge_seams(start, goal);
    if (!complaints_.empty()) return complaints_;
    Real missed = 0;
    for (const Arc& arc : arcs_) missed += arc.kind == ArcKind::kCruise ? judge_cruise(arc) : judge_arc(arc);
    const double duration = arcs_.back().end_time;
    const double floor = kRoundings * farthest_ / fastest_;
    if (!(missed <= Real(tolerances_.duration * duration + floor + tolerances_.instant))) {
      complain("the times of the arcs are off by ", static_cast<double>(missed), " s of ", duration);
    }
    const OwnState<Real> state = driven({start.position, start.velocity});
    if (!near(state, goal, tolerances_.state) && is_audible(duration) && !drowns(start, state)) {
      complain("its torques lead to ", double(state[0]), " ", double(state[1]), ", not to the goal");
    }
    return complaints_;
  }

 private:
  template <typename... Parts>
  void complain(const Parts&... parts) {
    constexpr std::size_t kEnough = 5;
    if (complaints_.size() < kEnough) complaints_.push_back(words(parts...));
  }

  bool near(const OwnState<Real>& state, JointState wanted, double tolerance) const {
    return std::abs(state[0] - Real(wanted.position)) <= Real(tolerance) &&
           std::abs(state[1] - Real(wanted.velocity)) <= Real(tolerance);
  }

  /// Whether an error at the beginning can still be told from one at the end.
  bool is_audible(double time) const {
    return std::sqrt(std::abs(arm_.gravity.amplitude) / arm_.inertia) * time <= tolerances_.growth;
  }

  /// Whether an error at the start drowns the end, as it does on the steep rows of a table, which feed a speed.
  bool drowns(JointState start, const OwnState<Real>& end) {
    constexpr double kError = 1e-9;  // rad/s
    const OwnState<Real> other = driven({start.position, start.velocity + kError});
    return std::abs(other[1] - end[1]) + std::abs(other[0] - end[0]) > Real(kError * std::exp(tolerances_.growth));
  }

  /// Velocities tell it where positions are too coarse.
  static int direction_of(const Arc& arc) {
    const double velocities = arc.start.velocity + arc.end.velocity;
    return (velocities != 0.0 ? velocities : arc.end.position - arc.start.position) > 0.0 ? 1 : -1;
  }

  static int sense_of(const Arc& arc) {
    const int direction = direction_of(arc);
    return arc.kind == ArcKind::kAccelerate ? direction : -direction;
  }

  static double share_of(const Arc& arc) { return sense_of(arc) > 0 ? 1.0 : 0.0; }

  void judge_seams(JointState start, JointState goal) {
    if (arcs_.front().start != start) complain("does not begin at its start");
    if (arcs_.back().end != goal) complain("does not end at its goal");
    if (arcs_.front().start_time != 0.0) complain("does not begin at 0 s");
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      const Arc& arc = arcs_[i];
      if (arc.kind == ArcKind::kHold) complain("arc ", i, " stands still");
      if (!(arc.end_time >= arc.start_time)) complain("arc ", i, " runs backwards in time");
      const double direction = direction_of(arc);
      if (!(std::min(direction * arc.start.velocity, direction * arc.end.velocity) >= -tolerances_.state)) {
        complain("arc ", i, " goes against its velocity");
      }
      if (i > 0 && !(arcs_[i - 1].end == arc.start && arcs_[i - 1].end_time == arc.start_time)) {
        complain("arc ", i, " does not begin where the one before ends");
      }
    }
  }

  void judge_state(const OwnState<Real>& state) {
    const auto beyond = [&](Real value, Interval limits, double slack) {
      return !(value >= Real(limits.lower) - Real(slack) && value <= Real(limits.upper) + Real(slack));
    };
    const double speed_slack = tolerances_.utilisation * std::max(1e-3, fastest_);
    const Interval speed = arm_.velocity;
    if (beyond(state[1], speed, speed_slack)) {
      complain("velocity ", double(state[1]), " rad/s at ", double(state[0]));
    }
    if (beyond(state[0], arm_.joint_range, tolerances_.utilisation * arm_.joint_range.length())) {
      complain("position ", double(state[0]), " rad is outside the range");
    }
  }

  /// By how many seconds the time of an arc is off.
  Real judge_cruise(const Arc& arc) {
    if (!(std::abs(arc.start.velocity - arc.end.velocity) <= kSteady * std::abs(arc.start.velocity))) {
      complain("a cruise changes its velocity");
    }
    judge_state({arc.start.position, arc.start.velocity});
    judge_state({arc.end.position, arc.end.velocity});
    constexpr int kPlaces = 32;
    const Real velocity = arc.start.velocity;
    for (int i = 0; i <= kPlaces; ++i) {
      const Real at = Real(arc.start.position) + (Real(arc.end.position) - Real(arc.start.position)) * i / kPlaces;
      const auto [lowest, highest] = own_.torques(at, velocity);
      const Real needed = own_.holding_torque(at, velocity);
      const Real slack = Real(tolerances_.utilisation) * std::max(std::abs(lowest), std::abs(highest));
      if (!(needed >= lowest - slack && needed <= highest + slack)) {
        complain("a cruise needs ", double(needed), " N m at ", double(at), ", beyond ", double(lowest), " or ",
                 double(highest));
      }
    }
    const Real time = (Real(arc.end.position) - Real(arc.start.position)) / velocity;
    return std::abs(Real(arc.end_time) - Real(arc.start_time) - time);
  }

  /// What is missed along the arc counts as time, what is missed across it as state. From the end whose errors fade,
  /// if they do at one only.
  Real judge_arc(const Arc& arc) {
    if (!is_audible(arc.end_time - arc.start_time)) return 0;
    judge_state({arc.start.position, arc.start.velocity});
    const Miss forward = followed(arc, false);
    if (forward.is_met) return forward.late;
    const Miss backward = followed(arc, true);
    if (!backward.is_met) complain(forward.words);
    return backward.late;
  }

  struct Miss {
    bool is_met = false;
    Real late = 0;  ///< s
    std::string words;
  };

  /// The arc's torque from one of its ends towards the other.
  Miss followed(const Arc& arc, bool backwards) {
    const JointState from = backwards ? arc.end : arc.start;
    const JointState to = backwards ? arc.start : arc.end;
    const Real time = Real(arc.end_time) - Real(arc.start_time);
    OwnIntegration<Real> integration(arm_, share_of(arc), Real(tolerances_.integration));
    std::vector<OwnState<Real>> states;
    const auto visit = [&](const OwnState<Real>& state, Real) { states.push_back(state); };
    const OwnState<Real> end = integration.run({from.position, from.velocity}, backwards ? -time : time, visit);
    const Real along = own_.acceleration(sense_of(arc), end[0], end[1]);
    const Real square = end[1] * end[1] + along * along;
    const Real position_miss = Real(to.position) - end[0];
    const Real velocity_miss = Real(to.velocity) - end[1];
    const Real late = square > 0 ? (end[1] * position_miss + along * velocity_miss) / square : Real(0);
    Miss miss = {near({end[0] + late * end[1], end[1] + late * along}, to, tolerances_.state), std::abs(late), {}};
    miss.words = words("an arc from ", from.position, " ends at ", double(end[0]), " ", double(end[1]), ", not at ",
                       to.position, " ", to.velocity);
    if (miss.is_met || backwards) std::for_each(states.begin(), states.end(), [&](const auto& s) { judge_state(s); });
    return miss;
  }

  /// The arcs' torques over the arcs' times from a state.
  OwnState<Real> driven(OwnState<Real> state) {
    for (const Arc& arc : arcs_) {
      const Real time = Real(arc.end_time) - Real(arc.start_time);
      if (arc.kind == ArcKind::kCruise) {
        state[0] += state[1] * time;
      } else {
        state = OwnIntegration<Real>(arm_, share_of(arc), Real(tolerances_.integration))
                    .run(state, time, [](const OwnState<Real>&, Real) {});
      }
    }
    return state;
  }

  const Arm& arm_;
  OwnEquation<Real> own_;
  const std::vector<Arc>& arcs_;
  JudgeTolerances tolerances_;
  double fastest_ = 0.0;   ///< rad/s
  double farthest_ = 0.0;  ///< rad from zero
  std::vector<std::string> complaints_;
};

}  // namespace

std::vector<std::string> judge_precisely(const Arm& arm, JointState start, JointState goal,
                                         const std::vector<Arc>& arcs, const JudgeTolerances& tolerances) {
  return Judge<long double>(arm, arcs, tolerances).verdict(start, goal);
}

std::vector<std::string> judge_quickly(const Arm& arm, JointState start, JointState goal,
                                       const std::vector<Arc>& arcs) {
  constexpr JudgeTolerances kQuick = {
      .growth = 11.0, .duration = 1e-7, .instant = 1e-9, .state = 1e-6, .utilisation = 1e-7, .integration = 1e-11};
  if (Judge<double>(arm, arcs, kQuick).verdict(start, goal).empty()) return {};
  // Motions that nearly stall magnify the roundings of a quick judge: the precise one has the last word.
  JudgeTolerances patient = kQuick;
  patient.integration = JudgeTolerances{}.integration;
  return judge_precisely(arm, start, goal, arcs, patient);
}

}  // namespace dualarm
