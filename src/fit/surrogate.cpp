// Ridge regression on the functions of a residual element.
#include "fit/surrogate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "element/each.h"
#include "fit/normal_equations.h"
#include "fit/parallel.h"
#include "numerics/least_squares.h"
#include "numerics/symmetric.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::fit {
namespace {

using element::ResidualBasis;

constexpr double kMostRows = 40000.0;      // equations; more are redundant, because neighbouring samples are similar
constexpr std::size_t kPoints = 32;        // number of points of the characteristic
constexpr double kWidestStop = 0.7;        // share of the stroke; wider stops hardly reverse
constexpr double kNarrowestStop = 0.02;    // share of the stroke below which no stop is tried
constexpr double kNoiseInStop = 6.0;       // dead band in standard deviations of the sensor's noise
constexpr double kLowestResonance = 0.2;   // share of the highest frequency of the motion
constexpr double kHighestResonance = 1.3;  // share of the highest frequency; the motion excites no higher resonances
constexpr double kFewerFunctionsBetter = 0.95;  // ratio of errors below which more functions are preferred
constexpr std::size_t kFewestLogs = 3;          // with this number of logs or more, each log is held out in turn
constexpr std::array<double, 8> kRidges = {1e-7, 1e-6, 1e-5, 1e-4,
                                           1e-3, 1e-2, 1e-1, 1.0};  // share of a function's mean square

template <std::size_t Size>
std::array<double, Size> geometric(double first, double last) {
  std::array<double, Size> values{};
  for (std::size_t i = 0; i < Size; ++i) {
    values[i] = first * std::pow(last / first, static_cast<double>(i) / static_cast<double>(Size - 1));
  }
  return values;
}

Eigen::Index strideOf(const std::vector<gap::PreparedRecord>& records) {
  double samples = 0.0;
  for (const log::Record& record : records) {
    samples += static_cast<double>(record.size());
  }
  return std::max<Eigen::Index>(1, static_cast<Eigen::Index>(std::ceil(samples / kMostRows)));
}

// Returns every `stride`-th sample of a record. The prior of the rig's errors is kept, in units for the smaller number
// of samples.
gap::PreparedRecord thinned(const gap::PreparedRecord& record, Eigen::Index stride) {
  const auto kept = Eigen::seq(0, Eigen::last, stride);
  gap::PreparedRecord result = record;
  result.dt *= static_cast<double>(stride);
  for (Eigen::VectorXd* const channel :
       {&result.displacement, &result.raw_displacement, &result.force, &result.counts}) {
    *channel = (*channel)(kept).eval();
  }
  if (stride > 1 && record.rig.columns.cols() > 0) {
    const Eigen::MatrixXd columns = numerics::columnsOfWhitening(record.rig.columns);
    result.rig.columns =
        numerics::whiteningColumns(columns(kept, Eigen::all) * std::sqrt(record.counted() / result.counted()));
  }
  return result;
}

// Returns the values of the functions at every `stride`-th sample of a record.
Eigen::MatrixXd functionsOver(const ResidualBasis& basis, const log::Record& record, Eigen::Index stride) {
  const Eigen::VectorXd& z = record.raw_displacement;
  Eigen::MatrixXd by_sample(basis.size(), (z.size() + stride - 1) / stride);
  std::vector<double> memory(ResidualBasis::kMemorySize);
  basis.initialise(z[0], memory.data());
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    if (i > 0) {
      basis.advance({record.dt, z[i], z[i] - z[i - 1]}, memory.data());
    }
    if (i % stride == 0) {
      basis.evaluate(memory.data(), by_sample.col(i / stride));
    }
  }
  return by_sample.transpose();
}

std::vector<ForceColumn> columnsOf(const std::vector<Eigen::MatrixXd>& functions) {
  std::vector<ForceColumn> columns;
  for (Eigen::Index j = 0; j < functions[0].cols(); ++j) {
    columns.push_back(columnOf(element::each(
        functions, [&](const Eigen::MatrixXd& of_record) -> Eigen::VectorXd { return of_record.col(j); })));
  }
  return columns;
}

