// Running jobs: records, skipped and repeated jobs, crashes, shards, and byte-identical tables.
#include "campaign/run.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "campaign/campaign_folder.h"
#include "campaign/fleet.h"
#include "campaign/record.h"
#include "campaign/status.h"
#include "campaign/worker_pool.h"
#include "support/files.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr const char* kVersion = "1.0";

class RunCampaign : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.writeComponent("c.yaml");
    folder_.writeLog("log_1.csv", 1);
    folder_.writeLog("log_2.csv", 2);
    writeJobs(6);
  }

  // Writes a jobs file with this number of draws, each for both logs.
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

  campaign::Status statusOf(const campaign::Manifest& manifest) {
    return campaign::statusOf(manifest, folder_.path("out"));
  }

  std::string recordPath(const campaign::Manifest& manifest, std::size_t job) {
    return campaign::recordPath(folder_.path("out"), manifest.jobs[job].id);
  }

  campaign::FoundRecord found(const campaign::Manifest& manifest, std::size_t job) {
    return campaign::findRecord(folder_.path("out"), manifest.jobs[job].id, kVersion, campaign::FileCheck::digests);
  }

  void expectSameTables(const std::string& other) {
    for (const std::string table : {"/table.csv", "/table.json"}) {
      EXPECT_EQ(folder_.read("out" + table), folder_.read(other + table));
    }
  }

  // Returns a reader that calls `before` in the worker process and then reads the log.
  static campaign::LogReader readingAfter(const std::function<void(const std::string& path)>& before) {
    return [before](const std::string& path, const std::string& component, const log::LogFormat& format) {
      before(path);
      return readTestLog(path, component, format);
    };
  }

  CampaignFolder folder_;
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
  expectSameTables("shards");
  EXPECT_THAT(folder_.read("out/table.csv"),
              AllOf(HasSubstr("id,group,type,test_piece,command,component,logs,status,specification.static_stiffness,"
                              "samples,duration_s"),
                    HasSubstr(",study,bush,. draw 1,replay,bush,log_1,done,")));
  EXPECT_EQ(nlohmann::json::parse(folder_.read("out/table.json")).at("jobs").size(), 12U);
}

TEST_F(RunCampaign, TellsAndRedoesWhatIsCutOffOrOfAnotherVersion) {
  const campaign::Manifest manifest = make();
  run();
  const std::string record = contentOf(recordPath(manifest, 0));
  const auto damage = [&](std::size_t job, const std::string& text) {
    std::ofstream(recordPath(manifest, job)) << text;
  };
  damage(0, record.substr(0, record.size() / 2));
  damage(1, replaced(contentOf(recordPath(manifest, 1)), "\"version\":\"1.0\"", "\"version\":\"0.9\""));
  damage(2, record);  // the record of job 0 instead of job 2
  damage(3, "");
  const std::string report = folder_.path("out/" + campaign::reportFolder(manifest.jobs[4].id) + "/force.csv");
  std::filesystem::resize_file(report, 10);
  EXPECT_THAT(statusOf(manifest).broken, SizeIs(5));
  const campaign::RunSummary summary = run();
  EXPECT_EQ(summary.done, 5U);
  EXPECT_EQ(summary.passed_over, 7U);
  EXPECT_THAT(said_, ElementsAre(HasSubstr("is not a complete record; the job is run again"),
                                 HasSubstr("written by version 0.9, not 1.0; the job is run again"),
                                 HasSubstr("the record belongs to another job"), HasSubstr("not a complete record"),
                                 AllOf(HasSubstr("force.csv has 10 bytes instead of"), HasSubstr("run again"))));
  EXPECT_THAT(statusOf(manifest).broken, IsEmpty());
}

// A record with any other content is reported with its file name, and does not end the program.
TEST_F(RunCampaign, ARecordOfAnotherFormIsBroken) {
  const campaign::Manifest manifest = make();
  run();
  const std::string path = recordPath(manifest, 0);
  const std::string good = contentOf(path);
  const std::string values = "\"values\":";
  const std::size_t at = good.find(values) + values.size();
  const std::size_t end = good.find(",\"evidence\"", at);
  ASSERT_NE(end, std::string::npos) << good;
  for (const std::string& other : {std::string("5"), std::string("[1]"), std::string("{\"x\":[[1]]}"),
                                   "{\"x\":" + std::string(200000, '[') + std::string(200000, ']') + "}"}) {
    std::ofstream(path, std::ios::binary) << good.substr(0, at) << other << good.substr(end);
    EXPECT_FALSE(found(manifest, 0).record) << other.substr(0, 20);
    EXPECT_THAT(found(manifest, 0).problem, HasSubstr(path));
  }
  EXPECT_EQ(statusOf(manifest).all.broken, 1U);
}

