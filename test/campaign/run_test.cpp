// Working jobs off: records, what is passed over, what is done again, crashes, shards, and tables of the same bytes.
#include "campaign/run.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "campaign/fleet.h"
#include "campaign/record.h"
#include "campaign/scratch_folder.h"
#include "campaign/status.h"
#include "campaign/worker_pool.h"

namespace rubber_suspension {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kVersion = "1.0";

class RunCampaign : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.writeComponent("c.yaml");
    folder_.writeLog("log_1.csv", 1);
    folder_.writeLog("log_2.csv", 2);
    writeJobs(6);
  }

  // So many draws, each with both logs.
  void writeJobs(int draws) const {
    folder_.write(
        "jobs.yaml",
        fmt::format("jobs:\n  study:\n    command: replay\n    config: c.yaml\n    log: log_*.csv\n"
                    "    monte_carlo: {{runs: {}, seed: 5, tolerances: {{static_stiffness: {{uniform: 5 %}}}}}}\n",
                    draws));
  }

  campaign::Manifest make(const std::string& output = "out") {
    const campaign::Manifest manifest =
        campaign::makeManifest(folder_.path("jobs.yaml"), folder_.path(output), kVersion, 1, readTestLog).manifest;
    std::filesystem::create_directories(folder_.path(output));
    campaign::writeManifest(manifest, folder_.path(output));
    return manifest;
  }

  campaign::RunSummary run(const campaign::RunOptions& options = {}, const std::string& output = "out",
                           const campaign::LogReader& reader = readTestLog) {
    said_.clear();
    return campaign::run(folder_.path(output), kVersion, options, reader,
                         [&](const std::string& line) { said_.push_back(line); });
  }

  campaign::CollectSummary collect(const std::string& output = "out") {
    return campaign::collect(campaign::readManifest(folder_.path(output)), folder_.path(output));
  }

  ScratchFolder folder_;
  std::vector<std::string> said_;
};

TEST_F(RunCampaign, DoesEachJobOnce) {
  make();
  EXPECT_EQ(run().done, 12U);
  const campaign::RunSummary again = run();
  EXPECT_EQ(again.done, 0U);
  EXPECT_EQ(again.passed_over, 12U);
  EXPECT_THAT(said_, IsEmpty());
}

TEST_F(RunCampaign, GivesTheSameTablesHoweverItRan) {
  make();
  make("shards");
  run();
  campaign::RunOptions options;
  options.workers = 3;
  for (const std::size_t index : {3, 1, 2}) {
    options.shard = {index, 3};
    EXPECT_EQ(run(options, "shards").done, 4U);
  }
  EXPECT_EQ(collect().done, 12U);
  EXPECT_EQ(collect("shards").done, 12U);
  EXPECT_EQ(folder_.read("out/table.csv"), folder_.read("shards/table.csv"));
  EXPECT_EQ(folder_.read("out/table.json"), folder_.read("shards/table.json"));
  EXPECT_THAT(folder_.read("out/table.csv"),
              AllOf(HasSubstr("id,group,type,test_piece,command,component,logs,status,specification.static_stiffness,"
                              "samples,duration_s"),
                    HasSubstr(",study,bush,. draw 1,replay,bush,log_1,done,")));
  EXPECT_EQ(nlohmann::json::parse(folder_.read("out/table.json")).at("jobs").size(), 12U);
}

TEST_F(RunCampaign, TellsAndRedoesWhatIsCutOffOrOfAnotherVersion) {
  const campaign::Manifest manifest = make();
  run();
  const std::string record =
      folder_.read("out/results/" + manifest.jobs[0].id.substr(0, 2) + "/" + manifest.jobs[0].id.substr(2) + ".json");
  const auto damage = [&](std::size_t job, const std::string& text) {
    std::ofstream(campaign::recordPath(folder_.path("out"), manifest.jobs[job].id)) << text;
  };
  damage(0, record.substr(0, record.size() / 2));
  auto other = nlohmann::ordered_json::parse(
      folder_.read("out/results/" + manifest.jobs[1].id.substr(0, 2) + "/" + manifest.jobs[1].id.substr(2) + ".json"));
  other["version"] = "0.9";
  damage(1, other.dump());
  damage(2, record);  // that of job 0
  damage(3, "");
  const std::string report = folder_.path("out/" + campaign::reportFolder(manifest.jobs[4].id) + "/force.csv");
  std::filesystem::resize_file(report, 10);
  EXPECT_THAT(campaign::statusOf(manifest, folder_.path("out")).broken, SizeIs(5));
  const campaign::RunSummary summary = run();
  EXPECT_EQ(summary.done, 5U);
  EXPECT_EQ(summary.passed_over, 7U);
  EXPECT_THAT(said_, ElementsAre(HasSubstr("cut off, or no record; the job is done again"),
                                 HasSubstr("of version 0.9, not 1.0; the job is done again"),
                                 HasSubstr("the record of another job"), HasSubstr("cut off"),
                                 AllOf(HasSubstr("force.csv has 10 bytes, not"), HasSubstr("done again"))));
  EXPECT_THAT(campaign::statusOf(manifest, folder_.path("out")).broken, IsEmpty());
}

