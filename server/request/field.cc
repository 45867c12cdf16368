#include "server/request/field.h"

#include <fmt/format.h>

#include <utility>

namespace dualarm {
namespace {

bool is_printable(char character) { return character >= ' ' && character <= '~'; }

std::string described(const Range& range) {
  const std::string unit = range.unit.empty() ? "" : fmt::format(" {}", range.unit);
  return fmt::format("{} to {}{}", range.min, range.max, unit);
}

}  // namespace

std::string Field::path_to(std::string_view name) const {
  return path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name);
}

Field Field::child(std::string_view name) const { return {path_to(name), *violations_, *limits_}; }

Field Field::child(std::string_view name, int index) const {
  return {fmt::format("{}[{}]", path_to(name), index), *violations_, *limits_};
}

void Field::complain(std::string description) const { violations_->add({path_, std::move(description)}); }

void Field::complain(std::string_view name, std::string description) const {
  violations_->add({path_to(name), std::move(description)});
}

void Field::complain_missing(std::string_view name, std::string_view remedy) const {
  complain(name, fmt::format("is missing: {}", remedy));
}

double Field::number(std::string_view name, double value, const Range& range) const {
  if (!range.contains(value)) {
    complain(name, fmt::format("is {}, must be {}", value, described(range)));
  }
  return value;
}

std::string quoted(std::string_view text) {
  std::string shown;
  for (const char character : text.substr(0, ranges::kLongestName)) shown += is_printable(character) ? character : '?';
  return text.size() > ranges::kLongestName ? fmt::format("'{}...'", shown) : fmt::format("'{}'", shown);
}

}  // namespace dualarm
