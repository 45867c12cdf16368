#include "server/logging/request_id.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <cstdint>

namespace dualarm {
namespace {

constexpr std::size_t kLongestId = 64;
constexpr std::string_view kPunctuation = "._:/+=-";

bool is_allowed(char character) {
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
         (character >= '0' && character <= '9') || kPunctuation.find(character) != std::string_view::npos;
}

}  // namespace

bool is_request_id(std::string_view text) {
  return !text.empty() && text.size() <= kLongestId && std::all_of(text.begin(), text.end(), is_allowed);
}

std::string new_request_id() {
  std::uint64_t bits = 0;
  while (getrandom(&bits, sizeof bits, 0) != static_cast<ssize_t>(sizeof bits)) {
  }
  return fmt::format("{:016x}", bits);
}

std::string request_id_or_new(std::string_view wanted) {
  return is_request_id(wanted) ? std::string(wanted) : new_request_id();
}

}  // namespace dualarm
