#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <string>

#include "dualarm/planning/v1/planning_service.grpc.pb.h"
#include "server/wire.h"

namespace dualarm {

/// A scenario of the project by its name.
wire::PlanMotionRequest scenario_request(const std::string& name);

/// The same, planned by the search alone: slow.
wire::PlanMotionRequest search_request(const std::string& name, int seed);

/// A connection of its own, not shared with other channels of this process.
std::shared_ptr<grpc::Channel> new_channel(const std::string& address);

/// Whether the server says that it serves.
bool is_healthy(const std::shared_ptr<grpc::Channel>& channel);

}  // namespace dualarm
