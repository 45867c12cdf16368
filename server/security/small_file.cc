#include "server/security/small_file.h"

#include <fstream>

namespace dualarm {
namespace {

constexpr std::size_t kMostBytes = 1 << 20;  // a certificate chain has some kilobytes

}  // namespace

std::optional<std::string> small_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text(kMostBytes, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream.eof()) return std::nullopt;
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

}  // namespace dualarm
