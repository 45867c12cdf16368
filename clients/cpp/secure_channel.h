// The connection to a server: plaintext or TLS, and the token that is sent along.
#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <string>

#include "clients/cpp/connection_options.h"

namespace dualarm {

/// A channel to `address`, over TLS where options.tls_ca names who signs the server's certificate. Connects with the
/// first call. Throws CommandError(kInvalid) where one of the files cannot be read.
std::shared_ptr<grpc::Channel> open_channel(const std::string& address, const ConnectionOptions& options);

/// The token in options.token_file without the space around it; "" for no file. Throws CommandError(kInvalid) where it
/// cannot be read or holds no token, or where others could read it on its way: to another machine without TLS.
std::string token_for(const ConnectionOptions& options);

}  // namespace dualarm
