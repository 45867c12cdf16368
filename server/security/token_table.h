#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace dualarm {

/// SHA-256 of a token. Tokens themselves are forgotten as soon as they are read.
using TokenDigest = std::array<unsigned char, 32>;

TokenDigest digest_of(std::string_view token);

/// Who may call. One line of the file for each caller, "#" begins a comment:
///   NAME TOKEN [CALLS]
/// NAME is what the log calls the caller (1 to 64 characters of A-Z a-z 0-9 . _ -, distinct); TOKEN is at least 16
/// printable characters, or "sha256:" and the digest of the token in 64 hexadecimal digits, so that the file need not
/// hold it; CALLS is how many calls the caller may have at once, 1 to 1,000,000, where the server's default does not
/// do.
class TokenTable {
 public:
  struct Entry {
    std::string name;
    TokenDigest digest;
    int most_calls;
  };

  /// The table, or what is wrong with the text: line numbers, never a token.
  static std::variant<TokenTable, std::string> parse(std::string_view text, int default_most_calls);

  /// The caller whose token this is, or null. Takes equally long for every wrong token: digests are compared, each with
  /// every entry, in constant time (CRYPTO_memcmp).
  const Entry* find(std::string_view token) const;

  std::size_t size() const { return entries_.size(); }

 private:
  std::vector<Entry> entries_;
};

/// The table in a file, or what is wrong with it.
std::variant<TokenTable, std::string> read_tokens(const std::string& file, int default_most_calls);

}  // namespace dualarm
