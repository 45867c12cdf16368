#include "tests/reference/transcription_starts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "tests/support/dice.h"

namespace dualarm {
namespace {

struct Draw {
  Scripts scripts;
  double score = 0.0;  // s, with a fine for collisions
};

using Kind = std::tuple<bool, bool, int>;  // by way of a place: arm 1, arm 2; which arm waits, or -1

/// A straight motion, its spare stretches of no length before and after it.
std::vector<Stretch> straight(const Arm& arm, const Task& task, Dice& dice) {
  const std::vector<Stretch> move = crude_move(arm, task.start.position, task.goal.position);
  if (move.empty()) return {};
  std::vector<Stretch> all(kStretches);
  const int first = dice.one_of(kStretches - 1);
  for (int i = 0; i < kStretches; ++i) all[i].share = (i - first) % 2 == 0 ? move[0].share : move[1].share;
  all[first].duration = move[0].duration;
  all[first + 1].duration = move[1].duration;
  return all;
}

/// Two straight motions with a rest at a random place between them.
std::vector<Stretch> detour(const Arm& arm, const Task& task, Dice& dice) {
  const double via = dice.between(arm.joint_range.lower, arm.joint_range.upper);
  const double rest = dice.happens(0.5) ? 0.0 : dice.between(0.0, 0.5);  // s
  const std::vector<Stretch> there = crude_move(arm, task.start.position, via);
  const std::vector<Stretch> onward = crude_move(arm, via, task.goal.position);
  if (there.empty() || onward.empty()) return {};
  return {there[0], there[1], {rest, holding_share(arm, via)}, onward[0], onward[1], {0.0, onward[0].share}};
}

double score(const Problem& problem, const Scripts& scripts) {
  constexpr double kFine = 3.0;  // s a metre of collision
  constexpr Rehearsing kCoarse = {10, 40, 0, 0.0};
  const double duration = std::max(scripts[0].duration(), scripts[1].duration());
  const Rehearsal seen = rehearse(problem, scripts, duration, kCoarse);
  return duration + kFine * std::max(0.0, clearance_miss(problem, seen));
}

/// Some scripts and their kind; a script may come out empty.
std::pair<Kind, Scripts> drawn(const Problem& problem, Dice& dice) {
  constexpr double kLongestWait = 1.5;  // of the duration of the arm that goes first
  Scripts scripts;
  std::array<bool, kArmCount> is_detour{};
  for (int arm = 0; arm < kArmCount; ++arm) {
    is_detour[arm] = dice.happens(0.5);
    scripts[arm].stretches = (is_detour[arm] ? detour : straight)(problem.arms[arm], problem.tasks[arm], dice);
  }
  const int waiting = dice.one_of(3) - 1;
  const double wait = dice.between(0.0, kLongestWait);
  if (waiting >= 0) scripts[waiting].wait = wait * scripts[1 - waiting].duration();
  return {{is_detour[0], is_detour[1], waiting}, scripts};
}

}  // namespace

std::vector<Scripts> transcription_starts(const Problem& problem, std::uint64_t seed, int draws, int most) {
  Dice dice(seed);
  std::map<Kind, Draw> best;
  for (int i = 0; i < draws; ++i) {
    const auto [kind, scripts] = drawn(problem, dice);
    if (scripts[0].stretches.empty() || scripts[1].stretches.empty()) continue;
    const Draw draw = {scripts, score(problem, scripts)};
    const auto [at, is_new] = best.try_emplace(kind, draw);
    if (!is_new && draw.score < at->second.score) at->second = draw;
  }
  std::vector<Draw> sorted;
  for (const auto& [kind, draw] : best) sorted.push_back(draw);
  std::sort(sorted.begin(), sorted.end(), [](const Draw& a, const Draw& b) { return a.score < b.score; });
  std::vector<Scripts> starts;
  for (const Draw& draw : sorted) {
    if (static_cast<int>(starts.size()) < most) starts.push_back(draw.scripts);
  }
  return starts;
}

}  // namespace dualarm
