#include "clients/cpp/batch_requests.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "clients/cpp/command_error.h"
#include "clients/cpp/json_file.h"

namespace dualarm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 48;  // of the 64 characters of an id: room for a number

std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path().string());
  }
  if (files.empty()) throw CommandError(ExitStatus::kInvalid, folder.string() + ": holds no *.json");
  std::sort(files.begin(), files.end());
  return files;
}

BatchRequest request_of(const std::string& id, const std::string& path, const auto& text) {
  planning::v1::PlanMotionBatchRequest request;
  request.set_request_id(id);
  try {
    parse_json(path, text(), *request.mutable_request());
  } catch (const CommandError& error) {
    return UnreadableRequest{id, error.what()};
  }
  return request;
}

}  // namespace

BatchRequests::BatchRequests(const std::vector<std::string>& sources) {
  for (const std::string& source : sources) {
    std::error_code no_folder;
    if (source != "-" && fs::is_directory(source, no_folder)) {
      const auto files = files_in(source);
      paths_.insert(paths_.end(), files.begin(), files.end());
    } else {
      paths_.push_back(source);
    }
  }
}

std::optional<BatchRequest> BatchRequests::next() {
  while (next_path_ < paths_.size()) {
    const std::string& path = paths_[next_path_];
    if (path == "-") {
      if (auto line = next_line()) return line;
      ++next_path_;
      continue;
    }
    ++next_path_;
    return request_of(unique_id(name_of_file(path)), path, [&path] { return read_text(path); });
  }
  return std::nullopt;
}

std::optional<BatchRequest> BatchRequests::next_line() {
  for (std::string line; std::getline(std::cin, line);) {
    ++line_number_;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::string name = "line " + std::to_string(line_number_);
    return request_of(unique_id(name), "stdin, " + name, [&line] { return line; });
  }
  return std::nullopt;
}

std::string BatchRequests::unique_id(const std::string& name) {
  std::string id = name.substr(0, kLongestName);
  std::replace_if(
      id.begin(), id.end(), [](char character) { return character < ' ' || character > '~'; }, '?');
  const int use = ++uses_[id];
  return use == 1 ? id : id + " #" + std::to_string(use);
}

}  // namespace dualarm
