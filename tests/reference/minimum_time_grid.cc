#include "tests/reference/minimum_time_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/reference/energy_sweep.h"

namespace dualarm {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr int kNodes = 40;            // turning points tried, evenly over the joint range
constexpr int kCoarseCells = 24;      // of a leg while sequences are searched
constexpr int kPolishCells = 200;     // while turning points are moved
constexpr int kFineCells = 800;       // for the answer, which is extrapolated from these and twice as many
constexpr double kWorthwhile = 1.15;  // sequences that are this much slower on the coarse mesh are not polished
constexpr int kPolished = 3;          // of the sequences that turn, the best on the coarse mesh
constexpr int kRounds = 3;            // of moving every turning point in turn
constexpr int kSections = 26;         // of a bracket: leaves 4e-6 of it, and of the time the square of that

/// A way to begin or to end: a state, and the time from the start to it or from it to the goal.
struct Port {
  JointState state;
  double time = 0.0;
};

/// Turning points on the way from one port to another.
struct Sequence {
  Port from;
  Port to;
  std::vector<double> turns;
  double coarse = kNever;  ///< s, on the coarse mesh
};

class GridSearch {
 public:
  GridSearch(const Arm& arm, JointState start, JointState goal, int most_turns) : arm_(arm), most_turns_(most_turns) {
    begins_.push_back({start, 0.0});
    ends_.push_back({goal, 0.0});
    if (const auto stop = full_stop(arm, start, false)) begins_.push_back({{stop->position, 0.0}, stop->time});
    if (const auto stop = full_stop(arm, goal, true)) ends_.push_back({{stop->position, 0.0}, stop->time});
    const Interval range = arm.joint_range;
    for (int i = 0; i < kNodes; ++i) nodes_.push_back(range.lower + range.length() * i / (kNodes - 1));
  }

  std::optional<GridMotion> best() {
    std::vector<Sequence> sequences = candidates();
    std::optional<GridMotion> best;
    int polished = 0;
    for (Sequence& sequence : sequences) {
      // A motion without free turning points can be at the edge of what is reachable: only a fine mesh sees it.
      if (!sequence.turns.empty() && (polished++ >= kPolished || sequence.coarse > kWorthwhile * coarsest_)) continue;
      polish(sequence);
      const double fine = time(sequence, kFineCells);
      const double finest = time(sequence, 2 * kFineCells);
      const double duration = finest + (finest - fine) / 3.0;
      if (!(duration < kNever) || (best && best->duration <= duration)) continue;
      best = GridMotion{duration, std::abs(finest - fine), sequence.turns};
    }
    return best;
  }

 private:
  double leg(JointState from, JointState to, int cells) const {
    return sweep_time(arm_, from, to, cells).value_or(kNever);
  }

  double time(const Sequence& sequence, int cells) const {
    double sum = sequence.from.time + sequence.to.time;
    JointState at = sequence.from.state;
    for (const double turn : sequence.turns) {
      sum += leg(at, {turn, 0.0}, cells);
      at = {turn, 0.0};
    }
    return sum + leg(at, sequence.to.state, cells);
  }

  /// For each pair of ways to begin and to end and each number of turning points the best sequence on the grid.
  std::vector<Sequence> candidates() {
    std::vector<Sequence> found;
    for (const Port& from : begins_) {
      for (const Port& to : ends_) append(found, {from, to, {}, kNever});
    }
    for (const Port& from : begins_) {
      for (const Port& to : ends_) append_turning(found, from, to);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Sequence& a, const Sequence& b) { return a.coarse < b.coarse; });
    return found;
  }

  void append(std::vector<Sequence>& found, Sequence sequence) {
    sequence.coarse = time(sequence, kCoarseCells);
    if (!(sequence.coarse < kNever) && !sequence.turns.empty()) return;
    coarsest_ = std::min(coarsest_, sequence.coarse);
    found.push_back(std::move(sequence));
  }

