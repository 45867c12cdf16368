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

std::string Field::path() const {
  std::string path = parent_ == nullptr ? "" : parent_->path();
  if (!path.empty() && !name_.empty()) path += '.';
  path += name_;
  if (index_ != kNoIndex) path += fmt::format("[{}]", index_);
  return path;
}

Field Field::child(std::string_view name) const { return child(name, kNoIndex); }

Field Field::child(std::string_view name, int index) const { return {this, name, index, violations_, limits_}; }

void Field::complain(std::string description) const { violations_.add({path(), std::move(description)}); }

void Field::complain(std::string_view name, std::string description) const {
  child(name).complain(std::move(description));
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
