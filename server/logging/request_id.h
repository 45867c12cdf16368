#pragma once

#include <string>
#include <string_view>

namespace dualarm {

/// Metadata key under which a caller may name a call, and under which every answer's trailing metadata repeats the
/// name.
inline constexpr char kRequestIdKey[] = "x-request-id";

/// True for 1 to 64 characters of A-Z a-z 0-9 . _ : / + = -, so that a name can neither forge nor flood the log.
bool is_request_id(std::string_view text);

/// 16 random hexadecimal digits.
std::string new_request_id();

/// `wanted` where it is one, else a new one.
std::string request_id_or_new(std::string_view wanted);

}  // namespace dualarm
