#include "clients/cpp/json_file.h"

#include <google/protobuf/util/json_util.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>

#include "clients/cpp/command_error.h"

namespace dualarm {
namespace {

std::string text_from(std::istream& stream) { return {std::istreambuf_iterator<char>(stream), {}}; }

std::string text_of(const google::protobuf::Message& message, const google::protobuf::util::JsonPrintOptions& options) {
  std::string text;
  const auto status = google::protobuf::util::MessageToJsonString(message, &text, options);
  if (!status.ok()) throw CommandError(ExitStatus::kFailure, "the answer has no JSON form: " + status.ToString());
  return text;
}

[[noreturn]] void complain(const std::string& path, const std::string& problem) {
  throw CommandError(ExitStatus::kInvalid, shown_path(path) + ": " + problem);
}

}  // namespace

std::string shown_path(const std::string& path) { return path == "-" ? "stdin" : path; }

std::string name_of_file(const std::string& path) {
  return path == "-" ? shown_path(path) : std::filesystem::path(path).stem().string();
}

std::string read_text(const std::string& path) {
  std::error_code no_folder;
  if (path != "-" && std::filesystem::is_directory(path, no_folder))
    complain(path, "cannot be read: it is a directory");
  std::string text;
  if (path == "-") {
    text = text_from(std::cin);
  } else {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) complain(path, "cannot be read: " + std::generic_category().message(errno));
    text = text_from(stream);
  }
  if (text.empty()) complain(path, "is empty");
  return text;
}

void read_json(const std::string& path, google::protobuf::Message& message) {
  parse_json(path, read_text(path), message);
}

bool is_json_of(const std::string& text, google::protobuf::Message& message) {
  return google::protobuf::util::JsonStringToMessage(text, &message).ok();
}

void parse_json(const std::string& path, const std::string& text, google::protobuf::Message& message) {
  const auto status = google::protobuf::util::JsonStringToMessage(text, &message);
  if (status.ok()) return;
  complain(path,
           "is not the JSON form of " + message.GetDescriptor()->full_name() + ": " + std::string(status.message()));
}

std::string json_of(const google::protobuf::Message& message) {
  google::protobuf::util::JsonPrintOptions options;
  options.add_whitespace = true;
  options.always_print_primitive_fields = true;
  return text_of(message, options);
}

std::string json_line_of(const google::protobuf::Message& message) { return text_of(message, {}) + "\n"; }

void write_text(const std::string& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw CommandError(ExitStatus::kFailure, path + ": cannot be written");
}

}  // namespace dualarm
