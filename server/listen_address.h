#pragma once

#include <string>

namespace dualarm {

/// Where a server listens: "HOST:PORT" or "unix:PATH".

/// What is wrong with an address, and what one looks like; "" if it is well-formed. gRPC takes a port beyond 65535
/// modulo 65536, so that a typing error would open another port than the one asked for.
std::string complaint_about_address(const std::string& address);

/// True for addresses that only this machine reaches: unix sockets, localhost, 127.*, [::1].
bool is_local_address(const std::string& address);

/// True for "unix:PATH".
bool is_unix_address(const std::string& address);

/// True if something accepts connections on the socket of "unix:PATH". gRPC replaces a socket file without asking, so
/// that a second server would silently take the place of the first.
bool is_unix_address_taken(const std::string& address);

/// "HOST:PORT" with the port that was bound in place of 0; "unix:PATH" as it is.
std::string bound_address(const std::string& address, int port);

}  // namespace dualarm
