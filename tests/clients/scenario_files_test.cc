// The files of scenarios/ are requests, and the README there names each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "clients/cpp/json_file.h"
#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {
namespace {

namespace fs = std::filesystem;
using planning::v1::PlanMotionRequest;
using ::testing::HasSubstr;

std::vector<fs::path> scenario_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(DUALARM_SOURCE_DIR) / "scenarios")) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  return files;
}

TEST(Scenarios, AreAllThere) {
  for (const char* name : {"paper_case1", "paper_case2", "paper_case3", "paper_retreat", "paper_object", "carried_box",
                           "box_wall", "cylinder_post", "conveyor", "portrait_paper", "moving_start", "torque_speed",
                           "weak_swing", "tower_cranes", "wipers"}) {
    EXPECT_TRUE(fs::exists(fs::path(DUALARM_SOURCE_DIR) / "scenarios" / (std::string(name) + ".json"))) << name;
  }
}

TEST(Scenarios, AreRequestsForTwoArmsWithATaskEach) {
  for (const fs::path& file : scenario_files()) {
    SCOPED_TRACE(file);
    PlanMotionRequest request;
    ASSERT_NO_THROW(read_json(file.string(), request));
    ASSERT_EQ(request.robot().arms_size(), 2);
    ASSERT_EQ(request.tasks_size(), 2);
    for (int k = 0; k < 2; ++k) EXPECT_EQ(request.tasks(k).arm(), request.robot().arms(k).name());
  }
}

TEST(Scenarios, AreNamedInTheReadme) {
  std::ifstream stream(fs::path(DUALARM_SOURCE_DIR) / "scenarios" / "README.md");
  const std::string readme{std::istreambuf_iterator<char>(stream), {}};
  for (const fs::path& file : scenario_files()) EXPECT_THAT(readme, HasSubstr(file.filename().string()));
}

}  // namespace
}  // namespace dualarm