// Whatever stands in place of a record is told with its file and done again; none ends the program.
TEST_F(RunCampaign, ARecordOfAnotherFormIsBroken) {
  const campaign::Manifest manifest = make();
  run();
  const std::string id = manifest.jobs[0].id;
  const std::string path = campaign::recordPath(folder_.path("out"), id);
  const std::string good = folder_.read("out/" + path.substr(folder_.path("out").size() + 1));
  const std::string values = "\"values\":";
  const std::size_t at = good.find(values) + values.size();
  const std::size_t end = good.find(",\"evidence\"", at);
  ASSERT_NE(end, std::string::npos) << good;
  for (const std::string& other : {std::string("5"), std::string("[1]"), std::string("{\"x\":[[1]]}"),
                                   "{\"x\":" + std::string(200000, '[') + std::string(200000, ']') + "}"}) {
    std::ofstream(path, std::ios::binary) << good.substr(0, at) << other << good.substr(end);
    const campaign::FoundRecord found = campaign::findRecord(folder_.path("out"), id, kVersion);
    EXPECT_FALSE(found.record) << other.substr(0, 20);
    EXPECT_THAT(found.problem, HasSubstr(path));
  }
  EXPECT_EQ(campaign::statusOf(manifest, folder_.path("out")).all.broken, 1U);
}

TEST_F(RunCampaign, ADigitThatChangesIsToldAndDoneAgain) {
  const campaign::Manifest manifest = make();
  run();
  const std::string path = campaign::recordPath(folder_.path("out"), manifest.jobs[0].id);
  const std::string good = folder_.read("out/" + path.substr(folder_.path("out").size() + 1));
  int digits = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    if (std::isdigit(static_cast<unsigned char>(good[i])) != 0) {
      ++digits;
      std::string other = good;
      other[i] = other[i] == '5' ? '6' : '5';
      std::ofstream(path, std::ios::binary) << other;
      EXPECT_FALSE(campaign::findRecord(folder_.path("out"), manifest.jobs[0].id, kVersion).record) << i;
    }
  }
  EXPECT_GT(digits, 100);
  EXPECT_THAT(collect().broken, ElementsAre(HasSubstr(path)));
  EXPECT_EQ(run().done, 1U);
  EXPECT_THAT(said_, ElementsAre(HasSubstr("the job is done again")));
}

TEST_F(RunCampaign, APipeOrFolderInPlaceOfARecordIsToldAndDoneAgain) {
  const campaign::Manifest manifest = make();
  run();
  std::vector<std::string> paths;
  for (std::size_t job : {0, 1}) {
    paths.push_back(campaign::recordPath(folder_.path("out"), manifest.jobs[job].id));
    std::filesystem::remove(paths.back());
  }
  ASSERT_EQ(mkfifo(paths[0].c_str(), 0600), 0);
  std::filesystem::create_directories(paths[1] + "/kept");
  EXPECT_THAT(campaign::statusOf(manifest, folder_.path("out")).broken,
              ElementsAre(paths[0] + ": is a pipe, not a record", paths[1] + ": is a folder, not a record"));
  EXPECT_THAT(collect().broken, SizeIs(2));
  EXPECT_EQ(run().done, 2U);
  EXPECT_THAT(said_, SizeIs(2));
  EXPECT_TRUE(std::filesystem::exists(paths[1] + ".no_record/kept"));
  EXPECT_EQ(collect().done, 12U);
}

