// The real program against the real server: exit statuses, what is on stdout, what is left behind.
#include <gmock/gmock.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <thread>
#include <vector>

#include "clients/cpp/json_file.h"
#include "dualarm/planning/v1/planning_service.pb.h"
#include "tests/clients/program_run.h"
#include "tests/clients/scenarios.h"

namespace dualarm {
namespace {

namespace fs = std::filesystem;
using planning::v1::PlanMotionRequest;
using planning::v1::PlanMotionResponse;
using planning::v1::VerifyMotionResponse;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr auto kPatience = std::chrono::seconds(20);

/// Waits until `holds`; false where it never does.
bool comes_true(const auto& holds) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

/// Seconds of work for the server, so that a signal meets it at work.
std::vector<std::string> long_work() {
  std::vector<std::string> words(30, scenario("paper_retreat"));
  words.insert(words.begin(), "plan");
  return words;
}

bool parses_as(const std::string& text, google::protobuf::Message& message) {
  return google::protobuf::util::JsonStringToMessage(text, &message).ok();
}

class CommandLine : public ::testing::Test {
 protected:
  CommandLine() {
    std::string name = (fs::temp_directory_path() / "command-line-test-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    fs::create_directory(folder_ / "tmp");
  }
  ~CommandLine() override { fs::remove_all(folder_); }

  /// The program gets a TMPDIR of its own, where the private server's folder will be.
  ProgramRun start(std::vector<std::string> arguments, const std::string& input = "") {
    arguments.insert(arguments.begin(), DUALARM_PROGRAM);
    return {arguments, {"TMPDIR=" + tmp()}, folder_.string(), input};
  }
  /// With stdout on a device that is always full.
  ProgramResult run_on_full_disk(const std::string& arguments) {
    const std::string script = "exec " DUALARM_PROGRAM " " + arguments + " > /dev/full";
    return ProgramRun({"/bin/sh", "-c", script}, {"TMPDIR=" + tmp()}, folder_.string(), "").wait();
  }
  ProgramResult run(const std::vector<std::string>& arguments, const std::string& input = "") {
    return start(arguments, input).wait();
  }

  std::string tmp() const { return (folder_ / "tmp").string(); }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  bool tmp_is_empty() const { return fs::is_empty(folder_ / "tmp"); }
  bool server_is_gone() const { return processes_with(tmp()).empty(); }

 private:
  fs::path folder_;
};

TEST_F(CommandLine, PlansWithAPrivateServerAndLeavesNothingBehind) {
  const auto result = run({"plan", scenario("paper_case1")});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  EXPECT_THAT(result.out, StartsWith("paper_case1: a verified plan"));
  EXPECT_THAT(result.err, IsEmpty());
  EXPECT_TRUE(tmp_is_empty());
  EXPECT_TRUE(server_is_gone());
}

TEST_F(CommandLine, PrintsJsonAndNothingElse) {
  const auto result = run({"plan", scenario("paper_case2"), "--json"});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  PlanMotionResponse response;
  ASSERT_TRUE(parses_as(result.out, response)) << result.out.substr(0, 200);
  EXPECT_TRUE(response.plan().verification().collision_free());
}

TEST_F(CommandLine, ReadsTheRequestFromStdin) {
  const auto result = run({"plan", "-"}, json_of(request_of("paper_case1")));
  EXPECT_EQ(result.exit_status, 0) << result.err;
  EXPECT_THAT(result.out, StartsWith("stdin: a verified plan"));
}

TEST_F(CommandLine, EndsWithTwoForWhatIsNoRequest) {
  EXPECT_EQ(run({}).exit_status, 2);
  EXPECT_EQ(run({"plan"}).exit_status, 2);
  EXPECT_EQ(run({"plan", scenario("paper_case1"), "--no-such-flag"}).exit_status, 2);
  EXPECT_EQ(run({"plan", scenario("paper_case1"), scenario("paper_case2"), "--json"}).exit_status, 2);
  const auto missing = run({"plan", "/nowhere.json", "--json"});
  EXPECT_EQ(missing.exit_status, 2);
  EXPECT_THAT(missing.err, HasSubstr("/nowhere.json"));
  EXPECT_THAT(missing.out, IsEmpty());
  EXPECT_EQ(run({"plan", "-"}, "{\"robot\": 7}").exit_status, 2);
}

TEST_F(CommandLine, EndsWithTwoAndListsEveryViolationOfARefusedRequest) {
  auto request = request_of("paper_case1");
  request.mutable_robot()->mutable_arms(0)->mutable_link()->set_length_m(-1.0);
  request.mutable_tasks(1)->set_arm("nobody");
  const auto result = run({"plan", "-", "--json"}, json_of(request));
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_THAT(result.err, AllOf(HasSubstr("robot.arms[0].link.length_m"), HasSubstr("tasks[1].arm")));
  EXPECT_THAT(result.out, IsEmpty());
}

TEST_F(CommandLine, EndsWithThreeWhereNoPlanExists) {
  auto request = request_of("paper_case1");
  auto* limit = request.mutable_robot()->mutable_arms(0)->mutable_torque_limit()->mutable_constant();
  limit->set_min_newton_meters(-1.0);
  limit->set_max_newton_meters(1.0);
  const auto result = run({"plan", "-", "--json"}, json_of(request));
  EXPECT_EQ(result.exit_status, 3) << result.err;
  PlanMotionResponse response;
  ASSERT_TRUE(parses_as(result.out, response));
  EXPECT_TRUE(response.has_infeasible());
}

TEST_F(CommandLine, EndsWithFourWhereTheBudgetOrTheTimeoutIsTooShort) {
  auto request = request_of("paper_retreat");
  request.mutable_options()->mutable_planning_budget()->set_nanos(1000);
  const auto undecided = run({"plan", "-"}, json_of(request));
  EXPECT_EQ(undecided.exit_status, 4) << undecided.out << undecided.err;
  EXPECT_THAT(undecided.out, StartsWith("stdin: undecided"));

  // Either the client's deadline passes first or the server, which knows it, answers that it is undecided.
  const auto late = run({"plan", scenario("paper_retreat"), "--timeout", "0.001"});
  EXPECT_EQ(late.exit_status, 4) << late.out << late.err;
}

TEST_F(CommandLine, EndsWithFiveWhereNoServerAnswers) {
  const auto result = run({"plan", scenario("paper_case1"), "--server", "unix:" + file("nobody")});
  EXPECT_EQ(result.exit_status, 5);
  EXPECT_THAT(result.err, HasSubstr("no answer from unix:"));
  EXPECT_EQ(run({"health", "--server", "unix:" + file("nobody")}).exit_status, 5);
}

TEST_F(CommandLine, SaysThatTheServerIsHealthy) {
  const auto result = run({"health"});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("is serving"));
  EXPECT_EQ(run({"health", "--service", "no.such.Service"}).exit_status, 5);
}

TEST_F(CommandLine, VerifiesThePlanItWroteAndNotATamperedOne) {
  ASSERT_EQ(run({"plan", scenario("paper_case1"), "--output", file("plan.json")}).exit_status, 0);
  const auto verified = run({"verify", scenario("paper_case1"), "--plan", file("plan.json")});
  EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;

  PlanMotionResponse tampered;
  read_json(file("plan.json"), tampered);
  auto& positions = *tampered.mutable_plan()->mutable_trajectories(0)->mutable_knots()->mutable_position_rad();
  positions[positions.size() / 2] += 0.1;
  write_text(file("plan.json"), json_of(tampered));
  const auto refused = run({"verify", scenario("paper_case1"), "--plan", file("plan.json"), "--json"});
  EXPECT_EQ(refused.exit_status, 3) << refused.err;
  VerifyMotionResponse response;
  ASSERT_TRUE(parses_as(refused.out, response));
  EXPECT_GT(response.verification().violations_size(), 0);
}

TEST_F(CommandLine, VerifiesAPlanByItselfAndRefusesWhatHoldsNone) {
  ASSERT_EQ(run({"plan", scenario("paper_case1"), "--output", file("answer.json")}).exit_status, 0);
  PlanMotionResponse answer;
  read_json(file("answer.json"), answer);
  write_text(file("plan.json"), json_of(answer.plan()));
  const auto verified = run({"verify", scenario("paper_case1"), "--plan", file("plan.json")});
  EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
  EXPECT_EQ(run({"verify", scenario("paper_case1"), "--plan", "-"}, json_of(answer)).exit_status, 0);

  answer.mutable_infeasible();
  const auto none = run({"verify", scenario("paper_case1"), "--plan", "-"}, json_of(answer));
  EXPECT_EQ(none.exit_status, 2);
  EXPECT_THAT(none.err, HasSubstr("stdin: holds no plan"));
  EXPECT_EQ(run({"verify", "-", "--plan", "-"}).exit_status, 2);
}

TEST_F(CommandLine, EndsWithOneWhereItsAnswerCannotBeWritten) {
  const std::string plan = "plan " + scenario("paper_case1");
  for (const std::string& command : {plan, plan + " --json", plan + " --table", std::string("health"),
                                     std::string("plan --help"), std::string("--version")}) {
    SCOPED_TRACE(command);
    const auto result = run_on_full_disk(command);
    EXPECT_EQ(result.exit_status, 1);
    EXPECT_THAT(result.err, HasSubstr("dualarm: stdout: cannot be written"));
  }
}

TEST_F(CommandLine, TellsItsVersion) {
  const auto result = run({"--version"});
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_EQ(result.out, "dualarm " DUALARM_VERSION "\n");
}

TEST_F(CommandLine, RefusesAnEmptyServerAndAMissingTemporaryFolderWithARemedy) {
  const auto server = run({"health", "--server", ""});
  EXPECT_EQ(server.exit_status, 2);
  EXPECT_THAT(server.err, HasSubstr("give HOST:PORT or unix:PATH"));
  fs::remove(tmp());
  const auto folder = run({"health"});
  EXPECT_EQ(folder.exit_status, 5);
  EXPECT_THAT(folder.err, HasSubstr("set TMPDIR to a folder"));
}

TEST_F(CommandLine, SpeaksOnceOfAFileThatCannotBePlanned) {
  const auto report = run({"plan", scenario("paper_case1"), "/nowhere.json"});
  EXPECT_EQ(report.exit_status, 2);
  EXPECT_EQ(report.err, "dualarm: /nowhere.json: cannot be read: No such file or directory\n");
  const auto table = run({"plan", scenario("paper_case1"), "/nowhere.json", "--table"});
  EXPECT_EQ(table.exit_status, 2);
  EXPECT_THAT(table.out, HasSubstr("ERROR"));
  EXPECT_THAT(table.err, IsEmpty());
}

TEST_F(CommandLine, PlansManyFilesIntoATableAndDrawings) {
  const auto result = run(
      {"plan", scenario("paper_case1"), "/nowhere.json", scenario("paper_case3"), "--table", "--svg-folder", tmp()});
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_THAT(result.out,
              AllOf(HasSubstr("paper_case1"), HasSubstr("nowhere          ERROR"), HasSubstr("paper_case3")));
  EXPECT_TRUE(fs::exists(tmp() + "/paper_case1.svg"));
  EXPECT_TRUE(fs::exists(tmp() + "/paper_case3.svg"));
}

TEST_F(CommandLine, CleansUpWhenInterrupted) {
  auto run = start(long_work());
  ASSERT_TRUE(comes_true([&] { return !tmp_is_empty(); }));
  kill(run.pid(), SIGINT);
  const auto result = run.wait();
  EXPECT_EQ(result.exit_status, 130) << result.err;
  EXPECT_TRUE(tmp_is_empty());
  EXPECT_TRUE(server_is_gone());
}

TEST_F(CommandLine, TakesThePrivateServerAlongWhenKilled) {
  auto run = start(long_work());
  ASSERT_TRUE(comes_true([&] { return processes_with(tmp()).size() == 1; }));
  kill(run.pid(), SIGKILL);
  EXPECT_EQ(run.wait().exit_status, 128 + SIGKILL);
  EXPECT_TRUE(comes_true([&] { return server_is_gone(); }));
}

}  // namespace
}  // namespace dualarm
