#include "server/security/token_table.h"

#include <fmt/format.h>
#include <openssl/crypto.h>
#include <openssl/sha.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

#include "server/security/small_file.h"

namespace dualarm {
namespace {

constexpr std::string_view kDigestPrefix = "sha256:";
constexpr std::size_t kShortestToken = 16;  // 80 bits even where only 32 characters are in use
constexpr std::size_t kLongestName = 64;
constexpr int kMostCalls = 1'000'000;

bool is_name(std::string_view name) {
  constexpr std::string_view kPunctuation = "._-";
  return !name.empty() && name.size() <= kLongestName && std::all_of(name.begin(), name.end(), [&](unsigned char c) {
    return std::isalnum(c) != 0 || kPunctuation.find(static_cast<char>(c)) != std::string_view::npos;
  });
}

template <typename Number>
std::optional<Number> number(std::string_view text, int base) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::optional<TokenDigest> digest_in_hexadecimal(std::string_view text) {
  TokenDigest digest;
  if (text.size() != 2 * digest.size()) return std::nullopt;
  for (std::size_t i = 0; i < digest.size(); ++i) {
    const auto byte = number<unsigned char>(text.substr(2 * i, 2), 16);
    if (!byte) return std::nullopt;
    digest[i] = *byte;
  }
  return digest;
}

std::optional<TokenDigest> digest_in_file(std::string_view word) {
  if (word.starts_with(kDigestPrefix)) return digest_in_hexadecimal(word.substr(kDigestPrefix.size()));
  const bool printable = std::all_of(word.begin(), word.end(), [](char c) { return c > ' ' && c <= '~'; });
  return word.size() >= kShortestToken && printable ? std::optional(digest_of(word)) : std::nullopt;
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line.substr(0, line.find('#')));
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

// What is wrong with the words of a line; the entry is filled as far as they are right.
std::string read_entry(const std::vector<std::string>& words, TokenTable::Entry& entry) {
  if (words.size() < 2 || words.size() > 3) return "give NAME TOKEN [CALLS]";
  if (!is_name(words[0])) return "a name has 1 to 64 characters of A-Z a-z 0-9 . _ -";
  const auto digest = digest_in_file(words[1]);
  if (!digest) return "a token has at least 16 printable characters, or is sha256: and 64 hexadecimal digits";
  entry.name = words[0];
  entry.digest = *digest;
  if (words.size() == 2) return "";
  const auto calls = number<int>(words[2], 10);
  if (!calls || *calls < 1 || *calls > kMostCalls) return fmt::format("calls at once are 1 to {}", kMostCalls);
  entry.most_calls = *calls;
  return "";
}

}  // namespace

TokenDigest digest_of(std::string_view token) {
  TokenDigest digest;
  SHA256(reinterpret_cast<const unsigned char*>(token.data()), token.size(), digest.data());
  return digest;
}

std::variant<TokenTable, std::string> TokenTable::parse(std::string_view text, int default_most_calls) {
  TokenTable table;
  std::istringstream lines{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::vector<std::string> words = words_of(line);
    if (words.empty()) continue;
    Entry entry{{}, {}, default_most_calls};
    std::string complaint = read_entry(words, entry);
    for (const Entry& other : table.entries_) {
      if (other.name == entry.name) complaint = "the name is taken by a line before";
      if (other.digest == entry.digest) complaint = "the token is taken by a line before";
    }
    if (!complaint.empty()) return fmt::format("line {}: {}", number, complaint);
    table.entries_.push_back(std::move(entry));
  }
  if (table.entries_.empty()) return std::string("it has no tokens, so that nobody could call");
  return table;
}

const TokenTable::Entry* TokenTable::find(std::string_view token) const {
  const TokenDigest presented = digest_of(token);
  const Entry* found = nullptr;
  for (const Entry& entry : entries_) {
    if (CRYPTO_memcmp(entry.digest.data(), presented.data(), presented.size()) == 0) found = &entry;
  }
  return found;
}

std::variant<TokenTable, std::string> read_tokens(const std::string& file, int default_most_calls) {
  const auto text = small_file(file);
  if (!text) return fmt::format("cannot read {}", file);
  auto table = TokenTable::parse(*text, default_most_calls);
  if (auto* complaint = std::get_if<std::string>(&table)) return fmt::format("{}: {}", file, *complaint);
  return table;
}

}  // namespace dualarm