struct Choice {
  std::vector<Eigen::Index> functions;
  double ridge = 0.0;
  double error = std::numeric_limits<double>::infinity();  // held-out mean square error
};

/// Normal equations with each function scaled to a mean square of 1, from which any ridge regression follows.
class RidgeRegression {
 public:
  RidgeRegression(BlockGrams blocks, std::size_t records) : blocks_(std::move(blocks)) {
    const Eigen::VectorXd squares = blocks_.sum.diagonal();
    // A function that is always 0 is given no weight.
    scale_ = squares.unaryExpr([](double square) { return square > 0.0 ? 1.0 / std::sqrt(square) : 0.0; });
    scale_.tail<1>().setOnes();
    for (Eigen::MatrixXd& gram : blocks_.gram) {
      gram = scale_.asDiagonal() * gram * scale_.asDiagonal();
    }
    if (records >= kFewestLogs) {
      blocks_.fold = blocks_.record;
    }
    blocks_.sumUp();
  }

  /// Returns the ridge with the smallest held-out error for these functions.
  Choice bestRidge(const std::vector<Eigen::Index>& functions) const {
    const BlockGrams part = blocks_.of(functions);
    Choice best;
    for (const double ridge : kRidges) {
      const std::vector<double> errors = predict(part, ridge);
      const double error = std::inner_product(errors.begin(), errors.end(), part.weight.begin(), 0.0);
      if (error < best.error) {
        best = {functions, ridge, error};
      }
    }
    return best;
  }

  std::vector<UnseenBlock> predict(const Choice& choice) const {
    const std::vector<double> errors = predict(blocks_.of(choice.functions), choice.ridge);
    std::vector<UnseenBlock> unseen;
    for (std::size_t b = 0; b < errors.size(); ++b) {
      const double weight = blocks_.weight[b];
      unseen.push_back(
          {blocks_.record[b], weight, blocks_.gram[b].bottomRightCorner<1, 1>().value() / weight, errors[b]});
    }
    return unseen;
  }

  /// Returns the mean square error without a surrogate.
  double errorBefore() const { return blocks_.sum.bottomRightCorner<1, 1>().value(); }

  /// Returns the weight of each function [N].
  Eigen::VectorXd weights(const Choice& choice) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(scale_.size() - 1);
    result(choice.functions) = solveRidge(ofUnknowns(blocks_.sum, choice.functions), choice.ridge);
    return result.cwiseProduct(scale_.head(result.size()));
  }

 private:
  static Eigen::VectorXd solveRidge(const Eigen::MatrixXd& gram, double ridge) {
    const Eigen::Index last = gram.cols() - 1;
    Eigen::MatrixXd of_functions = gram.topLeftCorner(last, last);
    of_functions.diagonal().array() += ridge;
    return numerics::Cholesky(of_functions).solve(Eigen::VectorXd(gram.col(last).head(last)));
  }

  static std::vector<double> predict(const BlockGrams& part, double ridge) {
    return crossValidate(part, [&](const Eigen::MatrixXd& gram) { return solveRidge(gram, ridge); });
  }

  BlockGrams blocks_;
  Eigen::VectorXd scale_;
};

// Chooses products alone, with characteristic, with resonators, or with both; more functions have to predict better.
Choice chooseFunctions(const RidgeRegression& regression, const ResidualBasis& basis) {
  constexpr auto kProducts = static_cast<Eigen::Index>(ResidualBasis::kStates * ResidualBasis::kFactors);
  const Eigen::Index resonators = kProducts + static_cast<Eigen::Index>(basis.layout().points);
  Choice best;
  for (const bool resonant : {false, true}) {
    for (const bool characteristic : {false, true}) {
      std::vector<Eigen::Index> functions;
      for (Eigen::Index j = 0; j < basis.size(); ++j) {
        if (j < kProducts || (j < resonators ? characteristic : resonant)) {
          functions.push_back(j);
        }
      }
      const Choice choice = regression.bestRidge(functions);
      if (choice.error < std::pow(kFewerFunctionsBetter, 2) * best.error) {
        best = choice;
      }
    }
  }
  return best;
}

