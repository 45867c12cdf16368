// The requests of a batch, from files, folders and stdin, read one at a time.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

/// A request that cannot be sent: no such file, not JSON.
struct UnreadableRequest {
  std::string request_id;
  std::string error;
};

using BatchRequest = std::variant<planning::v1::PlanMotionBatchRequest, UnreadableRequest>;

class BatchRequests {
 public:
  /// `sources`: files of one request each, folders of such files (*.json, by name), or "-": stdin with one request a
  /// line. Throws CommandError(kInvalid) for a folder without such files.
  explicit BatchRequests(const std::vector<std::string>& sources);

  /// The next one, or nothing after the last. Its id is the file's name or "line 7", with a number where the name has
  /// been there before.
  std::optional<BatchRequest> next();

 private:
  std::optional<BatchRequest> next_line();
  std::string unique_id(const std::string& name);

  std::vector<std::string> paths_;
  std::size_t next_path_ = 0;
  int line_number_ = 0;
  std::map<std::string, int> uses_;
};

}  // namespace dualarm
