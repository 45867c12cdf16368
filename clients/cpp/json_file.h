// Messages in protobuf's JSON form, from and to files.
#pragma once

#include <google/protobuf/message.h>

#include <string>

namespace dualarm {

/// Reads one message from the file at `path`, or from stdin where it is "-".
/// Throws CommandError(kInvalid) that names the file and the problem: no such file, not JSON, an unknown field.
void read_json(const std::string& path, google::protobuf::Message& message);

/// The message as JSON with indentation; fields at their default are printed too. Ends with a newline.
std::string json_of(const google::protobuf::Message& message);

/// Writes `text` to the file at `path`. Throws CommandError(kFailure) where that fails.
void write_text(const std::string& path, const std::string& text);

}  // namespace dualarm
