#include "server/errors.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>
#include <grpcpp/support/error_details.h>

#include <chrono>

#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"

namespace dualarm {
namespace {

// Together, with base64 for the details and the names of the metadata, below 8 KiB.
constexpr std::size_t kMostMessageBytes = 2000;
constexpr std::size_t kMostDetailBytes = 3600;
constexpr std::size_t kFramingBytes = 8;  // of one violation in protobuf

// About the time in which a place in the queue becomes free: of quick plans, of searches, of streams.
constexpr std::chrono::milliseconds kRetryDelay{100};
constexpr std::chrono::milliseconds kSearchRetryDelay{1000};
constexpr std::chrono::milliseconds kStreamRetryDelay{1000};

google::rpc::ErrorInfo error_info(std::string_view reason) {
  google::rpc::ErrorInfo info;
  info.set_reason(std::string(reason));
  info.set_domain("dualarm");
  return info;
}

// `summary` is what the details repeat of the message.
template <typename... Details>
grpc::Status status(grpc::StatusCode code, const std::string& message, const std::string& summary,
                    const Details&... details) {
  google::rpc::Status rich;
  rich.set_code(code);
  rich.set_message(summary);
  (rich.add_details()->PackFrom(details), ...);
  return {code, message, rich.SerializeAsString()};
}

grpc::Status exhausted(std::string_view what, std::string_view reason, std::chrono::milliseconds retry_delay) {
  google::rpc::RetryInfo retry;
  *retry.mutable_retry_delay() = google::protobuf::util::TimeUtil::MillisecondsToDuration(retry_delay.count());
  const std::string message = fmt::format("{}: try again in {} ms", what, retry_delay.count());
  return status(grpc::StatusCode::RESOURCE_EXHAUSTED, message, message, retry, error_info(reason));
}

// gRPC sends a message percent-encoded: three bytes for '%' and whatever is not printable ASCII.
std::size_t encoded_size(std::string_view message) {
  std::size_t size = 0;
  for (const char character : message) size += character >= ' ' && character <= '~' && character != '%' ? 1 : 3;
  return size;
}

std::string headline(const Violations& violations) {
  return fmt::format("{} violation{}", violations.count(), violations.count() == 1 ? "" : "s");
}

std::string listing(const Violations& violations) {
  std::string text = headline(violations);
  std::size_t bytes = text.size();
  std::size_t shown = 0;
  for (const FieldViolation& violation : violations.kept()) {
    const std::string item = fmt::format("{} {} {}", shown == 0 ? ":" : ";", violation.field, violation.description);
    bytes += encoded_size(item);
    if (bytes > kMostMessageBytes) break;
    text += item;
    ++shown;
  }
  if (shown < violations.count()) text += fmt::format("; and {} more", violations.count() - shown);
  return text;
}

google::rpc::BadRequest bad_request(const Violations& violations) {
  google::rpc::BadRequest request;
  std::size_t bytes = 0;
  for (const FieldViolation& violation : violations.kept()) {
    bytes += violation.field.size() + violation.description.size() + kFramingBytes;
    if (bytes > kMostDetailBytes) break;
    auto& added = *request.add_field_violations();
    added.set_field(violation.field);
    added.set_description(violation.description);
  }
  return request;
}

}  // namespace

grpc::Status invalid_argument(const Violations& violations) {
  google::rpc::ErrorInfo info = error_info("INVALID_REQUEST");
  (*info.mutable_metadata())["violation_count"] = std::to_string(violations.count());
  return status(grpc::StatusCode::INVALID_ARGUMENT, listing(violations), headline(violations), bad_request(violations),
                info);
}

grpc::Status malformed_request(std::string_view type) {
  const std::string message = fmt::format(
      "the request is not a {} in protobuf's binary encoding: build it from the proto files of this version", type);
  return status(grpc::StatusCode::INVALID_ARGUMENT, message, message, error_info("MALFORMED_REQUEST"));
}

grpc::Status too_many_calls(int most_calls) {
  return exhausted(fmt::format("this token has {} calls at once, and no more are allowed", most_calls),
                   "TOO_MANY_CALLS", kRetryDelay);
}

grpc::Status unauthenticated(std::string_view reason) {
  const std::string message =
      "this server asks for a token: send the metadata 'authorization: Bearer TOKEN' with one that it knows";
  return status(grpc::StatusCode::UNAUTHENTICATED, message, message, error_info(reason));
}

grpc::Status overloaded() { return exhausted("all workers are busy and the queue is full", "QUEUE_FULL", kRetryDelay); }

grpc::Status searches_overloaded() {
  return exhausted(
      "the problem needs a search, as the quick methods gave no plan; all searches are busy and their queue is full",
      "SEARCH_QUEUE_FULL", kSearchRetryDelay);
}

grpc::Status too_many_streams() {
  return exhausted("as many streams are open as this server allows", "TOO_MANY_STREAMS", kStreamRetryDelay);
}

grpc::Status batch_too_long(std::size_t most) {
  const std::string message = fmt::format("a batch has at most {} requests: open another stream", most);
  return status(grpc::StatusCode::RESOURCE_EXHAUSTED, message, message, error_info("BATCH_TOO_LONG"));
}

grpc::Status draining() {
  const std::string message = "the server stops: send the requests that have no answer to another, or here again later";
  return status(grpc::StatusCode::UNAVAILABLE, message, message, error_info("DRAINING"));
}

grpc::Status out_of_time(std::string_view what, std::string_view remedy) {
  const std::string message =
      fmt::format("{} was not ready within the deadline and the server's longest computation of one call: ask for {}",
                  what, remedy);
  return status(grpc::StatusCode::DEADLINE_EXCEEDED, message, message, error_info("OUT_OF_TIME"));
}

grpc::Status cancelled() {
  const std::string message = "the caller no longer waits for the answer";
  return status(grpc::StatusCode::CANCELLED, message, message, error_info("CANCELLED"));
}

grpc::Status internal_error(const std::string& id) {
  google::rpc::ErrorInfo info = error_info("BUG");
  (*info.mutable_metadata())["id"] = id;
  const std::string message = fmt::format("a bug of dualarm-server; its log holds the request under the id {}", id);
  return status(grpc::StatusCode::INTERNAL, message, message, info);
}

}  // namespace dualarm