TEST_F(RunCampaign, ADigitThatChangesIsToldAndDoneAgain) {
  const campaign::Manifest manifest = make();
  run();
  const std::string path = recordPath(manifest, 0);
  const std::string good = contentOf(path);
  int digits = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    if (std::isdigit(static_cast<unsigned char>(good[i])) != 0) {
      ++digits;
      std::string other = good;
      other[i] = other[i] == '5' ? '6' : '5';
      std::ofstream(path, std::ios::binary) << other;
      EXPECT_FALSE(found(manifest, 0).record) << i;
    }
  }
  EXPECT_GT(digits, 100);
  EXPECT_THAT(collect().broken, ElementsAre(HasSubstr(path)));
  EXPECT_EQ(run().done, 1U);
  EXPECT_THAT(said_, ElementsAre(HasSubstr("the job is run again")));
}

// A changed digit in a force does not change the size of the file.
TEST_F(RunCampaign, AChangedDigitOfAReportIsToldAndDoneAgain) {
  const campaign::Manifest manifest = make();
  run();
  const std::string path = folder_.path("out/") + reportPath(*found(manifest, 0).record);
  std::string forces = contentOf(path);
  char& last = forces[forces.find_last_of("0123456789")];
  last = last == '5' ? '6' : '5';
  std::ofstream(path, std::ios::binary) << forces;
  EXPECT_EQ(statusOf(manifest).all.broken, 0U) << "it compares sizes";
  EXPECT_THAT(collect().broken, ElementsAre(AllOf(HasSubstr(path), HasSubstr("was changed after it was written"))));
  EXPECT_EQ(run().done, 1U);
  EXPECT_THAT(collect().broken, IsEmpty());
}

TEST_F(RunCampaign, AHugeRecordIsNotRead) {
  const campaign::Manifest manifest = make();
  run();
  std::filesystem::resize_file(recordPath(manifest, 0), std::uintmax_t{5} << 30);
  EXPECT_THAT(statusOf(manifest).broken,
              ElementsAre(HasSubstr("has 5368709120 bytes; accepted: a record of at most 16777216")));
}

TEST_F(RunCampaign, APipeOrFolderInPlaceOfARecordIsToldAndDoneAgain) {
  const campaign::Manifest manifest = make();
  run();
  std::vector<std::string> paths;
  for (std::size_t job : {0, 1}) {
    paths.push_back(recordPath(manifest, job));
    std::filesystem::remove(paths.back());
  }
  ASSERT_EQ(mkfifo(paths[0].c_str(), 0600), 0);
  std::filesystem::create_directories(paths[1] + "/kept");
  EXPECT_THAT(statusOf(manifest).broken, ElementsAre(paths[0] + ": is a pipe; accepted: a record",
                                                     paths[1] + ": is a folder; accepted: a record"));
  EXPECT_THAT(collect().broken, SizeIs(2));
  EXPECT_EQ(run().done, 2U);
  EXPECT_THAT(said_, SizeIs(2));
  EXPECT_TRUE(std::filesystem::exists(paths[1] + ".no_record/kept"));
  EXPECT_EQ(collect().done, 12U);
}

