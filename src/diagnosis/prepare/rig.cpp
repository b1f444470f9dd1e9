// The rig's part in the logs of a diagnosis.
#include "diagnosis/prepare/rig.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <iterator>
#include <numeric>

#include "diagnosis/prepare/friction_noise.h"
#include "diagnosis/prepare/rig_noise.h"
#include "fit/fitter.h"
#include "gap/simulate.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/measurement/noise_floor.h"
#include "rubber_suspension/measurement/prepared_log.h"
#include "rubber_suspension/measurement/rig_model.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr int kIterations = 8;              // of the fit by which a start in motion is told
constexpr double kChanceOfNewZeros = 1e-3;  // that zeros which are new in each log look common

std::vector<measurement::Mask> masksOf(const std::vector<log::Record>& records) {
  std::vector<measurement::Mask> masks;
  std::transform(records.begin(), records.end(), std::back_inserter(masks), measurement::maskOf);
  return masks;
}

gap::Forces simulateAt(const std::vector<element::ElementDescription>& elements,
                       const std::vector<log::Record>& records, const std::vector<Eigen::VectorXd>& displacements) {
  std::vector<log::Record> moved = records;
  for (std::size_t r = 0; r < records.size(); ++r) {
    moved[r].displacement = displacements[r];
  }
  return gap::simulate(elements, moved);
}

// The rig's part in each record about a model.
std::vector<measurement::RigFit> fitRig(const measurement::RigModel& rig,
                                        const std::vector<element::ElementDescription>& elements) {
  return rig.fitAll(gap::simulate(elements, rig.records()), [&](const std::vector<Eigen::VectorXd>& displacements) {
    return simulateAt(elements, rig.records(), displacements);
  });
}

// What remains of each log's force on average [N].
std::vector<double> meansLeft(const std::vector<log::Record>& records, const gap::Forces& forces) {
  std::vector<double> means;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const Eigen::VectorXd left = records[r].force - forces[r];
    means.push_back(records[r].counts.size() == 0 ? left.mean()
                                                  : left.dot(records[r].counts) / records[r].counts.sum());
  }
  return means;
}

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Of zeros with a cause, what is new in each log is the rig's.
void takeOutZeros(const std::vector<double>& zeros, double common, std::vector<log::Record>& records) {
  for (std::size_t r = 0; r < records.size(); ++r) {
    records[r].force.array() -= zeros[r] - common;
  }
}

// Zeros and delays that are new in each log scatter as much as they are large; those of a cause do not (Student's t).
bool areCommon(const std::vector<double>& zeros) {
  const auto count = static_cast<double>(zeros.size());
  if (zeros.size() < 3) {
    return false;
  }
  const Eigen::Map<const Eigen::VectorXd> values(zeros.data(), static_cast<Eigen::Index>(zeros.size()));
  const double variance = (values.array() - values.mean()).square().sum() / (count - 1.0);
  if (variance == 0.0) {
    return values.mean() != 0.0;
  }
  const boost::math::students_t distribution(count - 1.0);
  const double statistic = std::abs(values.mean()) / std::sqrt(variance / count);
  return 2.0 * boost::math::cdf(boost::math::complement(distribution, statistic)) < kChanceOfNewZeros;
}

// Force at which Berg's friction of a model slides [N]; 0 without.
double bergForce(const std::vector<element::ElementDescription>& elements) {
  double force = 0.0;
  for (const element::ElementDescription& element : elements) {
    force += element.type == "friction" ? element.value("maximum_force") : 0.0;
  }
  return force;
}

// Berg's friction that a motion before the log left in another state is a zero of up to its own force.
bool areBeyondTolerance(const std::vector<double>& zeros, const std::vector<log::Record>& records,
                        const io::RigTolerance& tolerance, double friction) {
  for (std::size_t r = 0; r < zeros.size(); ++r) {
    const double range = records[r].force.maxCoeff() - records[r].force.minCoeff();
    if (std::abs(zeros[r]) <= io::kTolerated * tolerance.of(range) + friction) {
      return false;
    }
  }
  return true;
}

// What is new of further columns, among the nuisances of a record: orthonormal (Gram and Schmidt).
void addNuisances(const Eigen::MatrixXd& columns, log::Record& record) {
  constexpr double kMatters = 1e-3;  // of the force: less is no nuisance
  for (Eigen::Index j = 0; j < columns.cols(); ++j) {
    const Eigen::VectorXd column = record.withoutRig(columns.col(j));
    const double norm = column.norm();
    if (norm > kMatters * record.force_deviation * std::sqrt(record.counted())) {
      record.nuisances.conservativeResize(column.size(), record.nuisances.cols() + 1);
      record.nuisances.rightCols<1>() = column / norm;
    }
  }
}

