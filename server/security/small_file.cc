#include "server/security/small_file.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace dualarm {
namespace {

constexpr std::size_t kMostBytes = 1 << 20;  // a certificate chain has some kilobytes

}  // namespace

std::optional<std::string> small_file(const std::string& path) {
  // A pipe would keep the server waiting for somebody to write into it.
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  std::string text(kMostBytes, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream.eof()) return std::nullopt;
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

}  // namespace dualarm
