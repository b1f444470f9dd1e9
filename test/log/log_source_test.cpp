// Logs read block by block are the same as logs read as a whole.
#include "rubber_suspension/log/log_source.h"

#include <hdf5.h>

#include "log/even_blocks.h"
#include "log/samples.h"
#include "rubber_suspension/log/record.h"
#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

using log::Log;
using log::LogSource;

constexpr std::size_t kLong = 5 * log::kLogBlock + 1234;  // a file of this length is not kept in memory

Log sine(std::size_t samples, double uneven = 0.0) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> jitter(-uneven, uneven);
  Log log;
  log.name = "sine";
  for (std::size_t i = 0; i < samples; ++i) {
    const double time = 1e-3 * (static_cast<double>(i) + jitter(generator));
    log.stamp.push_back(std::llround(1e9 * time));
    log.displacement.push_back(1e-3 * std::sin(6.0 * time));
    log.force.push_back(1e6 * log.displacement.back() + 10.0 * std::cos(50.0 * time));
  }
  return log;
}

Log collected(const LogSource& source) {
  Log all;
  all.notes = source.read([&](const Log& block, std::size_t first) {
    EXPECT_EQ(first, all.size());
    EXPECT_LE(block.size(), log::kLogBlock);
    log::appendSamples(block, 0, block.size(), all);
    return true;
  });
  all.name = source.name();
  return all;
}

void expectEqual(const Log& a, const Log& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.stamp, b.stamp);
  EXPECT_EQ(a.displacement, b.displacement);
  EXPECT_EQ(a.force, b.force);
  EXPECT_EQ(a.temperature, b.temperature);
  EXPECT_EQ(a.notes, b.notes);
}

void writeNumbers(hid_t file, const char* name, const std::vector<hsize_t>& size, const std::vector<double>& numbers) {
  const hid_t space = H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr);
  const hid_t dataset = H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  ASSERT_GE(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), 0);
  H5Dclose(dataset);
  H5Sclose(space);
}

TEST(LogSource, GivesALogInMemoryWhole) {
  for (const std::size_t samples : {std::size_t{2}, log::kLogBlock, log::kLogBlock + 1, kLong}) {
    Log log = sine(samples);
    log.notes = {"a note"};
    expectEqual(collected(*log::sourceOf(log)), log);
    expectEqual(collected(*log::sourceOf(Log(log))), log);
  }
}

TEST(LogSource, GivesAFileAsReadLogDoes) {
  const TemporaryFile file("log.csv", "");
  for (const std::size_t samples : {std::size_t{500}, log::kLogBlock, 4 * log::kLogBlock, kLong}) {
    log::writeLogCsv(file.path(), sine(samples));
    const auto source = log::openLog(file.path());
    expectEqual(collected(*source), log::readLog(file.path()));
    expectEqual(collected(*source), log::readLog(file.path()));
  }
}

