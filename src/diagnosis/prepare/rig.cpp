// Computes prior distributions of the errors of the rig in each log.
#include "diagnosis/prepare/rig.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "element/each.h"
#include "fit/fitter.h"
#include "gap/drive.h"
#include "measurement/friction_noise.h"
#include "numerics/gram.h"
#include "numerics/least_squares.h"
#include "numerics/symmetric.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/measurement/noise_floor.h"
#include "rubber_suspension/measurement/prepared_log.h"
#include "rubber_suspension/measurement/rig_model.h"

namespace rubber_suspension::diagnosis::prepare {
namespace {

using Records = std::vector<gap::PreparedRecord>;

constexpr int kIterations = 8;          // iterations of the fit that precedes the priors
constexpr double kBeyond95 = 0.025;     // probability on each side of a 95 % interval
constexpr double kNormal95 = 1.96;      // half width of the 95 % interval of a normal variable, in standard deviations
constexpr std::size_t kFewestLogs = 3;  // least number of logs from which the scatter of offsets is estimated

// Returns the standard deviation of offsets or delays about their mean, because a value that all logs share is no
// scatter of the rig. For few logs the result is increased according to Student's t distribution, so that 95 % of the
// values are within 1.96 standard deviations. Returns infinity for fewer than kFewestLogs values.
double deviationBy(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  if (values.size() < kFewestLogs) {
    return HUGE_VAL;
  }
  const Eigen::Map<const Eigen::VectorXd> all(values.data(), static_cast<Eigen::Index>(values.size()));
  const double scatter = std::sqrt((all.array() - all.mean()).square().sum() / (count - 1.0));
  const boost::math::students_t distribution(count - 1.0);
  return scatter * boost::math::quantile(boost::math::complement(distribution, kBeyond95)) / kNormal95;
}

// Upper bounds of the standard deviations of offsets [N] and delays [s], estimated from their values in all logs.
struct Limits {
  double zero = HUGE_VAL;
  double lag = HUGE_VAL;

