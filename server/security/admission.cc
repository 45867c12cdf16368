#include "server/security/admission.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "server/errors.h"

namespace dualarm {
namespace {

constexpr std::string_view kScheme = "bearer ";

/// The scheme's name in any case (RFC 9110, 11.1).
bool names_scheme(std::string_view authorization) {
  const std::string_view name = authorization.substr(0, kScheme.size());
  return std::equal(name.begin(), name.end(), kScheme.begin(), kScheme.end(),
                    [](unsigned char given, char wanted) { return std::tolower(given) == wanted; });
}

}  // namespace

void Admission::set_tokens(TokenTable tokens) {
  auto replacement = std::make_shared<const TokenTable>(std::move(tokens));
  const std::lock_guard lock(mutex_);
  tokens_ = std::move(replacement);
}

Admission::Entrance Admission::enter(const void* call, std::string_view authorization) {
  std::shared_ptr<const TokenTable> tokens;
  {
    const std::lock_guard lock(mutex_);
    tokens = tokens_;
  }
  if (tokens == nullptr) return {};
  const bool bearer = names_scheme(authorization);
  const TokenTable::Entry* entry = bearer ? tokens->find(authorization.substr(kScheme.size())) : nullptr;
  Entrance entrance = {
      entry != nullptr ? grpc::Status::OK : unauthenticated(bearer ? "TOKEN_UNKNOWN" : "TOKEN_MISSING"),
      entry != nullptr ? entry->name : ""};
  const std::lock_guard lock(mutex_);
  if (entry != nullptr) {
    int& calls = calls_[entry->name];
    calls < entry->most_calls ? void(++calls) : void(entrance.status = too_many_calls(entry->most_calls));
  }
  return entered_[call] = std::move(entrance);
}

grpc::Status Admission::status_of(const void* call) const {
  const std::lock_guard lock(mutex_);
  if (tokens_ == nullptr) return grpc::Status::OK;
  const auto entered = entered_.find(call);
  return entered == entered_.end() ? unauthenticated("TOKEN_MISSING") : entered->second.status;
}

void Admission::leave(const void* call) {
  const std::lock_guard lock(mutex_);
  const auto entered = entered_.find(call);
  if (entered == entered_.end()) return;
  if (entered->second.status.ok()) {
    const auto calls = calls_.find(entered->second.caller);
    if (--calls->second == 0) calls_.erase(calls);
  }
  entered_.erase(entered);
}

}  // namespace dualarm
