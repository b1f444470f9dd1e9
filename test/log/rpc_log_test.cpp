// Drive files of RPC III read back as they were written. Those in good_logs/ and bad_logs/ come from other programs.
#include "log/rpc_log.h"

#include "rubber_suspension/log/log_source.h"
#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

std::vector<double> sine(std::size_t samples, double amplitude) {
  std::vector<double> values(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    values[i] = amplitude * std::sin(0.01 * static_cast<double>(i));
  }
  return values;
}

TEST(RpcLog, IsReadBackToSinglePrecision) {
  constexpr std::size_t kSamples = 2500;  // the third frame of 1024 samples is incomplete
  const std::vector<double> z = sine(kSamples, 5.0);
  const std::vector<double> force = sine(kSamples, 7.0);
  const TemporaryFile file("drive.drv", log::rpcFile(1.0 / 512.0, {{"displacement", "mm", z}, {"force", "kN", force}}));
  const log::Log log = log::readLog(file.path());
  ASSERT_EQ(log.size(), 3U * 1024U);
  for (std::size_t i = 0; i < kSamples; ++i) {
    ASSERT_EQ(log.stamp[i], static_cast<std::int64_t>(i) * 1953125);
    ASSERT_NEAR(log.displacement[i], 1e-3 * z[i], 6e-8 * 5e-3);
    ASSERT_NEAR(log.force[i], 1e3 * force[i], 6e-8 * 7e3);
  }
  EXPECT_EQ(log.displacement.back(), log.displacement[kSamples - 1]) << "holds its last value";
}

// The log is read in blocks of 65,536 samples, which end within groups of the file.
TEST(RpcLog, IsReadBlockByBlock) {
  const std::vector<double> z = sine(300 * 1024, 5.0);
  const TemporaryFile file("drive.drv", log::rpcFile(1e-3, {{"displacement", "mm", z}}));
  std::size_t samples = 0;
  log::openLog(file.path())->read([&](const log::Log& block, std::size_t first) {
    EXPECT_EQ(first, samples);
    for (std::size_t i = 0; i < block.size(); i += 1000) {
      EXPECT_NEAR(block.displacement[i], 1e-3 * z[first + i], 6e-8 * 5e-3);
    }
    samples += block.size();
    return true;
  });
  EXPECT_EQ(samples, z.size());
}

TEST(RpcLog, RefusesChannelsOfTwoLengths) {
  EXPECT_THROW(log::rpcFile(1e-3, {}), std::invalid_argument);
  EXPECT_THROW(log::rpcFile(1e-3, {{"a", "mm", {1.0, 2.0}}, {"b", "kN", {1.0}}}), std::invalid_argument);
}

}  // namespace
}  // namespace rubber_suspension
