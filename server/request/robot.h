#pragma once

#include <array>

#include "core/model/problem.h"
#include "server/request/field.h"
#include "server/wire.h"

namespace dualarm {

/// Both arms. What is wrong is noted on `request`, which is the message that has the field `robot`; if anything is,
/// the arms are not to be used for more than finding further violations.
std::array<Arm, kArmCount> read_robot(const wire::Robot* message, const Field& request);

/// Index of the arm with this name, or -1.
int index_of(const std::array<Arm, kArmCount>& arms, std::string_view name);

/// False if the robot is missing or nameless: then nothing can be said about the names that refer to its arms.
bool has_names(const std::array<Arm, kArmCount>& arms);

/// "'left' or 'right'", for remedies: names that are there, each once. Needs has_names().
std::string names_of(const std::array<Arm, kArmCount>& arms);

}  // namespace dualarm