// What the machine lacks ends the run, or leaves the job, and is no result.
TEST_F(RunCampaign, ADiskWithoutRoomLeavesNoResult) {
  writeJobs(1);
  make();
  const auto with_limit = [](rlim_t most) {
    return [most](const std::string& path, const std::string& component, const log::LogFormat& format) {
      const rlimit limit{most, RLIM_INFINITY};  // in the worker process
      setrlimit(RLIMIT_FSIZE, &limit);
      return readTestLog(path, component, format);
    };
  };
  for (const rlim_t most : {10, 400}) {  // the file of forces, or the record
    EXPECT_THAT([&] { run({}, "out", with_limit(most)); },
                ::testing::ThrowsMessage<std::runtime_error>(HasSubstr("File too large")));
  }
  EXPECT_EQ(collect().missing, 2U);
  const campaign::RunSummary summary = run();
  EXPECT_EQ(summary.done, 2U);
  EXPECT_EQ(summary.passed_over, 0U);
}

TEST_F(RunCampaign, AJobWithoutMemoryIsTriedAgain) {
  writeJobs(1);
  make();
  const campaign::RunSummary summary =
      run({}, "out", [](const std::string& path, const std::string& component, const log::LogFormat& format) {
        return path.find("log_2") != std::string::npos ? throw std::bad_alloc() : readTestLog(path, component, format);
      });
  EXPECT_EQ(summary.done, 1U);
  EXPECT_EQ(summary.failed, 0U);
  EXPECT_EQ(summary.not_done, 1U);
  EXPECT_THAT(said_, ElementsAre(HasSubstr("not done: there was no memory")));
  EXPECT_EQ(run().done, 1U);
}

// A spreadsheet would work out what begins like a formula.
TEST_F(RunCampaign, ATableHasNoFormulas) {
  folder_.write("jobs.yaml", "jobs:\n  \"=cmd()\":\n    command: replay\n    config: c.yaml\n    log: log_1.csv\n");
  campaign::collect(make(), folder_.path("out"));
  EXPECT_THAT(folder_.read("out/table.csv"), HasSubstr(",'=cmd(),"));
}

TEST_F(RunCampaign, AFailedJobIsARecordAndTheOthersGoOn) {
  const campaign::Manifest manifest = make();
  folder_.writeLog("log_2.csv", 77);  // changed since the manifest was made
  const campaign::RunSummary summary = run();
  EXPECT_EQ(summary.done, 6U);
  EXPECT_EQ(summary.failed, 6U);
  EXPECT_THAT(said_, SizeIs(6));
  const campaign::Status status = campaign::statusOf(manifest, folder_.path("out"));
  EXPECT_EQ(status.all.failed, 6U);
  ASSERT_FALSE(status.failures.empty());
  EXPECT_THAT(status.failures.front(), AllOf(HasSubstr("log_2.csv: has changed since"), HasSubstr("accepted")));
  EXPECT_EQ(collect().failed, 6U);
  EXPECT_THAT(folder_.read("out/table.csv"), HasSubstr("has changed since"));
  folder_.writeLog("log_2.csv", 2);
  const campaign::RunSummary again = run();
  EXPECT_EQ(again.passed_over, 12U);
  EXPECT_EQ(again.failed_before, 6U);
  campaign::RunOptions retry;
  retry.retry_failed = true;
  EXPECT_EQ(run(retry).done, 6U);
}

TEST_F(RunCampaign, AJobThatCrashesTakesNoOtherWithIt) {
  const campaign::Manifest manifest = make();
  campaign::RunOptions options;
  options.workers = 2;
  const campaign::RunSummary summary =
      run(options, "out", [](const std::string& path, const std::string& component, const log::LogFormat& format) {
        if (path.find("log_2") != std::string::npos) {
          std::raise(SIGABRT);  // sanitizers would turn a SIGSEGV into an exit
        }
        return readTestLog(path, component, format);
      });
  EXPECT_EQ(summary.done, 6U);
  EXPECT_EQ(summary.failed, 6U);
  EXPECT_THAT(campaign::statusOf(manifest, folder_.path("out")).failures.front(), HasSubstr("died of signal 6"));
}

constexpr double kShort = 0.02;  // [min], 1.2 s: thirty times what a job takes that ends

// One log keeps its reader waiting for ever, as a file system or a loop without end would.
campaign::LogReader readerThatHangs() {
  return [](const std::string& path, const std::string& component, const log::LogFormat& format) {
    while (path.find("log_2") != std::string::npos) {
      pause();
    }
    return readTestLog(path, component, format);
  };
}

