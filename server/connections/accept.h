#pragma once

namespace dualarm {

/// Prepares the process for more connections than it has files for. gRPC 1.51 stops listening for ever when accept4
/// says that no file is free, so that whoever opens connections enough makes the server deaf. From now on the process
/// may open as many files as the system allows it at all, and where these are used up connections are closed as soon as
/// they are accepted, until there are files again. Harmless to call again.
void survive_many_connections();

}  // namespace dualarm
