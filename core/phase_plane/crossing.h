#pragma once

#include <functional>

namespace dualarm {

/// The root (to the last bits) of a continuous function between two points at which its signs differ or one of which is
/// a root. Where two arcs under constant torque limits meet, the function is linear and the first secant is already the
/// closed form of the switch (theory, section 1.1).
double crossing(const std::function<double(double)>& function, double from, double to);

}  // namespace dualarm
