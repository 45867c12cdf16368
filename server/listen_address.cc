#include "server/listen_address.h"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <charconv>
#include <cstring>
#include <string_view>

namespace dualarm {
namespace {

constexpr std::string_view kUnixScheme = "unix:";
constexpr int kLargestPort = 65535;

bool is_port(std::string_view text) {
  int port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  return error == std::errc() && end == text.data() + text.size() && port >= 0 && port <= kLargestPort;
}

bool is_host_and_port(std::string_view address) {
  const std::size_t colon = address.rfind(':');
  if (colon == std::string_view::npos || colon == 0) return false;
  const std::string_view host = address.substr(0, colon);
  const bool bracketed = host.front() == '[' && host.back() == ']';
  return (bracketed || host.find(':') == std::string_view::npos) && is_port(address.substr(colon + 1));
}

}  // namespace

std::string complaint_about_address(const std::string& address) {
  if (is_unix_address(address) ? address.size() > kUnixScheme.size() : is_host_and_port(address)) return "";
  return fmt::format(
      "'{}' is no address: give HOST:PORT with a port of 0 to {}, such as 127.0.0.1:50051 or [::1]:50051, or unix:PATH",
      address, kLargestPort);
}

bool is_unix_address(const std::string& address) { return address.starts_with(kUnixScheme); }

bool is_local_address(const std::string& address) {
  const std::string_view host = std::string_view(address).substr(0, address.rfind(':'));
  const bool numeric = host.find_first_not_of("0123456789.") == std::string_view::npos;  // not 127.example.com
  return is_unix_address(address) || host == "localhost" || host == "[::1]" || (host.starts_with("127.") && numeric);
}

bool is_unix_address_taken(const std::string& address) {
  std::string path = address.substr(kUnixScheme.size());
  if (path.starts_with("//")) path.erase(0, 2);
  sockaddr_un name = {};
  name.sun_family = AF_UNIX;
  if (path.size() >= sizeof(name.sun_path)) return false;  // gRPC refuses it
  std::memcpy(name.sun_path, path.data(), path.size());
  const int probe = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (probe < 0) return false;
  const bool taken = connect(probe, reinterpret_cast<const sockaddr*>(&name), sizeof(name)) == 0;
  close(probe);
  return taken;
}

std::string bound_address(const std::string& address, int port) {
  const std::size_t colon = address.rfind(':');
  if (is_unix_address(address) || colon == std::string::npos) return address;
  return address.substr(0, colon + 1) + std::to_string(port);
}

}  // namespace dualarm
