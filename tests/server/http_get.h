#pragma once

#include <string>

namespace dualarm {

/// All that a server at "127.0.0.1:PORT" answers to GET `path` in plain HTTP, headers included; "" where it does not.
std::string http_get(const std::string& address, const std::string& path);

}  // namespace dualarm
