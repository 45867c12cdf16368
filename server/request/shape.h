#pragma once

#include "core/model/scene.h"
#include "server/request/field.h"
#include "server/wire.h"

namespace dualarm {

/// The shape of an object in the object's own frame. What is wrong is noted on `object`.
Shape read_shape(const wire::Object& message, const Field& object);

}  // namespace dualarm
