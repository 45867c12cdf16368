#pragma once

#include <google/protobuf/message.h>

#include <mutex>
#include <string>
#include <string_view>

namespace dualarm {

/// A folder of requests that met a bug, each as a scenario file that the command line runs again:
/// "PlanMotion-<id>.json" for `dualarm plan`. Holds `limit` files: the first ones stay, later ones are not kept, so
/// that nobody can flush the evidence out or fill the disk. Files are for the server's user alone (0600), and nothing
/// of a request is in a name.
class ReplayFolder {
 public:
  /// Makes the folder (0700) where there is none. Throws std::runtime_error where it cannot.
  ReplayFolder(const std::string& path, int limit);

  /// Writes the request, of PlanMotionStream and PlanMotionBatch the one inside. Returns the file's path, or "" where
  /// the folder is full or cannot be written. `rpc` and `id` are ours: letters and digits.
  std::string keep(std::string_view rpc, const std::string& id, const google::protobuf::Message& request);

 private:
  std::mutex mutex_;
  std::string path_;
  int limit_;
};

/// What is wrong with a folder that is to hold replays, "" if nothing is; one that is not there yet is fine where it
/// can be made.
std::string complaint_about_folder(const std::string& path);

}  // namespace dualarm
