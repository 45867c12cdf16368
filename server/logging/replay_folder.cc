#include "server/logging/replay_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <google/protobuf/util/json_util.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "server/wire.h"

namespace dualarm {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kForOwner = 0700;
constexpr mode_t kReadableByOwner = 0600;

// What of a request the command line reads.
const google::protobuf::Message& scenario_in(const google::protobuf::Message& request) {
  if (const auto* stream = dynamic_cast<const wire::PlanMotionStreamRequest*>(&request)) return stream->request();
  if (const auto* batch = dynamic_cast<const wire::PlanMotionBatchRequest*>(&request)) return batch->request();
  return request;
}

std::ptrdiff_t count_files(const std::string& folder) {
  std::error_code error;
  return std::distance(fs::directory_iterator(folder, error), fs::directory_iterator());
}

bool write_new(const std::string& path, std::string_view text) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kReadableByOwner);
  if (file < 0) return false;
  while (!text.empty()) {
    const ssize_t written = write(file, text.data(), text.size());
    if (written < 0 && errno != EINTR) break;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  close(file);
  if (!text.empty()) unlink(path.c_str());
  return text.empty();
}

}  // namespace

std::string complaint_about_folder(const std::string& path) {
  std::error_code error;
  const bool exists = fs::exists(path, error);
  const std::string parent = fs::absolute(path, error).lexically_normal().parent_path().string();
  if (exists && !fs::is_directory(path, error)) return fmt::format("{} is no folder", path);
  if (access((exists ? path : parent).c_str(), W_OK | X_OK) == 0) return "";
  return fmt::format("cannot write to {}", exists ? path : parent);
}

ReplayFolder::ReplayFolder(const std::string& path, int limit) : path_(path), limit_(limit) {
  if (mkdir(path.c_str(), kForOwner) != 0 && errno != EEXIST) {
    throw std::runtime_error(fmt::format("cannot make {}: {}", path, std::generic_category().message(errno)));
  }
  const std::string complaint = complaint_about_folder(path);
  if (!complaint.empty()) throw std::runtime_error(complaint);
}

std::string ReplayFolder::keep(std::string_view rpc, const std::string& id, const google::protobuf::Message& request) {
  std::string json;
  google::protobuf::util::JsonPrintOptions options;
  options.add_whitespace = true;
  if (!google::protobuf::util::MessageToJsonString(scenario_in(request), &json, options).ok()) return "";
  const std::lock_guard lock(mutex_);
  if (count_files(path_) >= limit_) return "";
  const std::string path = fmt::format("{}/{}-{}.json", path_, rpc, id);
  return write_new(path, json) ? path : "";
}

}  // namespace dualarm
