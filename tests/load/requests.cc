#include "tests/load/requests.h"

#include <google/protobuf/util/json_util.h>
#include <google/protobuf/wrappers.pb.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>

#include <atomic>
#include <fstream>
#include <future>
#include <sstream>
#include <stdexcept>

namespace dualarm {

wire::PlanMotionRequest scenario_request(const std::string& name) {
  const std::string path = std::string(DUALARM_SCENARIOS "/") + name + ".json";
  std::ostringstream json;
  json << std::ifstream(path).rdbuf();
  wire::PlanMotionRequest request;
  if (!google::protobuf::util::JsonStringToMessage(json.str(), &request).ok()) {
    throw std::runtime_error(path + " is no scenario");
  }
  return request;
}

wire::PlanMotionRequest search_request(const std::string& name, int seed) {
  wire::PlanMotionRequest request = scenario_request(name);
  request.mutable_options()->clear_methods();
  request.mutable_options()->add_methods(wire::METHOD_STATE_TIME);
  request.mutable_options()->set_seed(seed);
  return request;
}

std::shared_ptr<grpc::Channel> new_channel(const std::string& address) {
  static std::atomic<int> number = 0;
  grpc::ChannelArguments arguments;
  arguments.SetInt("dualarm.load.number", ++number);  // channels of equal arguments share a connection
  return grpc::CreateCustomChannel(address, grpc::InsecureChannelCredentials(), arguments);
}

bool is_healthy(const std::shared_ptr<grpc::Channel>& channel) {
  using google::protobuf::Int32Value;
  using google::protobuf::StringValue;
  grpc::TemplatedGenericStub<StringValue, Int32Value> stub(channel);
  const StringValue request;
  Int32Value answer;
  grpc::ClientContext context;
  std::promise<grpc::Status> done;
  stub.UnaryCall(&context, "/grpc.health.v1.Health/Check", {}, &request, &answer,
                 [&done](grpc::Status status) { done.set_value(std::move(status)); });
  return done.get_future().get().ok() && answer.value() == 1;
}

}  // namespace dualarm
