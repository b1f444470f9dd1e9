// The array submitted to Slurm: its number of elements, its script, and names with special characters of a shell.
#include "campaign/slurm.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

campaign::Status statusOf(std::size_t jobs, std::size_t done, double seconds) {
  campaign::Status status;
  status.all.jobs = jobs;
  status.all.done = done;
  status.all.missing = jobs - done;
  status.seconds_per_job = seconds;
  return status;
}

campaign::SlurmOptions options() {
  campaign::SlurmOptions options;
  options.program = "/opt/bin/campaign";
  return options;
}

TEST(SlurmArrays, AnElementIsMinutesOfWork) {
  // A worker needs 165 min for 990 jobs of 10 s, so the array has 33 elements of 5 min.
  const campaign::SlurmArray array = campaign::planArray(statusOf(1000, 10, 10.0), "/data/fleet", options());
  EXPECT_EQ(array.shards, 33U);
  EXPECT_THAT(array.script, AllOf(HasSubstr("#SBATCH --array=1-33\n"), HasSubstr("#SBATCH --requeue\n"),
                                  HasSubstr("#SBATCH --cpus-per-task=1\n"), Not(HasSubstr("--partition")),
                                  HasSubstr("exec '/opt/bin/campaign' run '/data/fleet' --shard "
                                            "\"$SLURM_ARRAY_TASK_ID/33\" --threads 1 --job-minutes 240\n")));
}

TEST(SlurmArrays, MoreWorkersMakeFewerElements) {
  campaign::SlurmOptions four = options();
  four.workers = 4;
  four.max_running = 6;
  four.partition = "long";
  four.job_minutes = 2.5;
  const campaign::SlurmArray array = campaign::planArray(statusOf(1000, 10, 10.0), "/data/fleet", four);
  EXPECT_EQ(array.shards, 9U);
  EXPECT_THAT(array.script, AllOf(HasSubstr("--array=1-9%6\n"), HasSubstr("--partition=long\n"),
                                  HasSubstr("--cpus-per-task=4\n"), HasSubstr("--threads 4 --job-minutes 2.5\n")));
}

TEST(SlurmArrays, StayWithinWhatSlurmTakes) {
  EXPECT_EQ(campaign::planArray(statusOf(1000000, 1, 100.0), "/f", options()).shards, campaign::kMostElements);
  EXPECT_EQ(campaign::planArray(statusOf(3, 0, 10000.0), "/f", options()).shards, 3U);
}

TEST(SlurmArrays, OfUnknownTimeAreAssumed) {
  EXPECT_THAT(campaign::planArray(statusOf(100, 0, 0.0), "/f", options()).note, HasSubstr("assumed"));
}

TEST(SlurmArrays, NothingLeftIsNothingToSubmit) {
  EXPECT_EQ(campaign::planArray(statusOf(100, 100, 1.0), "/f", options()).shards, 0U);
}

TEST(SlurmArrays, TakeAnyFolderAsOneWord) {
  EXPECT_THAT(campaign::planArray(statusOf(1, 0, 1.0), "/it's $HOME", options()).script,
              HasSubstr("run '/it'\\''s $HOME' --shard"));
}

}  // namespace
}  // namespace rubber_suspension