TEST_F(RunCampaign, AJobThatNeverEndsFailsAtItsLimitAndTakesNoOtherWithIt) {
  writeJobs(2);
  const campaign::Manifest manifest = make();
  make("one_worker");
  campaign::RunOptions options;
  options.job_minutes = kShort;
  const campaign::RunSummary one = run(options, "one_worker", readerThatHangs());
  options.workers = 3;
  const campaign::RunSummary summary = run(options, "out", readerThatHangs());
  for (const campaign::RunSummary& each : {one, summary}) {
    EXPECT_EQ(each.done, 2U);
    EXPECT_EQ(each.failed, 2U);
    EXPECT_FALSE(each.interrupted);
  }
  EXPECT_THAT(campaign::statusOf(manifest, folder_.path("out")).failures.front(),
              AllOf(HasSubstr("took longer than the limit of 0.02 min and was ended"), HasSubstr("--retry-failed")));
  EXPECT_EQ(collect().failed, 2U);
  collect("one_worker");
  EXPECT_EQ(folder_.read("out/table.csv"), folder_.read("one_worker/table.csv"));
  EXPECT_EQ(folder_.read("out/table.json"), folder_.read("one_worker/table.json"));
}

TEST_F(RunCampaign, AJobThatItsLimitEndedIsDoneAgainOnlyWhenAskedFor) {
  writeJobs(1);
  make();
  campaign::RunOptions options;
  options.job_minutes = kShort;
  run(options, "out", readerThatHangs());
  EXPECT_EQ(run().passed_over, 2U);
  options.retry_failed = true;
  EXPECT_EQ(run(options).done, 1U);
  make("never_ended");
  run({}, "never_ended");
  collect();
  collect("never_ended");
  EXPECT_EQ(folder_.read("out/table.csv"), folder_.read("never_ended/table.csv"));
}

TEST_F(RunCampaign, AManifestOfAnotherVersionIsRefused) {
  make();
  EXPECT_THAT([&] { campaign::run(folder_.path("out"), "2.0", {}, readTestLog, [](const std::string&) {}); },
              ::testing::ThrowsMessage<std::runtime_error>(
                  AllOf(HasSubstr("of version 1.0, and this is 2.0"), HasSubstr("accepted: `campaign make` again"))));
}

TEST_F(RunCampaign, StatusTellsWhatIsMissing) {
  const campaign::Manifest manifest = make();
  campaign::RunOptions some;
  some.shard = {1, 4};
  run(some);
  const campaign::Status status = campaign::statusOf(manifest, folder_.path("out"));
  EXPECT_EQ(status.all.jobs, 12U);
  EXPECT_EQ(status.all.done, 3U);
  EXPECT_EQ(status.all.missing, 9U);
  EXPECT_EQ(collect().missing, 9U);
  EXPECT_THAT(campaign::toText(status), HasSubstr("9 jobs left"));
}

TEST_F(RunCampaign, StatusTellsWhatRuns) {
  const campaign::Manifest manifest = make();
  {
    campaign::Heartbeat heartbeat(folder_.path("out"));
    heartbeat.beat(manifest, {0, 3});
    EXPECT_EQ(campaign::statusOf(manifest, folder_.path("out")).all.running, 2U);
  }
  EXPECT_EQ(campaign::statusOf(manifest, folder_.path("out")).all.running, 0U);
}

TEST(Shards, AreParsed) {
  EXPECT_EQ(campaign::parseShard("3/8").index, 3U);
  EXPECT_EQ(campaign::parseShard("3/8").count, 8U);
  for (const char* text : {"", "3", "0/8", "9/8", "a/8", "1/b", "1.5/8", "1/", "/8", "-1/8", "1/1e300", "nan/nan"}) {
    EXPECT_THAT([&] { campaign::parseShard(text); },
                ::testing::ThrowsMessage<std::invalid_argument>(HasSubstr("accepted: I/N")))
        << text;
  }
}

// What the supervisor sees of workers that do nothing, fail, or are killed from outside once or for ever.
class Workers : public ::testing::Test {
 protected:
  campaign::PoolEnd workOff(std::size_t count, int workers, const std::function<bool(std::size_t)>& work,
                            double longest = 0.0) {
    campaign::PoolCallbacks callbacks;
    callbacks.start_worker = [&] { return work; };
    callbacks.finished = [&](std::size_t job, bool done) { (done ? done_ : failed_).push_back(job); };
    callbacks.died = [&](std::size_t job, const std::string& reason) {
      died_.push_back(job);
      reasons_.push_back(reason);
    };
    callbacks.left = [&](std::size_t job, const std::string& reason) {
      left_.push_back(job);
      reasons_.push_back(reason);
    };
    callbacks.tick = [](const std::vector<std::size_t>&) {};
    std::vector<std::size_t> jobs(count);
    for (std::size_t i = 0; i < count; ++i) {
      jobs[i] = i;
    }
    return campaign::workOff(jobs, workers, callbacks, longest);
  }

