#include <benchmark/benchmark.h>

#include <array>
#include <numbers>
#include <random>
#include <utility>

#include "geometry/chain.h"
#include "geometry/clearance.h"

// The distance of two bodies as proofs ask for it, by pair of shapes: bodies of about a metre, apart by up to 3 m.
// docs/performance.md has the table.

namespace dualarm {
namespace {

constexpr std::size_t kPairs = 256;  // that take turns, so that no branch is learned by heart

class Shapes {
 public:
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1.0p-53);
  }
  Eigen::Isometry3d pose(double distance) {
    const Eigen::Vector3d axis(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0));
    return Eigen::Translation3d(distance, between(-0.5, 0.5), between(-0.5, 0.5)) *
           Eigen::AngleAxisd(between(0.0, std::numbers::pi), axis.normalized());
  }
  Shape capsule(double distance) {
    const Eigen::Isometry3d at = pose(distance);
    return Capsule{at * Eigen::Vector3d(0.5, 0.0, 0.0), at * Eigen::Vector3d(-0.5, 0.0, 0.0), 0.1};
  }
  Shape box(double distance) { return Box{pose(distance), {between(0.1, 0.5), between(0.1, 0.5), between(0.1, 0.5)}}; }
  Shape cylinder(double distance) {
    const Eigen::Isometry3d at = pose(distance);
    return Cylinder{at * Eigen::Vector3d(0.5, 0.0, 0.0), at * Eigen::Vector3d(-0.5, 0.0, 0.0), between(0.1, 0.5)};
  }

 private:
  std::mt19937_64 engine_{1};
};

/// The second moved until it is a tenth of a millimetre from the first, as optimal plans have it.
Shape brought_near(const Shape& first, const Shape& second) {
  const Clearance apart = clearance(first, second);
  const Eigen::Vector3d way = apart.point_on_first - apart.point_on_second;
  if (apart.distance <= 0.0) return second;
  return placed(second, Eigen::Isometry3d(Eigen::Translation3d((1.0 - 1e-4 / apart.distance) * way)));
}

template <typename First, typename Second>
void measure(benchmark::State& state, const First& first, const Second& second, bool near_touch = false) {
  Shapes shapes;
  std::array<std::pair<Shape, Shape>, kPairs> pairs;
  for (auto& [one, other] : pairs) {
    one = first(shapes);
    other = second(shapes);
    if (near_touch) other = brought_near(one, other);
  }
  std::size_t next = 0;
  std::size_t apart = 0;
  for (auto unused : state) {
    const auto& [one, other] = pairs[next++ % kPairs];
    const Clearance found = clearance(one, other);
    apart += found.distance > 0.0 ? 1 : 0;
    benchmark::DoNotOptimize(found);
  }
  state.counters["apart"] = static_cast<double>(apart) / static_cast<double>(next);
}

Shape capsule_here(Shapes& shapes) { return shapes.capsule(0.0); }
Shape box_here(Shapes& shapes) { return shapes.box(0.0); }
Shape cylinder_here(Shapes& shapes) { return shapes.cylinder(0.0); }
Shape capsule_there(Shapes& shapes) { return shapes.capsule(shapes.between(1.0, 4.0)); }
Shape box_there(Shapes& shapes) { return shapes.box(shapes.between(1.0, 4.0)); }
Shape cylinder_there(Shapes& shapes) { return shapes.cylinder(shapes.between(1.0, 4.0)); }

void CapsuleAndCapsule(benchmark::State& state) { measure(state, capsule_here, capsule_there); }
BENCHMARK(CapsuleAndCapsule);
void CapsuleAndBox(benchmark::State& state) { measure(state, capsule_here, box_there); }
BENCHMARK(CapsuleAndBox);
void CapsuleAndCylinder(benchmark::State& state) { measure(state, capsule_here, cylinder_there); }
BENCHMARK(CapsuleAndCylinder);
void BoxAndBox(benchmark::State& state) { measure(state, box_here, box_there); }
BENCHMARK(BoxAndBox);
void BoxAndCylinder(benchmark::State& state) { measure(state, box_here, cylinder_there); }
BENCHMARK(BoxAndCylinder);
void CylinderAndCylinder(benchmark::State& state) { measure(state, cylinder_here, cylinder_there); }
BENCHMARK(CylinderAndCylinder);

void CapsuleAndBoxAlmostInTouch(benchmark::State& state) { measure(state, capsule_here, box_there, true); }
BENCHMARK(CapsuleAndBoxAlmostInTouch);
void CapsuleAndCylinderAlmostInTouch(benchmark::State& state) { measure(state, capsule_here, cylinder_there, true); }
BENCHMARK(CapsuleAndCylinderAlmostInTouch);
void BoxAndBoxAlmostInTouch(benchmark::State& state) { measure(state, box_here, box_there, true); }
BENCHMARK(BoxAndBoxAlmostInTouch);
void CylinderAndCylinderAlmostInTouch(benchmark::State& state) { measure(state, cylinder_here, cylinder_there, true); }
BENCHMARK(CylinderAndCylinderAlmostInTouch);

}  // namespace
}  // namespace dualarm

BENCHMARK_MAIN();
