#pragma once

#include <google/protobuf/util/json_util.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

#include "tests/fuzz/message_mutator.h"

namespace dualarm {

/// Reads a message from protobuf's bytes, or from its JSON where they begin with '{', so that scenarios are inputs,
/// too. False where they are neither.
template <typename Message>
bool read_message(const std::uint8_t* bytes, std::size_t size, Message& message) {
  if (size == 0 || bytes[0] != '{') return message.ParseFromArray(bytes, static_cast<int>(size));
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  return google::protobuf::util::JsonStringToMessage(text, &message).ok();
}

/// What libFuzzer's custom mutator does: a few changes of the message in `bytes`, written back; 0 where it does not
/// fit.
template <typename Message>
std::size_t mutate_bytes(std::uint8_t* bytes, std::size_t size, std::size_t most, unsigned seed) {
  constexpr unsigned kMostChanges = 4;
  Message message;
  if (!read_message(bytes, size, message)) message.Clear();
  std::mt19937_64 engine(seed);
  for (unsigned i = 0; i <= seed % kMostChanges; ++i) mutate(message, engine);
  const std::size_t length = message.ByteSizeLong();
  if (length > most) return 0;
  message.SerializeToArray(bytes, static_cast<int>(length));
  return length;
}

}  // namespace dualarm