// Describes the functions, without resonators if all weights of resonators are 0.
element::ElementDescription describeElement(const ResidualBasis& basis, const Eigen::VectorXd& weights,
                                            const std::vector<Eigen::MatrixXd>& functions) {
  double lowest = 0.0;
  double highest = 0.0;
  for (const Eigen::MatrixXd& of_record : functions) {
    const Eigen::VectorXd force = of_record * weights;
    lowest = std::min(lowest, force.minCoeff());
    highest = std::max(highest, force.maxCoeff());
  }
  ResidualBasis::Layout layout = basis.layout();
  layout.resonant = !weights.tail(2 * static_cast<Eigen::Index>(ResidualBasis::kResonators)).isZero(0.0);
  const ResidualBasis needed(layout);
  return element::residualDescription(needed, weights.head(needed.size()), lowest, highest);
}

}  // namespace

ResidualBasis::Layout surrogateLayout(const std::vector<gap::PreparedRecord>& records) {
  ResidualBasis::Layout layout;
  double noise = 0.0;
  double highest_frequency = 0.0;
  double lowest_frequency = std::numeric_limits<double>::infinity();
  double mean_logarithm = 0.0;
  for (const log::Record& record : records) {
    layout.lowest = std::min(layout.lowest, record.raw_displacement.minCoeff());
    layout.highest = std::max(layout.highest, record.raw_displacement.maxCoeff());
    noise = std::max(noise, record.displacement_noise);
    highest_frequency = std::max(highest_frequency, record.highest_frequency);
    lowest_frequency = std::min(lowest_frequency, record.mean_frequency);
    mean_logarithm += std::log(record.mean_frequency) / static_cast<double>(records.size());
  }
  layout.stroke = std::max(layout.highest, -layout.lowest);
  const double narrowest = std::clamp(kNoiseInStop * noise / layout.stroke, kNarrowestStop, 0.5 * kWidestStop);
  layout.stops = geometric<ResidualBasis::kStops>(narrowest, kWidestStop);
  highest_frequency = std::max(highest_frequency, 2.0 * lowest_frequency);
  layout.times = geometric<ResidualBasis::kRelaxing>(0.5 / (element::kPi * highest_frequency), 1.0 / lowest_frequency);
  layout.amplitude_time = std::exp(-mean_logarithm);
  layout.resonant = true;
  layout.frequencies = geometric<ResidualBasis::kResonators>(kLowestResonance * highest_frequency,
                                                             kHighestResonance * highest_frequency);
  layout.points = kPoints;
  return layout;
}

SurrogateFit fitSurrogate(const std::vector<gap::PreparedRecord>& records,
                          const std::vector<Eigen::VectorXd>& simulated, int threads) {
  const ResidualBasis basis(surrogateLayout(records));
  const Eigen::Index stride = strideOf(records);
  const std::size_t count = records.size();
  std::vector<gap::PreparedRecord> thin_records(count);
  std::vector<Eigen::VectorXd> base(count);
  std::vector<Eigen::MatrixXd> functions(count);
  std::vector<double> weights(count);
  parallelFor(count, threads, [&](std::size_t r) {
    thin_records[r] = thinned(records[r], stride);
    base[r] = simulated[r](Eigen::seq(0, Eigen::last, stride));
    functions[r] = functionsOver(basis, records[r], stride);
    weights[r] = std::sqrt(records[r].weight / (thin_records[r].counted() * static_cast<double>(count))) /
                 records[r].force_deviation;
  });
  const LogBlocks blocks(thin_records, weights);
  std::vector<BlockGrams> equations =
      blocks.normalEquations(base, columnsOf(functions), {PerLogNuisances{}}, Kept::blocks, threads);
  const RidgeRegression regression(std::move(equations.front()), count);
  const Choice choice = chooseFunctions(regression, basis);
  SurrogateFit fit;
  fit.unseen = regression.predict(choice);
  fit.predicts = choice.error < regression.errorBefore();
  const Eigen::VectorXd found = fit.predicts ? regression.weights(choice) : Eigen::VectorXd::Zero(basis.size());
  fit.element = describeElement(basis, found, functions);
  return fit;
}

}  // namespace rubber_suspension::fit
