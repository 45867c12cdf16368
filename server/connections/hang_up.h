#pragma once

#include <string>

namespace dualarm {

/// Ends, as if the process had died, the listening socket of this process and then every connection that was accepted
/// on it: whoever waits there for an answer gets UNAVAILABLE. `listen` is what was listened on ("unix:PATH" or
/// HOST:PORT), `port` the TCP port that was bound.
///
/// For the last moment of a drain. gRPC's own Shutdown answers CANCELLED to calls that arrive before its clients have
/// heard of it, and that is no code on which clients try again elsewhere.
void hang_up(const std::string& listen, int port);

}  // namespace dualarm