// One-dimensional datasets and the columns of a matrix are both too long to be kept in memory.
TEST(LogSource, GivesAnHdf5FileAsReadLogDoes) {
  const Log log = sine(kLong);
  const TemporaryFile file("log.h5", "");
  std::vector<double> matrix;
  for (std::size_t i = 0; i < kLong; ++i) {
    matrix.insert(matrix.end(), {1e3 * log.displacement[i], log.force[i]});
  }
  for (const bool wide : {false, true}) {
    const hid_t hdf5 = H5Fcreate(file.path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    if (wide) {
      writeNumbers(hdf5, "measured", {kLong, 2}, matrix);
    } else {
      writeNumbers(hdf5, "displacement_m", {kLong}, log.displacement);
      writeNumbers(hdf5, "force_N", {kLong}, log.force);
    }
    H5Fclose(hdf5);
    const log::LogFormat format =
        wide ? log::makeLogFormat({"displacement=1", "force=2"}, "displacement=mm force=N", 1000.0)
             : log::makeLogFormat({}, "", 1000.0);
    const auto source = log::openLog(file.path(), format);
    expectEqual(collected(*source), log::readLog(file.path(), format));
    expectEqual(collected(*source), log::readLog(file.path(), format));
  }
}

// The file has units and a comment, but no time. Its notes must equal those of readLog().
TEST(LogSource, GivesALongForeignFileAsReadLogDoes) {
  std::string text = "Weg [mm];Kraft [kN]\n";
  for (std::size_t i = 0; i < kLong; ++i) {
    text += std::to_string(i % 7) + ",5;" + std::to_string(i % 11) + '\n';
    text += i == 300000 ? "# a comment\n" : "";
  }
  const TemporaryFile file("log.txt", text);
  const log::LogFormat format = log::makeLogFormat({}, "", 500.0);
  expectEqual(collected(*log::openLog(file.path(), format)), log::readLog(file.path(), format));
}

TEST(LogSource, RefusesABadRowOfALongFileByItsLine) {
  const TemporaryFile file("log.csv", "");
  log::writeLogCsv(file.path(), sine(kLong));
  std::ofstream(file.path(), std::ios::app) << "1e6,1x,1\n";
  const auto source = log::openLog(file.path());
  EXPECT_THAT(messageOf<log::LogError>([&] { collected(*source); }),
              testing::HasSubstr("log.csv:" + std::to_string(kLong + 2) + ": "));
}

TEST(LogSource, IsReadNoFurtherThanAskedFor) {
  const Log log = sine(kLong);
  std::size_t blocks = 0;
  log::sourceOf(log)->read([&](const Log&, std::size_t) { return ++blocks < 2; });
  EXPECT_EQ(blocks, 2U);
}

// Returns a sine with samples 1 ms apart and one pause.
Log withPause(std::size_t before, std::size_t after, std::int64_t pause) {
  Log log = sine(before + after);
  for (std::size_t i = before; i < log.size(); ++i) {
    log.stamp[i] += pause;
  }
  return log;
}

TEST(GapBetweenStamps, BeginsAnewAndIsNotFilled) {
  const Log log = withPause(5000, 3000, 1000000LL * 1000000000);  // a pause of 1e6 s
  EXPECT_EQ(log::stretchesOf(log), (std::vector<std::size_t>{0, 5000}));
  EXPECT_THROW(log::evenRecord(log), log::LogError);
  log::TimeSteps steps;
  steps.add(log);
  const log::EvenSteps even = steps.evenSteps();
  EXPECT_EQ(even.gaps, 1U);
  std::size_t samples = 0;
  std::vector<double> gaps;
  log::EvenBlocks blocks(even);
  const auto take = [&](const log::EvenBlocks::Piece& piece) {
    samples += piece.samples;
    gaps.push_back(piece.gap);
    EXPECT_EQ(piece.displacement[0], log.displacement[gaps.size() == 1 ? 0 : 5000]);
  };
  blocks.add(log, take);
  blocks.finish(take);
  EXPECT_EQ(samples, log.size());
  ASSERT_EQ(gaps.size(), 2U);
  EXPECT_EQ(gaps[0], 0.0);
  // The pause is measured between samples at even steps, whose times equal the stamps up to the jitter.
  EXPECT_NEAR(gaps[1], 1e-9 * static_cast<double>(log.stamp[5000] - log.stamp[4999]), 0.02 * even.dt);
}

TEST(GapBetweenStamps, ShortDropoutsAreNone) {
  EXPECT_EQ(log::stretchesOf(withPause(5000, 3000, 400000000)).size(), 1U);
  EXPECT_EQ(log::stretchesOf(sine(2)).size(), 1U);
}

// 20,000 samples are 10 ns apart and 11,000 are 2 ms apart. Resampling at even steps of 10 ns would give 2.2e9 samples.
TEST(GapBetweenStamps, DenseSamplesAmongOthersTakeNoMemory) {
  Log log = sine(31000);
  for (std::size_t i = 0; i < log.size(); ++i) {
    const auto place = static_cast<std::int64_t>(i);
    log.stamp[i] = i < 20000 ? 10 * place : 200000 + 2000000 * (place - 20000 + 1);
  }
  EXPECT_LE(log::evenRecord(log).size(), 2 * 31000 + 1);
}

// In a creep test, steps that are even in the logarithm of time grow to hours. They are no time gaps.
TEST(GapBetweenStamps, StepsThatGrowAreNone) {
  Log log = sine(400);
  for (std::size_t i = 0; i < log.size(); ++i) {
    log.stamp[i] = std::llround(1e9 * std::pow(10.0, 5.0 * static_cast<double>(i) / 399.0));
  }
  EXPECT_EQ(log::stretchesOf(log).size(), 1U);
  EXPECT_LE(log::evenRecord(log).size(), 20001);
}

TEST(EvenBlocks, AreThoseOfARecord) {
  for (const double uneven : {0.0, 0.005, 0.3}) {
    const Log log = sine(kLong, uneven);
    const log::Record record = log::evenRecord(log);
    log::TimeSteps steps;
    const auto source = log::sourceOf(log);
    source->read([&](const Log& block, std::size_t) {
      steps.add(block);
      return true;
    });
    const log::EvenSteps even = steps.evenSteps();
    EXPECT_EQ(even.as_recorded, uneven < 0.01);
    // Random steps are sorted into at most 16,384 classes, which are up to 64 ns wide here.
    EXPECT_NEAR(even.dt, record.dt, uneven < 0.01 ? 0.0 : 64e-9);
    std::vector<double> displacement;
    std::vector<double> force;
    log::EvenBlocks blocks(even);
    const auto keep = [&](const log::EvenBlocks::Piece& piece) {
      displacement.insert(displacement.end(), piece.displacement, piece.displacement + piece.samples);
      force.insert(force.end(), piece.force, piece.force + piece.samples);
    };
    source->read([&](const Log& block, std::size_t) {
      blocks.add(block, keep);
      return true;
    });
    blocks.finish(keep);
    ASSERT_EQ(displacement.size(), even.samples);
    if (even.as_recorded) {
      EXPECT_EQ(displacement, log.displacement);
      EXPECT_EQ(force, log.force);
      continue;
    }
    // The bounds are the errors A (w h)^2/8 of linear interpolation for amplitude A, angular frequency w and a step h
    // of at most 1.6 ms.
    for (std::size_t i = 0; i < displacement.size(); ++i) {
      const double time = even.dt * static_cast<double>(i) + 1e-9 * static_cast<double>(log.stamp.front());
      ASSERT_NEAR(displacement[i], 1e-3 * std::sin(6.0 * time), 1e-3 * std::pow(6.0 * 1.6e-3, 2) / 8.0) << i;
      ASSERT_NEAR(force[i], 1e3 * std::sin(6.0 * time) + 10.0 * std::cos(50.0 * time),
                  1e3 * std::pow(6.0 * 1.6e-3, 2) / 8.0 + 10.0 * std::pow(50.0 * 1.6e-3, 2) / 8.0)
          << i;
    }
  }
}

}  // namespace
}  // namespace rubber_suspension
