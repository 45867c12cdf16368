// Words for people: the wire's enum values, spans of time, degrees.
#pragma once

#include <string>

#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

/// "simultaneous", "delay", "passage", "state-time".
std::string words_for(planning::v1::Method method);

/// "accelerate", "brake", "cruise", "hold".
std::string words_for(planning::v1::ArcKind kind);

/// "start in collision", ...
std::string words_for(planning::v1::Reason reason);

/// One plain sentence on what the certificate claims of the plan's duration.
std::string claim_sentence(const planning::v1::Plan& plan);

/// "1.795627 s", "inf".
std::string seconds(double value);

/// "25.00 deg" for an angle in radians.
std::string degrees(double radians);

/// "0.250000 m", or "unlimited" where no two bodies can meet.
std::string clearance(double metres);

/// "99.98 %" for a share of 0.9998; "1.23e+09 %" from a million per cent on, where digits before the point say nothing.
std::string percent(double share);

double to_degrees(double radians);

}  // namespace dualarm