void setNuisances(const std::vector<element::ElementDescription>& elements, const io::RigTolerances& tolerances,
                  bool zero_counts, std::vector<log::Record>& records) {
  const auto nuisances = measurement::freeNuisances(
      records, tolerances, zero_counts, gap::simulate(elements, records),
      [&](const std::vector<Eigen::VectorXd>& displacements) { return simulateAt(elements, records, displacements); });
  const auto starts = frictionStarts(elements, records);
  for (std::size_t r = 0; r < records.size(); ++r) {
    records[r].nuisances = nuisances[r];
    addNuisances(starts[r], records[r]);
    records[r].slow_noise = io::kTolerated * tolerances.slow_noise.of(records[r].force_deviation);
  }
}

std::vector<double> noiseBeside(const gap::Forces& forces, const std::vector<log::Record>& records) {
  std::vector<double> noise;
  for (std::size_t r = 0; r < records.size(); ++r) {
    noise.push_back(measurement::relativeFloor(records[r], records[r].force - forces[r]));
  }
  return noise;
}

// Of the noise beside a model, no more than that of one rig can be.
void letNoisyLogsCountLess(const std::vector<element::ElementDescription>& elements, std::vector<log::Record>& training,
                           std::vector<log::Record>& held_out) {
  const std::vector<double> noise = noiseBeside(gap::simulate(elements, training), training);
  const NoiseLimit limit = noiseLimit(noise, training);
  const auto weigh = [&](std::vector<double> left, std::vector<log::Record>& records) {
    for (std::size_t r = 0; r < records.size(); ++r) {
      left[r] = std::min(left[r], limit.of(records[r]));
    }
    weighByNoise(left, records);
  };
  weigh(noise, training);
  if (!held_out.empty()) {
    weigh(noiseBeside(gap::simulateEach(elements, held_out), held_out), held_out);
  }
}

}  // namespace

void freeNuisances(const fit::ModelParameters& model, const io::RigTolerances& tolerances,
                   std::vector<log::Record>& training, std::vector<log::Record>& held_out) {
  setNuisances(model.apply(Eigen::VectorXd::Zero(model.size())).allElements(), tolerances, false, training);
  const fit::Fitter fitter(training, model);
  const fit::Hypothesis alone;
  const fit::ParameterVector parameters = fitter.fit(alone, fitter.configured(alone), kIterations).parameters;
  const auto elements = model.apply(parameters.model).allElements();
  setNuisances(elements, tolerances, false, training);
  setNuisances(elements, tolerances, false, held_out);
  letNoisyLogsCountLess(elements, training, held_out);
}

std::optional<double> zeroWithCause(const std::vector<element::ElementDescription>& elements, double least,
                                    const io::RigTolerances& tolerances, const std::vector<log::Record>& training,
                                    const std::vector<log::Record>& held_out) {
  const std::vector<double> of_training = meansLeft(training, gap::simulate(elements, training));
  const std::vector<double> of_held_out = meansLeft(held_out, gap::simulateEach(elements, held_out));
  std::vector<double> zeros = of_training;
  zeros.insert(zeros.end(), of_held_out.begin(), of_held_out.end());
  const double common = meanOf(zeros);
  double squares = 0.0;
  for (const log::Record& record : training) {
    squares += record.weight * std::pow(common / record.force_deviation, 2) / static_cast<double>(training.size());
  }
  const double friction = bergForce(elements);
  const bool cause = areCommon(zeros) || (areBeyondTolerance(of_training, training, tolerances.force_zero, friction) &&
                                          areBeyondTolerance(of_held_out, held_out, tolerances.force_zero, friction));
  return cause && std::sqrt(squares) > least ? std::optional(common) : std::nullopt;
}

void countZeros(const std::vector<element::ElementDescription>& elements, double common,
                const io::RigTolerances& tolerances, std::vector<log::Record>& training,
                std::vector<log::Record>& held_out) {
  takeOutZeros(meansLeft(training, gap::simulate(elements, training)), common, training);
  takeOutZeros(meansLeft(held_out, gap::simulateEach(elements, held_out)), common, held_out);
  setNuisances(elements, tolerances, true, training);
  setNuisances(elements, tolerances, true, held_out);
}