// A full disk ends the run. It is not stored as the result of a job.
TEST_F(RunCampaign, ADiskWithoutRoomLeavesNoResult) {
  writeJobs(1);
  make();
  for (const rlim_t most : {10, 400}) {  // size limits for the file of forces or the record
    const auto limited = readingAfter([most](const std::string&) {
      const rlimit limit{most, RLIM_INFINITY};
      setrlimit(RLIMIT_FSIZE, &limit);
    });
    EXPECT_THAT([&] { run({}, "out", limited); },
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
  const campaign::RunSummary summary = run({}, "out", readingAfter([](const std::string& path) {
                                             if (path.find("log_2") != std::string::npos) {
                                               throw std::bad_alloc();
                                             }
                                           }));
  EXPECT_EQ(summary.done, 1U);
  EXPECT_EQ(summary.failed, 0U);
  EXPECT_EQ(summary.not_done, 1U);
  EXPECT_THAT(said_, ElementsAre(HasSubstr("not done: there was not enough memory")));
  EXPECT_EQ(run().done, 1U);
}

// A spreadsheet would evaluate a text that looks like a formula.
TEST_F(RunCampaign, ATableHasNoFormulas) {
  folder_.write("jobs.yaml", "jobs:\n  \"=cmd()\":\n    command: replay\n    config: c.yaml\n    log: log_1.csv\n");
  campaign::collect(make(), folder_.path("out"));
  EXPECT_THAT(folder_.read("out/table.csv"), HasSubstr(",'=cmd(),"));
}

TEST_F(RunCampaign, AFailedJobIsARecordAndTheOthersGoOn) {
  const campaign::Manifest manifest = make();
  folder_.writeLog("log_2.csv", 77);  // changed after the manifest
  const campaign::RunSummary summary = run();
  EXPECT_EQ(summary.done, 6U);
  EXPECT_EQ(summary.failed, 6U);
  EXPECT_THAT(said_, SizeIs(6));
  const campaign::Status status = statusOf(manifest);
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
  const campaign::RunSummary summary = run(options, "out", readingAfter([](const std::string& path) {
                                             if (path.find("log_2") != std::string::npos) {
                                               std::raise(SIGABRT);  // sanitizers would turn SIGSEGV into an exit
                                             }
                                           }));
  EXPECT_EQ(summary.done, 6U);
  EXPECT_EQ(summary.failed, 6U);
  EXPECT_THAT(statusOf(manifest).failures.front(), HasSubstr("ended by signal 6"));
}

class HangingJobs : public RunCampaign {
 protected:
  static constexpr double kShort = 0.02;  // 1.2 s, thirty times the duration of a job that ends [min]

  // The reader of one log waits forever, as on a file system that does not answer.
  const campaign::LogReader hanging_ = readingAfter([](const std::string& path) {
    while (path.find("log_2") != std::string::npos) {
      pause();
    }
  });
};

TEST_F(HangingJobs, AJobThatNeverEndsFailsAtItsLimitAndTakesNoOtherWithIt) {
  writeJobs(2);
  const campaign::Manifest manifest = make();
  make("one_worker");
  campaign::RunOptions options;
  options.job_minutes = kShort;
  const campaign::RunSummary one = run(options, "one_worker", hanging_);
  options.workers = 3;
  const campaign::RunSummary summary = run(options, "out", hanging_);
  for (const campaign::RunSummary& each : {one, summary}) {
    EXPECT_EQ(each.done, 2U);
    EXPECT_EQ(each.failed, 2U);
    EXPECT_FALSE(each.interrupted);
  }
  EXPECT_THAT(statusOf(manifest).failures.front(),
              AllOf(HasSubstr("took longer than the limit of 0.02 min and was stopped"), HasSubstr("--retry-failed")));
  EXPECT_EQ(collect().failed, 2U);
  collect("one_worker");
  expectSameTables("one_worker");
}

TEST_F(HangingJobs, AJobThatItsLimitEndedIsDoneAgainOnlyWhenAskedFor) {
  writeJobs(1);
  make();
  campaign::RunOptions options;
  options.job_minutes = kShort;
  run(options, "out", hanging_);
  EXPECT_EQ(run().passed_over, 2U);
  options.retry_failed = true;
  EXPECT_EQ(run(options).done, 1U);
  make("never_ended");
  run({}, "never_ended");
  collect();
  collect("never_ended");
  expectSameTables("never_ended");
}

TEST_F(RunCampaign, AManifestOfAnotherVersionIsRefused) {
  make();
  EXPECT_THAT([&] { campaign::run(folder_.path("out"), "2.0", {}, readTestLog, [](const std::string&) {}); },
              ::testing::ThrowsMessage<std::runtime_error>(
                  AllOf(HasSubstr("written by version 1.0, but this program has version 2.0"),
                        HasSubstr("accepted: `campaign make` again"))));
}

TEST_F(RunCampaign, StatusTellsWhatIsMissing) {
  const campaign::Manifest manifest = make();
  campaign::RunOptions some;
  some.shard = {1, 4};
  run(some);
  const campaign::Status status = statusOf(manifest);
  EXPECT_EQ(status.all.jobs, 12U);
  EXPECT_EQ(status.all.done, 3U);
  EXPECT_EQ(status.all.missing, 9U);
  EXPECT_EQ(collect().missing, 9U);
  EXPECT_THAT(campaign::toText(status), HasSubstr("9 jobs remain"));
}

TEST_F(RunCampaign, StatusTellsWhatRuns) {
  const campaign::Manifest manifest = make();
  {
    campaign::Heartbeat heartbeat(folder_.path("out"));
    heartbeat.beat(manifest, {0, 3});
    EXPECT_EQ(statusOf(manifest).all.running, 2U);
  }
  EXPECT_EQ(statusOf(manifest).all.running, 0U);
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

// Records what the supervisor reports about workers that do nothing, fail, or are killed by a signal.
class Workers : public ::testing::Test {
 protected:
  // `work` returns true if a job succeeds, and false if it fails.
  bool workOff(std::size_t count, int workers, const std::function<bool(std::size_t)>& work, double longest = 0.0) {
    campaign::PoolCallbacks callbacks;
    callbacks.start_worker = [&] { return [&](std::size_t job) { return work(job) ? "" : "an error"; }; };
    callbacks.ended = [&](std::size_t job, campaign::JobEnd end, const std::string& reason) {
      ended_[end].push_back(job);
      reasons_[end].push_back(reason);
    };
    callbacks.tick = [](const std::vector<std::size_t>&) {};
    std::vector<std::size_t> jobs(count);
    std::iota(jobs.begin(), jobs.end(), 0);
    return campaign::workOff(jobs, workers, callbacks, longest);
  }

  std::map<campaign::JobEnd, std::vector<std::size_t>> ended_;
  std::map<campaign::JobEnd, std::vector<std::string>> reasons_;
};

using campaign::JobEnd;

TEST_F(Workers, NoJobsNoWorkers) { EXPECT_TRUE(workOff(0, 4, nullptr)); }

TEST_F(Workers, TellWhatFailed) {
  workOff(50, 4, [](std::size_t job) { return job % 10 != 3; });
  EXPECT_THAT(ended_[JobEnd::done], SizeIs(45));
  EXPECT_THAT(ended_[JobEnd::failed], UnorderedElementsAre(3, 13, 23, 33, 43));
}

TEST_F(Workers, KilledFromOutsideOnceTryAgain) {
  const CampaignFolder folder;
  workOff(4, 2, [&](std::size_t job) {
    if (job == 1 && !folder.holds("tried")) {
      folder.write("tried", "");
      std::raise(SIGKILL);
    }
    return true;
  });
  EXPECT_THAT(ended_[JobEnd::done], UnorderedElementsAre(0, 1, 2, 3));
  EXPECT_THAT(ended_[JobEnd::died], IsEmpty());
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
  EXPECT_THAT(ended_[JobEnd::done], UnorderedElementsAre(0, 3));
  EXPECT_THAT(ended_[JobEnd::died], IsEmpty());
  EXPECT_THAT(ended_[JobEnd::left], ElementsAre(1, 2));
  EXPECT_THAT(reasons_[JobEnd::left], ElementsAre(HasSubstr("signal 9"), HasSubstr("not enough memory")));
}

TEST_F(Workers, ThatEndByThemselvesCountAsDied) {
  workOff(3, 1, [](std::size_t job) {
    if (job == 0) {
      _exit(7);
    }
    return true;
  });
  EXPECT_THAT(reasons_[JobEnd::died], ElementsAre("the process ended with status 7"));
  EXPECT_THAT(ended_[JobEnd::done], ElementsAre(1, 2));
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
  EXPECT_THAT(ended_[JobEnd::done], UnorderedElementsAre(0, 2, 3, 5));
  EXPECT_THAT(ended_[JobEnd::died], UnorderedElementsAre(1, 4));
  EXPECT_THAT(reasons_[JobEnd::died], ::testing::Each(HasSubstr("took longer than the limit of 0.00333333 min")));
}

// The time limit applies to each job. Many short jobs together may take longer.
TEST_F(Workers, OfManyShortJobsAreNotEnded) {
  workOff(
      20, 1,
      [](std::size_t) {
        usleep(30000);
        return true;
      },
      0.5);
  EXPECT_THAT(ended_[JobEnd::done], SizeIs(20));
  EXPECT_THAT(ended_[JobEnd::died], IsEmpty());
}

TEST_F(Workers, KeepTheTimeInWhichAllWereSuspended) {
  // A child process suspends this process for longer than the limit, as the scheduler of a cluster may do.
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
        usleep(5500000);  // continues while the supervisor is suspended
        return true;
      },
      4.0);
  waitpid(cluster, nullptr, 0);
  EXPECT_THAT(ended_[JobEnd::done], SizeIs(1));
}

TEST_F(Workers, AnExceptionEndsTheRun) {
  EXPECT_THAT([&] { workOff(3, 2, [](std::size_t) -> bool { throw std::runtime_error("disk full"); }); },
              ::testing::ThrowsMessage<std::runtime_error>("disk full"));
}

TEST_F(Workers, AnInterruptionEndsThem) {
  const pid_t supervisor = getpid();
  EXPECT_FALSE(workOff(100, 2, [supervisor](std::size_t job) {
    if (job == 5) {
      kill(supervisor, SIGTERM);
      pause();
    }
    return true;
  }));
  EXPECT_LT(ended_[JobEnd::done].size(), 100U);
}

}  // namespace
}  // namespace rubber_suspension