  double of(measurement::Nuisance nuisance) const {
    return nuisance == measurement::Nuisance::force_zero ? zero
           : nuisance == measurement::Nuisance::delay    ? lag
                                                         : HUGE_VAL;
  }
};

// Returns the force at which the Berg friction of a model slides [N], or 0 if the model has no such friction.
double bergForce(const std::vector<element::ElementDescription>& elements) {
  double force = 0.0;
  for (const element::ElementDescription& element : elements) {
    force += element.type == "friction" ? element.value("maximum_force") : 0.0;
  }
  return force;
}

// Returns true if a log is able to determine an error of the rig. `deviation` is the force [N] that one standard
// deviation of the error adds. For example, a slow log cannot determine a delay.
bool shows(const log::Record& record, const Eigen::VectorXd& deviation) {
  constexpr double kLeast = 0.01;  // share of the standard deviation of the measured force
  return deviation.norm() > kLeast * record.force_deviation * std::sqrt(static_cast<double>(record.size()));
}

// Appends the offset and the delay of each log. Excerpts with a lead-in are skipped: they share the offset of their
// recording, so that only whole logs show the scatter of offsets.
void addValues(const io::RigTolerances& tolerances, const Records& records, const gap::Forces& simulated,
               std::vector<double>& zeros, std::vector<double>& lags) {
  const measurement::RigModel rig(records, element::each(records, measurement::maskOf), tolerances);
  const auto columns = rig.columns(simulated, {});
  for (std::size_t r = 0; r < records.size(); ++r) {
    if (!records[r].lead_in.displacement.empty()) {
      continue;
    }
    const measurement::RigFit fit = rig.fit(r, columns[r], 0);
    const auto add = [&](measurement::Nuisance nuisance, std::vector<double>& values) {
      const Eigen::Index column = fit.column(nuisance);
      if (column >= 0 && shows(records[r], fit.rig.columns.col(column) * fit.rig.priors[column])) {
        values.push_back(fit.values[column]);
      }
    };
    add(measurement::Nuisance::force_zero, zeros);
    add(measurement::Nuisance::delay, lags);
  }
}

// The initial state of Berg friction depends on earlier motion, so that the friction may offset the force by its
// maximum.
Limits limitsBy(const std::vector<element::ElementDescription>& elements, const io::RigTolerances& tolerances,
                const Records& training, const Records& held_out) {
  std::vector<double> zeros;
  std::vector<double> lags;
  addValues(tolerances, training, gap::simulate(elements, training), zeros, lags);
  addValues(tolerances, held_out, gap::simulateEach(elements, held_out), zeros, lags);
  return {std::hypot(deviationBy(zeros), bergForce(elements)), deviationBy(lags)};
}

// Returns the first cosine terms of a random walk without mean over the log [N]. If their coefficients have a standard
// deviation of 1, the sum of the terms has the given standard deviation [N].
Eigen::MatrixXd slowNoise(const log::Record& record, double deviation) {
  constexpr Eigen::Index kCosines = 8;
  const double samples = static_cast<double>(record.size());
  Eigen::MatrixXd columns(record.size(), kCosines);
  double squares = 0.0;
  for (Eigen::Index k = 0; k < kCosines; ++k) {
    const double order = static_cast<double>(k + 1);
    columns.col(k) =
        (Eigen::ArrayXd::LinSpaced(record.size(), 0.5, samples - 0.5) * (element::kPi * order / samples)).cos() / order;
    squares += 0.5 / (order * order);
  }
  return columns * (deviation / std::sqrt(squares));
}

// Returns one column per error that the rig may have added: the force [N] of one standard deviation of the error.
// Offsets of the displacement are omitted, because their effect on the force depends on the law.
Eigen::MatrixXd deviationsOf(const measurement::RigColumns& rig, const Limits& limits, const gap::OwnErrors& own,
                             const Eigen::MatrixXd& starts, const Eigen::MatrixXd& slow) {
  Eigen::MatrixXd columns(slow.rows(), rig.columns.cols() + starts.cols() + slow.cols());
  Eigen::Index used = 0;
  for (Eigen::Index j = 0; j < rig.columns.cols(); ++j) {
    const measurement::Nuisance nuisance = rig.nuisances[static_cast<std::size_t>(j)];
    if (nuisance != measurement::Nuisance::displacement_zero) {
      const bool any = own.zero && nuisance == measurement::Nuisance::force_zero;
      columns.col(used++) = rig.columns.col(j) * (any ? rig.priors[j] : std::min(rig.priors[j], limits.of(nuisance)));
    }
  }
  columns.middleCols(used, starts.cols()) = starts;
  columns.middleCols(used + starts.cols(), slow.cols()) = slow;
  return columns.leftCols(used + starts.cols() + slow.cols());
}

// Returns the tolerance of an offset of the displacement [m], or 0 for an excerpt, because a log has a single offset.
double zeroOfDisplacement(const log::Record& record, const io::RigTolerances& tolerances) {
  const double range = record.displacement.maxCoeff() - record.displacement.minCoeff();
  return record.lead_in.displacement.empty() ? tolerances.displacement_zero.of(range) : 0.0;
}

std::vector<gap::RigPrior> priorsOf(const std::vector<element::ElementDescription>& elements,
                                    const gap::Forces& simulated, const io::RigTolerances& tolerances,
                                    const Limits& limits, const std::vector<double>& one_deviation,
                                    const Records& records) {
  const auto rig = measurement::RigModel(records, {}, tolerances)
                       .columns(simulated, [&](const std::vector<Eigen::VectorXd>& displacements) {
                         return gap::simulate(elements, records, gap::drivenBy(displacements, records));
                       });
  const auto starts = measurement::frictionStarts(elements, records);
  std::vector<gap::RigPrior> priors;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const gap::PreparedRecord& record = records[r];
    const double slow = tolerances.slow_noise.of(record.force_deviation);
    Eigen::MatrixXd columns = deviationsOf(rig[r], limits, record.own, starts[r], slowNoise(record, slow));
    columns /= one_deviation[r] * record.force_deviation * std::sqrt(record.counted());
    if (record.counts.size() > 0) {
      columns.array().colwise() *= record.counts.array();
    }
    priors.push_back({numerics::whiteningColumns(columns), one_deviation[r], io::kTolerated * slow,
                      zeroOfDisplacement(record, tolerances)});
  }
  return priors;
}

Records withRig(Records records, std::vector<gap::RigPrior> priors,
                const std::vector<measurement::LogWeight>& weights = {}) {
  for (std::size_t r = 0; r < records.size(); ++r) {
    records[r].rig = std::move(priors[r]);
    if (!weights.empty()) {
      records[r].weight = weights[r].weight;
    }
    if (!weights.empty() && !weights[r].note.empty()) {
      records[r].notes.push_back(weights[r].note);
    }
  }
  return records;
}

std::vector<double> noiseBeside(const gap::Forces& forces, const Records& records) {
  std::vector<double> noise;
  for (std::size_t r = 0; r < records.size(); ++r) {
    noise.push_back(measurement::relativeFloor(records[r], records[r].force - forces[r]));
  }
  return noise;
}

// Noise floors of logs relative to a model, limited to what is plausible for a single rig.
struct Noise {
  std::vector<double> training;
  std::vector<double> held_out;
};

Noise noiseOf(const std::vector<element::ElementDescription>& elements, const Records& training,
              const Records& held_out) {
  Noise noise{noiseBeside(gap::simulate(elements, training), training),
              noiseBeside(gap::simulateEach(elements, held_out), held_out)};
  const measurement::NoiseLimit limit = measurement::noiseLimit(noise.training, training);
  const auto bound = [&](const Records& records, std::vector<double>& left) {
    for (std::size_t r = 0; r < records.size(); ++r) {
      left[r] = std::min(left[r], limit.of(records[r]));
    }
  };
  bound(training, noise.training);
  bound(held_out, noise.held_out);
  return noise;
}

std::vector<double> oneDeviations(const measurement::ErrorScale& scale, const std::vector<double>& floors,
                                  std::size_t logs) {
  return element::each(floors, [&](double floor) { return scale.oneDeviation(floor, logs); });
}

}  // namespace

