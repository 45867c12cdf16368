#include "clients/cpp/json_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "clients/cpp/command_error.h"
#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {
namespace {

using planning::v1::PlanMotionRequest;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string file_with(const std::string& text) {
  const std::string path = ::testing::TempDir() + "json_file_test." + std::to_string(getpid()) + ".json";
  write_text(path, text);
  return path;
}

std::string complaint_about(const std::string& path) {
  PlanMotionRequest request;
  try {
    read_json(path, request);
  } catch (const CommandError& error) {
    EXPECT_EQ(error.status(), ExitStatus::kInvalid);
    return error.what();
  }
  return "";
}

TEST(ReadJson, ReadsWhatJsonOfWrote) {
  PlanMotionRequest request;
  request.mutable_robot()->add_arms()->mutable_dynamics()->set_moment_of_inertia_kg_m2(0.1);
  request.mutable_options()->set_clearance_m(1.0 / 3.0);
  const std::string path = file_with(json_of(request));
  PlanMotionRequest read;
  read_json(path, read);
  EXPECT_EQ(read.SerializeAsString(), request.SerializeAsString());
}

TEST(ReadJson, NamesTheFileAndTheProblem) {
  const std::string broken = file_with("{\"robot\": ");
  EXPECT_THAT(complaint_about(broken), AllOf(HasSubstr(broken), HasSubstr("PlanMotionRequest")));
  EXPECT_THAT(complaint_about(file_with("{\"robto\": {}}")), HasSubstr("robto"));
  EXPECT_THAT(complaint_about("/nowhere/at/all.json"), HasSubstr("/nowhere/at/all.json: cannot be read"));
  EXPECT_THAT(complaint_about(::testing::TempDir()), HasSubstr("it is a directory"));
  EXPECT_THAT(complaint_about(file_with("")), HasSubstr("is empty"));
}

TEST(WriteText, SaysWhichFileItCannotWrite) {
  try {
    write_text("/nowhere/at/all.json", "text");
    FAIL() << "wrote into a folder that does not exist";
  } catch (const CommandError& error) {
    EXPECT_EQ(error.status(), ExitStatus::kFailure);
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/at/all.json"));
  }
}

}  // namespace
}  // namespace dualarm
