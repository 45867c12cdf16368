// Messages in protobuf's JSON form, from and to files.
#pragma once

#include <google/protobuf/message.h>

#include <string>

namespace dualarm {

/// The file at `path`, or stdin where it is "-". Throws CommandError(kInvalid) that names the file and the problem: no
/// such file, a folder, empty.
std::string read_text(const std::string& path);

/// `path` as people know it: "stdin" for "-".
std::string shown_path(const std::string& path);

/// What the file at `path` is called in answers: its name without folder and ending; "stdin" for "-".
std::string name_of_file(const std::string& path);

/// Reads one message from `text`, which came from `path`. Throws CommandError(kInvalid) that names the file and the
/// problem: not JSON, an unknown field.
void parse_json(const std::string& path, const std::string& text, google::protobuf::Message& message);

/// Reads one message from the file at `path`: read_text() and parse_json().
void read_json(const std::string& path, google::protobuf::Message& message);

/// Whether `text` is the JSON form of such a message, which is then read.
bool is_json_of(const std::string& text, google::protobuf::Message& message);

/// The message as JSON with indentation; fields at their default are printed too. Ends with a newline.
std::string json_of(const google::protobuf::Message& message);

/// The message as JSON on one line, with its newline; fields at their default are left out.
std::string json_line_of(const google::protobuf::Message& message);

/// Writes `text` to the file at `path`. Throws CommandError(kFailure) where that fails.
void write_text(const std::string& path, const std::string& text);

}  // namespace dualarm