LogsOfRig withRigPriors(const fit::ModelParameters& model, const io::RigTolerances& tolerances,
                        const measurement::ErrorScale& scale, Records of_the_fit, Records unseen, RigScatter scatter) {
  const std::size_t logs = of_the_fit.size();
  const auto configured = model.apply(Eigen::VectorXd::Zero(model.size())).allElements();
  auto about_configured = priorsOf(configured, gap::simulate(configured, of_the_fit), tolerances, {},
                                   oneDeviations(scale, std::vector<double>(logs, 0.0), logs), of_the_fit);
  of_the_fit = withRig(std::move(of_the_fit), std::move(about_configured));
  const fit::ParameterVector parameters =
      fit::Fitter(of_the_fit, model, scale.oneOfSheet()).fitAlone({kIterations}).parameters;
  const auto elements = model.apply(parameters.model).allElements();
  const Noise noise = noiseOf(elements, of_the_fit, unseen);
  const Limits limits = scatter == RigScatter::as_found ? limitsBy(elements, tolerances, of_the_fit, unseen) : Limits();
  const auto prepared = [&](Records records, const gap::Forces& simulated, const std::vector<double>& floors) {
    auto priors = priorsOf(elements, simulated, tolerances, limits, oneDeviations(scale, floors, logs), records);
    return withRig(std::move(records), std::move(priors), measurement::weightsByNoise(floors, scale.accepted));
  };
  const gap::Forces forces = gap::simulate(elements, of_the_fit);
  const gap::Forces of_unseen = gap::simulateEach(elements, unseen);
  return {prepared(std::move(of_the_fit), forces, noise.training),
          prepared(std::move(unseen), of_unseen, noise.held_out)};
}

}  // namespace rubber_suspension::diagnosis::prepare