  std::vector<std::size_t> done_;
  std::vector<std::size_t> failed_;
  std::vector<std::size_t> died_;
  std::vector<std::size_t> left_;
  std::vector<std::string> reasons_;
};

TEST_F(Workers, NoJobsNoWorkers) { EXPECT_EQ(workOff(0, 4, nullptr), campaign::PoolEnd::finished); }

TEST_F(Workers, TellWhatFailed) {
  workOff(50, 4, [](std::size_t job) { return job % 10 != 3; });
  EXPECT_THAT(done_, SizeIs(45));
  EXPECT_THAT(failed_, ::testing::UnorderedElementsAre(3, 13, 23, 33, 43));
}

TEST_F(Workers, KilledFromOutsideOnceTryAgain) {
  const ScratchFolder folder;
  workOff(4, 2, [&](std::size_t job) {
    if (job == 1 && !folder.holds("tried")) {
      folder.write("tried", "");
      std::raise(SIGKILL);
    }
    return true;
  });
  EXPECT_THAT(done_, ::testing::UnorderedElementsAre(0, 1, 2, 3));
  EXPECT_THAT(died_, IsEmpty());
}

TEST_F(Workers, LeaveWhatTheyAreKilledOfTwiceOrHaveNoMemoryFor) {
  workOff(4, 1, [&](std::size_t job) {
    if (job == 1) {
      std::raise(SIGKILL);
    }
    if (job == 2) {
      throw std::bad_alloc();
    }
    return true;
  });
  EXPECT_THAT(done_, ::testing::UnorderedElementsAre(0, 3));
  EXPECT_THAT(died_, IsEmpty());
  EXPECT_THAT(left_, ElementsAre(1, 2));
  EXPECT_THAT(reasons_, ElementsAre(HasSubstr("signal 9"), HasSubstr("no memory")));
}

TEST_F(Workers, ThatEndByThemselvesCountAsDied) {
  workOff(3, 1, [](std::size_t job) {
    if (job == 0) {
      _exit(7);
    }
    return true;
  });
  EXPECT_THAT(reasons_, ElementsAre("the process ended with status 7"));
  EXPECT_THAT(done_, ElementsAre(1, 2));
}

TEST_F(Workers, ThatTakeTooLongAreEnded) {
  workOff(
      6, 2,
      [](std::size_t job) {
        while (job == 1 || job == 4) {
          pause();
        }
        return true;
      },
      0.2);
  EXPECT_THAT(done_, ::testing::UnorderedElementsAre(0, 2, 3, 5));
  EXPECT_THAT(died_, ::testing::UnorderedElementsAre(1, 4));
  EXPECT_THAT(reasons_, ::testing::Each(HasSubstr("took longer than the limit of 0.00333333 min")));
}

// A limit is for one job: many short ones take longer together.
TEST_F(Workers, OfManyShortJobsAreNotEnded) {
  workOff(
      20, 1,
      [](std::size_t) {
        usleep(30000);
        return true;
      },
      0.5);
  EXPECT_THAT(done_, SizeIs(20));
  EXPECT_THAT(died_, IsEmpty());
}

TEST_F(Workers, KeepTheTimeInWhichAllWereSuspended) {
  // A child suspends this process, as a cluster does, for longer than the limit.
  const pid_t supervisor = getpid();
  const pid_t cluster = fork();
  if (cluster == 0) {
    usleep(300000);
    kill(supervisor, SIGSTOP);
    usleep(4500000);
    kill(supervisor, SIGCONT);
    _exit(0);
  }
  workOff(
      1, 1,
      [](std::size_t) {
        usleep(5500000);  // goes on while the supervisor is stopped
        return true;
      },
      4.0);
  waitpid(cluster, nullptr, 0);
  EXPECT_THAT(done_, SizeIs(1));
}

TEST_F(Workers, AnExceptionEndsTheRun) {
  EXPECT_THAT([&] { workOff(3, 2, [](std::size_t) -> bool { throw std::runtime_error("disk full"); }); },
              ::testing::ThrowsMessage<std::runtime_error>("disk full"));
}

TEST_F(Workers, AnInterruptionEndsThem) {
  const pid_t supervisor = getpid();
  EXPECT_EQ(workOff(100, 2,
                    [supervisor](std::size_t job) {
                      if (job == 5) {
                        kill(supervisor, SIGTERM);
                        pause();
                      }
                      return true;
                    }),
            campaign::PoolEnd::interrupted);
  EXPECT_LT(done_.size(), 100U);
}

}  // namespace
}  // namespace rubber_suspension
