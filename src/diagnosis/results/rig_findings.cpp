// Finds errors of the rig in the residual of a judged model.
#include "diagnosis/results/rig_findings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "element/each.h"
#include "fit/parallel.h"
#include "gap/drive.h"
#include "numerics/gram.h"
#include "numerics/symmetric.h"
#include "rubber_suspension/measurement/noise_floor.h"
#include "rubber_suspension/measurement/noise_model.h"
#include "rubber_suspension/measurement/prepared_log.h"
#include "rubber_suspension/measurement/rig_model.h"

namespace rubber_suspension::diagnosis::results {
namespace {

// Repeats the estimate of the errors of the rig with the accepted error of the model as the noise, because the error of
// a model does not average out over many samples.
void allowError(const gap::PreparedRecord& record, measurement::RigFit& fit) {
  const double unit = record.rig.one_deviation * record.force_deviation * std::sqrt(record.counted());
  Eigen::MatrixXd columns = fit.rig.columns * (fit.rig.priors / unit).asDiagonal();
  Eigen::VectorXd residual = (record.force - fit.rig.base) / unit;
  if (record.counts.size() > 0) {
    columns.array().colwise() *= record.counts.array();
    residual.array() *= record.counts.array();
  }
  const Eigen::Index count = columns.cols();
  const numerics::Cholesky factor(numerics::gramOf(columns) + Eigen::MatrixXd::Identity(count, count));
  fit.values = fit.rig.priors.cwiseProduct(factor.solve(Eigen::VectorXd(columns.transpose() * residual)));
  fit.covariance = fit.rig.priors.asDiagonal() *
                   factor.solve(Eigen::MatrixXd(Eigen::MatrixXd::Identity(count, count))) * fit.rig.priors.asDiagonal();
}

// Fits the errors of the rig in each record to the residual of a model.
std::vector<measurement::RigFit> fitRig(const measurement::RigModel& rig,
                                        const std::vector<element::ElementDescription>& elements) {
  auto fits =
      rig.fitAll(gap::simulate(elements, rig.records()), [&](const std::vector<Eigen::VectorXd>& displacements) {
        return gap::simulate(elements, rig.records(), gap::drivenBy(displacements, rig.records()));
      });
  for (std::size_t r = 0; r < fits.size(); ++r) {
    allowError(rig.records()[r], fits[r]);
  }
  return fits;
}

// Tests the interval of the reported sum. Parts of an initial state may each exceed chance while their sum does not.
bool isBeyondChance(const measurement::RigFinding& finding) {
  return finding.interval_95[0] > 0.0 || finding.interval_95[1] < 0.0;
}

// Returns true if the verdict attributes the error to this log alone. No second model then has to confirm the error.
bool isOwn(const measurement::RigFinding& finding, const gap::OwnErrors& own) {
  return (own.gain && finding.finding == measurement::finding::kSensorGain) ||
         (own.zero && finding.finding == measurement::finding::kForceZero);
}

// Returns true if another model finds the same error with a value within the interval of the finding.
bool agrees(const measurement::RigFinding& finding, const std::vector<measurement::RigFinding>& others) {
  return std::any_of(others.begin(), others.end(), [&](const measurement::RigFinding& other) {
    return other.finding == finding.finding && other.value >= finding.interval_95[0] &&
           other.value <= finding.interval_95[1];
  });
}

}  // namespace

std::vector<measurement::RigFinding> rigFindings(const std::vector<element::ElementDescription>& judged,
                                                 const std::vector<element::ElementDescription>& rival,
                                                 const io::RigTolerances& tolerances,
                                                 const std::vector<gap::PreparedRecord>& records, int threads) {
  const measurement::RigModel rig(records, element::each(records, measurement::maskOf), tolerances);
  std::array<std::vector<measurement::RigFit>, 2> by;
  fit::parallelFor(by.size(), threads, [&](std::size_t i) { by[i] = fitRig(rig, i == 0 ? judged : rival); });
  const auto& [fits, by_rival] = by;
  std::vector<measurement::RigFinding> found;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const auto of_log = rig.findings(r, fits[r]);
    const auto of_rival = rig.findings(r, by_rival[r]);
    std::copy_if(of_log.begin(), of_log.end(), std::back_inserter(found), [&](const measurement::RigFinding& finding) {
      return isBeyondChance(finding) && (isOwn(finding, records[r].own) || agrees(finding, of_rival));
    });
  }
  return found;
}

ColouredNoise colouredNoise(const std::vector<gap::PreparedRecord>& records, const gap::Forces& simulated) {
  constexpr double kPrior = 0.02;  // prior probability that a rig has such noise
  constexpr double kReported = 0.9;
  std::vector<Eigen::VectorXd> residuals;
  double evidence = 0.0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    residuals.push_back(records[r].withoutRig(records[r].force - simulated[r]));
    const auto of_log = measurement::evidenceOfNoise(records[r], residuals[r], measurement::maskOf(records[r]));
    if (!of_log) {
      return {};  // noise of an amplifier would be in every log
    }
    evidence += *of_log;
  }
  if (evidence < std::log(kReported / (1.0 - kReported) * (1.0 - kPrior) / kPrior)) {
    return {};
  }
  ColouredNoise noise;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const auto model = measurement::estimateNoise(residuals[r], measurement::maskOf(records[r]));
    const auto finding = measurement::colouredNoiseFinding(records[r].name, model);
    noise.floors.push_back(finding ? model.deviation / records[r].force_deviation : 0.0);
    if (finding) {
      noise.findings.push_back(*finding);
    }
  }
  return noise;
}

}  // namespace rubber_suspension::diagnosis::results