  void append_turning(std::vector<Sequence>& found, const Port& from, const Port& to) {
    std::vector<double> reached(kNodes);
    std::vector<double> rest(kNodes);
    for (int i = 0; i < kNodes; ++i) {
      reached[i] = leg(from.state, {nodes_[i], 0.0}, kCoarseCells);
      rest[i] = leg({nodes_[i], 0.0}, to.state, kCoarseCells);
    }
    std::vector<std::vector<int>> came_from;
    for (int turns = 1; turns <= most_turns_; ++turns) {
      int last = 0;
      for (int i = 0; i < kNodes; ++i) {
        if (reached[i] + rest[i] < reached[last] + rest[last]) last = i;
      }
      append(found, {from, to, trace(came_from, last), kNever});
      std::vector<double> next(kNodes, kNever);
      came_from.emplace_back(kNodes, 0);
      for (int i = 0; i < kNodes; ++i) {
        if (reached[i] > kWorthwhile * coarsest_ || reached[i] == kNever) continue;
        const std::vector<double>& onwards = legs_from(i);
        for (int j = 0; j < kNodes; ++j) {
          const double time = reached[i] + onwards[j];
          if (time < next[j]) {
            next[j] = time;
            came_from.back()[j] = i;
          }
        }
      }
      reached = next;
    }
  }

  std::vector<double> trace(const std::vector<std::vector<int>>& came_from, int last) const {
    std::vector<double> turns = {nodes_[last]};
    for (auto layer = came_from.rbegin(); layer != came_from.rend(); ++layer) {
      last = (*layer)[last];
      turns.insert(turns.begin(), nodes_[last]);
    }
    return turns;
  }

  const std::vector<double>& legs_from(int i) {
    if (legs_[i].empty()) {
      for (const double node : nodes_) legs_[i].push_back(leg({nodes_[i], 0.0}, {node, 0.0}, kCoarseCells));
      legs_[i][i] = kNever;
    }
    return legs_[i];
  }

  /// Moves the turning points in turn, each by golden section, to the least time.
  void polish(Sequence& sequence) const {
    double reach = 2.0 * arm_.joint_range.length() / (kNodes - 1);
    for (int round = 0; round < kRounds && !sequence.turns.empty(); ++round) {
      for (std::size_t i = 0; i < sequence.turns.size(); ++i) improve(sequence, i, reach);
      if (sequence.turns.size() == 1) break;
      reach *= 0.2;
    }
  }

  void improve(Sequence& sequence, std::size_t i, double reach) const {
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    const double now = sequence.turns[i];
    const auto at = [&](double turn) {
      sequence.turns[i] = turn;
      return time(sequence, kPolishCells);
    };
    double low = std::max(arm_.joint_range.lower, now - reach);
    double high = std::min(arm_.joint_range.upper, now + reach);
    double best = now;
    double least = at(now);
    for (const double wall : {low, high}) {
      if (at(wall) < least) least = at(best = wall);
    }
    double left = high - golden * (high - low);
    double right = low + golden * (high - low);
    double left_time = at(left);
    double right_time = at(right);
    for (int section = 0; section < kSections; ++section) {
      // Where neither is reached the bracket closes on the best that is known.
      const bool keep_left = left_time < right_time || (left_time == right_time && best < left);
      (keep_left ? high : low) = keep_left ? right : left;
      if (std::min(left_time, right_time) < least) {
        best = left_time < right_time ? left : right;
        least = std::min(left_time, right_time);
      }
      left = high - golden * (high - low);
      right = low + golden * (high - low);
      left_time = at(left);
      right_time = at(right);
    }
    sequence.turns[i] = best;
  }

  const Arm& arm_;
  int most_turns_;
  std::vector<Port> begins_;
  std::vector<Port> ends_;
  std::vector<double> nodes_;
  std::vector<std::vector<double>> legs_ = std::vector<std::vector<double>>(kNodes);  ///< s, from node to node
  double coarsest_ = kNever;                                                          ///< s, the best so far
};

}  // namespace

std::optional<GridMotion> minimum_time_by_grid(const Arm& arm, JointState start, JointState goal, int most_turns) {
  return GridSearch(arm, start, goal, most_turns).best();
}

}  // namespace dualarm
