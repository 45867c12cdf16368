#pragma once

#include <google/protobuf/message.h>

#include <random>

namespace dualarm {

/// Changes one thing somewhere in a message: sets, clears, scales or spoils a field, adds, drops or swaps elements.
/// What comes out is always a message, so that a fuzzer gets past the decoder; bytes are its own business.
void mutate(google::protobuf::Message& message, std::mt19937_64& engine);

}  // namespace dualarm
