// Measured logs of other laboratories have no finding of an error of the bench.
#include <iostream>

#include "log/even_blocks.h"
#include "measurement/perturb.h"
#include "rubber_suspension/measurement/bench_check.h"
#include "rubber_suspension/measurement/noise_floor.h"
#include "rubber_suspension/measurement/rig_model.h"
#include "support/measured_data.h"
#include "support/test.h"

namespace rubber_suspension::measurement {
namespace {

// A measured log. Its elements replace a data sheet: they are estimated from the log without a model.
struct Measured {
  const char* folder;
  const char* file;
  Elements elements;
};

std::vector<Measured> measuredLogs() {
  std::vector<Measured> logs = {{"hdrb", "hdrb_shear_4amplitudes.csv", {spring(1.5e6)}}};
  for (const char* file : {"high_1.csv", "high_3.csv", "high_5.csv", "high_7.csv", "high_9.csv", "low_1.csv",
                           "low_4.csv", "low_7.csv", "low_10.csv"}) {
    logs.push_back({"mr_damper", file, {spring(1e3)}});
  }
  for (const char* file : {"o_ring_1_bar.csv", "o_ring_3_bar.csv", "o_ring_7_bar.csv"}) {
    logs.push_back({"rod_seal", file, {spring(10.0)}});
  }
  for (const char* file : {"shear_relaxation.csv", "shear_relaxation_0d1.csv", "shear_relaxation_1.csv",
                           "shear_relaxation_2.csv", "shear_relaxation_5.csv"}) {
    logs.push_back({"adhesive_film", file, {spring(8e3)}});
  }
  return logs;
}

TEST(MeasuredLogs, GoThrough) {
  for (const Measured& measured : measuredLogs()) {
    const std::string path = measuredData(std::string(measured.folder) + "/" + measured.file);
    SCOPED_TRACE(path);
    if (!std::filesystem::exists(path)) {
      GTEST_SKIP() << "no measured log: " << path << " is missing";
    }
    const log::Log log = log::longestStretch(log::readLog(path));
    const Faults faults = findFaults(log);
    const log::Record record = log::makeRecord(repaired(log, faults));
    const Mask mask = resampled(faults.usable(), log, record);
    const std::vector<RigFinding> wrong = checkBench(measured.elements, {record});
    EXPECT_TRUE(wrong.empty()) << wrong.front().text;
    const RigModel model({record}, {mask}, {});
    const Simulate simulate = [&](const std::vector<Eigen::VectorXd>& displacements) {
      return simulateAll(measured.elements, {record.dt}, displacements);
    };
    const RigFit fit = model.fitAll(simulate({record.displacement}), simulate).front();
    EXPECT_TRUE(fit.residual.allFinite());
    const double floor = noiseFloor(record, fit.residual, mask);
    EXPECT_GT(floor, 0.0);
    EXPECT_LT(floor, record.force_deviation);
    std::cout << measured.folder << "/" << measured.file << ": floor " << floor / record.force_deviation << "\n";
    for (const auto& findings : {faults.findings, model.findings(0, fit)}) {
      for (const RigFinding& finding : findings) {
        std::cout << "  " << finding.finding << ": " << finding.text << "\n";
      }
    }
  }
}

}  // namespace
}  // namespace rubber_suspension::measurement
