#include "clients/cpp/json_file.h"

#include <google/protobuf/util/json_util.h>

#include <fstream>
#include <iostream>
#include <iterator>

#include "clients/cpp/command_error.h"

namespace dualarm {
namespace {

std::string text_from(std::istream& stream) { return {std::istreambuf_iterator<char>(stream), {}}; }

std::string read_text(const std::string& path) {
  if (path == "-") return text_from(std::cin);
  std::ifstream stream(path, std::ios::binary);
  // A folder opens and fails at the first read only.
  if (!stream || stream.peek() == std::ifstream::traits_type::eof()) {
    throw CommandError(ExitStatus::kInvalid, path + ": cannot be read, or is empty");
  }
  return text_from(stream);
}

}  // namespace

void read_json(const std::string& path, google::protobuf::Message& message) {
  const std::string text = read_text(path);
  const auto status = google::protobuf::util::JsonStringToMessage(text, &message);
  if (status.ok()) return;
  const std::string name = path == "-" ? "stdin" : path;
  throw CommandError(ExitStatus::kInvalid, name + ": is not the JSON form of " + message.GetDescriptor()->full_name() +
                                               ": " + std::string(status.message()));
}

std::string json_of(const google::protobuf::Message& message) {
  google::protobuf::util::JsonPrintOptions options;
  options.add_whitespace = true;
  options.always_print_primitive_fields = true;
  std::string text;
  const auto status = google::protobuf::util::MessageToJsonString(message, &text, options);
  if (!status.ok()) throw CommandError(ExitStatus::kFailure, "the answer has no JSON form: " + status.ToString());
  return text;
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw CommandError(ExitStatus::kFailure, path + ": cannot be written");
}

}  // namespace dualarm
