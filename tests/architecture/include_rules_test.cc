// The source tree against the table of arrows, and the table's judge against fabricated offenders.
#include "tests/architecture/include_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace dualarm {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kRooms[] = {"proto", "geometry", "core", "server", "clients"};

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool is_source(const fs::path& file) { return file.extension() == ".h" || file.extension() == ".cc"; }

TEST(Includes, OfEveryFileFollowAnArrowOfTheHouse) {
  const fs::path root(DUALARM_SOURCE_DIR);
  int read = 0;
  for (const char* room : kRooms) {
    ASSERT_TRUE(fs::is_directory(root / room)) << room;
    for (const auto& entry : fs::recursive_directory_iterator(root / room)) {
      if (!entry.is_regular_file() || !is_source(entry.path())) continue;
      ++read;
      const std::string path = fs::relative(entry.path(), root).generic_string();
      for (const auto& [line, target, because] : forbidden_includes(path, text_of(entry.path()))) {
        ADD_FAILURE() << path << ":" << line << ": #include of " << target << ": " << because;
      }
    }
  }
  EXPECT_GE(read, 20) << "the walk found hardly any source: " << root;
}

struct Offender {
  const char* path;
  const char* include;
  const char* because;
};

void PrintTo(const Offender& offender, std::ostream* out) { *out << offender.path << ": " << offender.include; }

class FabricatedOffender : public ::testing::TestWithParam<Offender> {};

TEST_P(FabricatedOffender, IsCaught) {
  const auto& [path, include, because] = GetParam();
  const auto found = forbidden_includes(path, std::string("// The first line.\n") + include + "\n");
  ASSERT_THAT(found, SizeIs(1)) << path << " " << include;
  EXPECT_EQ(found[0].line, 2);
  EXPECT_THAT(found[0].because, HasSubstr(because));
}

INSTANTIATE_TEST_SUITE_P(
    Includes, FabricatedOffender,
    ::testing::Values(
        Offender{"geometry/lens.h", "#include \"core/model/arm.h\"", "may not look at core/model"},
        Offender{"geometry/lens.cc", "#include <fcl/fcl.h>", "no room here"},
        Offender{"core/model/arm.h", "#include \"core/phase_plane/system.h\"", "may not look at core/phase_plane"},
        Offender{"core/phase_plane/profile.h", "#include \"core/systems/single_joint_arm.h\"", "core/systems"},
        Offender{"core/coordination/diagram.cc", "#include \"core/verification/verify.h\"", "core/verification"},
        Offender{"core/verification/verify.cc", "#include \"core/plan.h\"", "may not look at core"},
        Offender{"core/verification/verify.cc", "  #  include \"core/phase_plane/profile.h\"", "core/phase_plane"},
        Offender{"core/coordination/passage.cc", "#include <ompl/base/State.h>", "no room here"},
        Offender{"core/planner.cc", "#include \"dualarm/planning/v1/robot.pb.h\"", "may not look at proto"},
        Offender{"core/planner.cc", "#include <dualarm/planning/v1/robot.pb.h>", "may not look at proto"},
        Offender{"core/planner.cc", "#include \"google/protobuf/message.h\"", "no room here"},
        Offender{"core/planner.cc", "#include \"server/options.h\"", "may not look at server"},
        Offender{"core/planner.cc", "#include <unistd.h>", "operating system"},
        Offender{"core/planner.cc", "#include \"plan.h\"", "names no room"},
        Offender{"core/planner.cc", "#include PLAN_HEADER", "by macro"},
        Offender{"core/planner.cc", "#include <json/json.h>", "not in the table"},
        Offender{"clients/cpp/plan_table.cc", "#include \"core/plan.h\"", "may not look at core"},
        Offender{"clients/cpp/plan_table.cc", "#include \"geometry/lens.h\"", "may not look at geometry"},
        Offender{"clients/cpp/plan_table.cc", "#include \"server/options.h\"", "may not look at server"},
        Offender{"server/main.cc", "#include \"clients/cpp/channel.h\"", "may not look at clients"},
        Offender{"server/main.cc", "#include \"geometry/lens.h\"", "may not look at geometry"},
        Offender{"server/main.cc", "#include \"tests/support/scenes.h\"", "may not look at tests"},
        Offender{"server/main.cc", "#include <gtest/gtest.h>", "no room here"},
        Offender{"server/logging/logs.cc", "#include \"server/calls/caller.h\"", "may not look at server/calls"},
        Offender{"server/metrics/metrics.cc", "#include \"core/plan.h\"", "may not look at core"},
        Offender{"server/request/scene.cc", "#include \"server/calls/answer.h\"", "may not look at server/calls"},
        Offender{"server/calls/caller.cc", "#include <spdlog/spdlog.h>", "no room here"},
        Offender{"server/calls/call_observer.cc", "#include <prometheus/counter.h>", "no room here"},
        Offender{"server/options.cc", "#include <openssl/x509.h>", "no room here"},
        Offender{"attic/old.cc", "#include \"core/plan.h\"", "no room"}));

TEST(Includes, AlongAnArrowAreLeftInPeace) {
  EXPECT_THAT(forbidden_includes("geometry/clearance.cc", "#include <fcl/fcl.h>\n#include \"geometry/body.h\""),
              IsEmpty());
  EXPECT_THAT(forbidden_includes("core/fallback/search.cc", "#include <ompl/base/State.h>\n"), IsEmpty());
  EXPECT_THAT(forbidden_includes("core/plan.h", "#include \"core/verification/verify.h\"\n"), IsEmpty());
  EXPECT_THAT(forbidden_includes("server/main.cc", "#include <grpcpp/grpcpp.h>\n#include <signal.h>"), IsEmpty());
  EXPECT_THAT(forbidden_includes("server/pools/worker_pool.cc", "#include <sys/resource.h>"), IsEmpty());
  EXPECT_THAT(forbidden_includes("clients/cpp/main.cc", "#include <CLI/CLI.hpp>\n#include <sys/prctl.h>"), IsEmpty());
  EXPECT_THAT(forbidden_includes("tests/core/plan_test.cc", "#include \"server/options.h\""), IsEmpty());
}

TEST(Room, IsTheDeepestFolderOfTheTable) {
  EXPECT_EQ(room_of("core/plan.h"), "core");
  EXPECT_EQ(room_of("core/model/arm.h"), "core/model");
  EXPECT_EQ(room_of("core/modelling.h"), "core");
  EXPECT_EQ(room_of("corella/plan.h"), "");
}

}  // namespace
}  // namespace dualarm
