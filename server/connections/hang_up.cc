#include "server/connections/hang_up.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

namespace dualarm {
namespace {

constexpr std::string_view kUnixPrefix = "unix:";

std::vector<int> open_files() {
  std::vector<int> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const std::string name = entry.path().filename().string();
    int file = -1;
    if (std::from_chars(name.data(), name.data() + name.size(), file).ec == std::errc()) files.push_back(file);
  }
  return files;
}

// An accepted connection has the local address of the socket that it came by.
bool is_served_at(int file, std::string_view listen, int port) {
  sockaddr_storage address = {};
  socklen_t size = sizeof address;
  if (getsockname(file, reinterpret_cast<sockaddr*>(&address), &size) != 0) return false;
  if (address.ss_family == AF_UNIX) {
    const auto& unix_address = reinterpret_cast<const sockaddr_un&>(address);
    return listen.starts_with(kUnixPrefix) && unix_address.sun_path == listen.substr(kUnixPrefix.size());
  }
  if (listen.starts_with(kUnixPrefix)) return false;
  if (address.ss_family == AF_INET) return ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port) == port;
  return address.ss_family == AF_INET6 && ntohs(reinterpret_cast<const sockaddr_in6&>(address).sin6_port) == port;
}

bool accepts_connections(int file) {
  int accepts = 0;
  socklen_t size = sizeof accepts;
  return getsockopt(file, SOL_SOCKET, SO_ACCEPTCONN, &accepts, &size) == 0 && accepts != 0;
}

}  // namespace

void hang_up(const std::string& listen, int port) {
  for (const bool listeners : {true, false}) {  // in this order: nobody comes in once the others are gone
    for (const int file : open_files()) {
      if (is_served_at(file, listen, port) && accepts_connections(file) == listeners) shutdown(file, SHUT_RDWR);
    }
  }
}

}  // namespace dualarm