double leftWithoutZeros(const std::vector<element::ElementDescription>& elements, const io::RigTolerances& tolerances,
                        const std::vector<log::Record>& records) {
  constexpr double kShift = 0.01;  // of the displacement's range, for the derivative by its zero
  const gap::Forces forces = gap::simulate(elements, records);
  std::vector<Eigen::VectorXd> shifted;
  std::vector<double> ranges;
  for (const log::Record& record : records) {
    ranges.push_back(record.displacement.maxCoeff() - record.displacement.minCoeff());
    shifted.emplace_back(record.displacement.array() + kShift * ranges.back());
  }
  const gap::Forces moved = simulateAt(elements, records, shifted);
  double sum = 0.0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const log::Record& record = records[r];
    const double tolerance = tolerances.displacement_zero.of(ranges[r]);
    const Eigen::VectorXd left = record.withoutRig(record.force - forces[r]);
    const Eigen::VectorXd column = record.withoutRig(moved[r] - forces[r]) / (kShift * ranges[r]);
    // The zero of least squares, with the tolerance as prior against what is left.
    const double prior = tolerance > 0.0 ? left.squaredNorm() / record.counted() / (tolerance * tolerance) : HUGE_VAL;
    const double square = column.squaredNorm() + prior;
    const double explained = square > 0.0 ? std::pow(column.dot(left), 2) / square : 0.0;
    sum += record.weight * (left.squaredNorm() - explained) / record.counted() / std::pow(record.force_deviation, 2);
  }
  return std::sqrt(std::max(0.0, sum) / static_cast<double>(records.size()));
}

std::vector<RigPart> rigParts(const std::vector<element::ElementDescription>& elements,
                              const io::RigTolerances& tolerances, const std::vector<log::Record>& records) {
  const measurement::RigModel rig(records, masksOf(records), tolerances);
  const std::vector<measurement::RigFit> fits = fitRig(rig, elements);
  std::vector<RigPart> parts(records.size());
  for (std::size_t r = 0; r < records.size(); ++r) {
    const Eigen::Index delay = fits[r].column(measurement::Nuisance::delay);
    parts[r].delay = delay >= 0 ? fits[r].values[delay] : 0.0;
    for (const measurement::RigFinding& finding : rig.findings(r, fits[r])) {
      if (finding.finding == measurement::finding::kDisplacementZero) {
        parts[r].displacement_zero = finding.value;
        parts[r].findings.push_back(finding);
      } else if (finding.finding == measurement::finding::kDelay && !finding.beyond_tolerance) {
        parts[r].shows_delay = true;
        parts[r].findings.push_back(finding);
      }
    }
  }
  return parts;
}

double commonDelay(const std::vector<RigPart>& parts) {
  std::vector<double> delays(parts.size());
  std::transform(parts.begin(), parts.end(), delays.begin(), [](const RigPart& part) { return part.delay; });
  return areCommon(delays) ? meanOf(delays) : 0.0;
}

bool takeOut(const std::vector<RigPart>& parts, double common_delay, std::vector<log::Record>& records) {
  constexpr double kMatters = 0.05;  // samples: less than the noise of any log shows
  bool any = false;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const double later = parts[r].shows_delay ? (parts[r].delay - common_delay) / records[r].dt : 0.0;
    const bool late = std::abs(later) > kMatters;
    any = any || late || parts[r].displacement_zero != 0.0;
    records[r].lead_in.array() -= parts[r].displacement_zero;
    for (Eigen::VectorXd* displacement : {&records[r].displacement, &records[r].raw_displacement}) {
      displacement->array() -= parts[r].displacement_zero;
      *displacement = late ? measurement::delayed(*displacement, later) : *displacement;
    }
  }
  return any;
}

std::vector<measurement::RigFinding> rigFindings(const std::vector<element::ElementDescription>& elements,
                                                 const io::RigTolerances& tolerances,
                                                 const std::vector<log::Record>& records) {
  const measurement::RigModel rig(records, masksOf(records), tolerances);
  const std::vector<measurement::RigFit> fits = fitRig(rig, elements);
  std::vector<measurement::RigFinding> found;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const auto of_log = rig.findings(r, fits[r]);
    // Parts of an initial state may be beyond chance where their sum, which is told, is not.
    std::copy_if(of_log.begin(), of_log.end(), std::back_inserter(found), [](const measurement::RigFinding& finding) {
      return finding.interval_95[0] > 0.0 || finding.interval_95[1] < 0.0;
    });
    if (const auto colour = measurement::colouredNoiseFinding(records[r].name, fits[r].noise)) {
      found.push_back(*colour);
    }
  }
  return found;
}

}  // namespace rubber_suspension::diagnosis
