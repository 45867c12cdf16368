#include "tests/architecture/include_rules.h"

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace dualarm {
namespace {

using Rooms = std::set<std::string, std::less<>>;

// Room -> the other rooms it may include. Tests may look at everything and are not in the table.
const std::map<std::string, Rooms, std::less<>>& arrows() {
  static const std::map<std::string, Rooms, std::less<>> kArrows = {
      {"proto", {}},
      {"geometry", {}},
      {"core/model", {"geometry"}},
      {"core/phase_plane", {"geometry", "core/model"}},
      {"core/systems", {"core/model", "core/phase_plane"}},
      {"core/coordination", {"geometry", "core/model", "core/phase_plane"}},
      {"core/passage", {"geometry", "core/model", "core/phase_plane", "core/systems", "core/coordination"}},
      {"core/verification", {"geometry", "core/model"}},
      {"core/fallback", {"geometry", "core/model", "core/phase_plane"}},
      {"core",
       {"geometry", "core/model", "core/phase_plane", "core/systems", "core/coordination", "core/passage",
        "core/verification", "core/fallback"}},
      {"server/logging", {"proto", "server"}},
      {"server/metrics", {"proto", "server", "server/logging"}},
      {"server/pools", {"server"}},
      {"server/connections", {}},
      {"server/request", {"proto", "server", "core", "core/model"}},
      {"server/response", {"proto", "server", "core", "core/model", "core/coordination", "core/verification"}},
      {"server/security", {"proto", "server", "server/calls"}},
      {"server/calls",
       {"proto", "server", "server/request", "server/response", "server/logging", "server/metrics", "server/pools",
        "server/security", "core", "core/model"}},
      {"server",
       {"proto", "server/request", "server/response", "server/calls", "server/pools", "server/connections",
        "server/security", "server/logging", "server/metrics", "core", "core/model", "core/phase_plane", "core/systems",
        "core/coordination", "core/passage", "core/verification", "core/fallback"}},
      {"clients", {"proto"}},
      {"tests", {}},
  };
  return kArrows;
}

struct ForeignLibrary {
  std::string_view prefix;               // of the include's target
  std::vector<std::string_view> places;  // folders or files that may include it, besides tests
};

const std::vector<ForeignLibrary>& foreign_libraries() {
  static const std::vector<ForeignLibrary> kLibraries = {
      {"Eigen/", {"geometry/", "core/"}},
      {"fcl/", {"geometry/clearance.cc"}},
      {"ccd/", {"geometry/clearance.cc"}},
      {"ompl/", {"core/fallback/"}},
      {"boost/", {"geometry/", "core/"}},
      {"google/protobuf/", {"proto/", "server/", "clients/"}},
      {"grpc/", {"proto/", "server/", "clients/"}},
      {"grpcpp/", {"proto/", "server/", "clients/"}},
      {"CLI/", {"server/", "clients/"}},
      {"spdlog/", {"server/logging/", "server/connections/", "server/main.cc", "server/planning_server.cc"}},
      {"fmt/", {"server/", "clients/"}},
      {"prometheus/", {"server/metrics/"}},
      {"openssl/", {"server/security/"}},
      {"gtest/", {}},
      {"gmock/", {}},
  };
  return kLibraries;
}

// Generated from proto/ into the build folder, so their paths do not begin with "proto/".
constexpr std::array<std::string_view, 3> kGeneratedByProto = {"dualarm/", "google/rpc/", "grpc/health/"};

bool begins_any(std::string_view text, const auto& prefixes) {
  return std::any_of(std::begin(prefixes), std::end(prefixes), [&](std::string_view p) { return text.starts_with(p); });
}

// "<vector>" has neither folder nor suffix; "<unistd.h>" and "<sys/wait.h>" belong to the operating system.
bool is_standard(std::string_view target) { return target.find_first_of("/.") == std::string_view::npos; }
bool is_system(std::string_view target) {
  constexpr std::array<std::string_view, 2> kFolders = {"sys/", "netinet/"};
  return target.ends_with(".h") && (target.find('/') == std::string_view::npos || begins_any(target, kFolders));
}

// Each judge answers with the reason against the include, or with nothing.
std::string judge_project_include(const std::string& room, std::string_view target) {
  const std::string other = begins_any(target, kGeneratedByProto) ? "proto" : room_of(target);
  if (other.empty()) return "it names no room: include from the project's root";
  if (other == room || arrows().at(room).contains(other)) return "";
  return room + " may not look at " + other;
}

std::string judge_library_include(std::string_view path, const ForeignLibrary& library) {
  if (begins_any(path, library.places)) return "";
  return "the library behind " + std::string(library.prefix) + " has no room here";
}

std::string judge_platform_include(const std::string& room, std::string_view target) {
  if (is_standard(target)) return "";
  if (!is_system(target)) return "the library is not in the table of tests/architecture/include_rules.cc";
  const bool may_speak = room == "clients" || room == "server" || room.starts_with("server/");
  return may_speak ? "" : "only server and clients speak to the operating system";
}

std::string judge(std::string_view path, char quote, std::string_view target) {
  const std::string room = room_of(path);
  if (room.empty()) return "the file lies in no room";
  const auto& libraries = foreign_libraries();
  const auto library = std::find_if(libraries.begin(), libraries.end(),
                                    [&](const auto& candidate) { return target.starts_with(candidate.prefix); });
  if (library != libraries.end()) return judge_library_include(path, *library);
  const bool of_project = quote == '"' || begins_any(target, kGeneratedByProto);
  return of_project ? judge_project_include(room, target) : judge_platform_include(room, target);
}

}  // namespace

std::string room_of(std::string_view path) {
  std::string best;
  for (const auto& [room, unused] : arrows()) {
    if (path.starts_with(room + "/") && room.size() > best.size()) best = room;
  }
  return best;
}

std::vector<ForbiddenInclude> forbidden_includes(std::string_view path, std::string_view text) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*([<"]?)([^>"]*)[>"]?.*)re");
  if (room_of(path) == "tests") return {};
  std::vector<ForbiddenInclude> found;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (!std::regex_match(line, match, kInclude)) continue;
    const std::string target = match[2];
    std::string because =
        match[1].length() == 0 ? "an include by macro hides its arrow" : judge(path, line[match.position(1)], target);
    if (!because.empty()) found.push_back({number, target, std::move(because)});
  }
  return found;
}

}  // namespace dualarm
