#pragma once

#include "core/model/arm.h"
#include "server/request/field.h"
#include "server/wire.h"

namespace dualarm {

/// The arm that a message describes. What is wrong with it is noted on `field`.
Arm read_arm(const wire::Arm& message, const Field& field);

/// A name of an arm or of an object: 1 to 64 printable ASCII characters.
std::string read_name(const std::string& name, const Field& field);

}  // namespace dualarm
