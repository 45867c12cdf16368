// What was proven about a motion, for people.
#pragma once

#include <string>

#include "dualarm/planning/v1/certificate.pb.h"

namespace dualarm {

/// Lines with a label column, indented by two spaces: the clearance with the closest bodies and when they are closest,
/// the use of each limit, and every broken demand.
std::string verification_lines(const planning::v1::Verification& verification);

/// Whether the motion keeps every demand.
bool is_verified(const planning::v1::Verification& verification);

}  // namespace dualarm
