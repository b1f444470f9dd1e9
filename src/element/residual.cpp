// Surrogate for the force that no other element explains.
#include "rubber_suspension/element/residual.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "element/registry.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::element {
namespace {

constexpr const char* kResidualName = "residual";
constexpr std::size_t kStops = ResidualBasis::kStops;
constexpr std::size_t kRelaxing = ResidualBasis::kRelaxing;
constexpr std::size_t kResonators = ResidualBasis::kResonators;
constexpr std::size_t kStates = ResidualBasis::kStates;
constexpr std::size_t kFactors = ResidualBasis::kFactors;
constexpr std::size_t kProducts = kStates * kFactors;

// Bounds that keep every number finite, far beyond the values of any log.
constexpr double kShortestTime = 1e-9;     // [s]
constexpr double kHighestFrequency = 1e9;  // [Hz]
constexpr double kShortestStroke = 1e-12;  // [m]
constexpr double kNarrowestRange = 1e-3;   // narrowest range of displacements, in strokes

// Positions in the memory of the coefficients of the resonators for one step length.
enum Turn : std::size_t {
  kKept = ResidualBasis::kTurn,
  kTurned = kKept + kResonators,
  kDamped = kTurned + kResonators,
  kPushed = kDamped + kResonators,
  kDragged = kPushed + kResonators,
};

using Stops = Eigen::Array<double, kStops, 1>;
using Relaxing = Eigen::Array<double, kRelaxing, 1>;
using Resonators = Eigen::Array<double, kResonators, 1>;
using States = Eigen::Array<double, kStops + kRelaxing, 1>;

template <class Part>
Eigen::Map<Part> at(double* memory, std::size_t slot) {
  return Eigen::Map<Part>(memory + slot);
}

template <class Part>
Eigen::Map<const Part> at(const double* memory, std::size_t slot) {
  return Eigen::Map<const Part>(memory + slot);
}

void advanceResonators(double increment, double* memory) {
  const Resonators x = at<Resonators>(memory, ResidualBasis::kPosition);
  const Resonators v = at<Resonators>(memory, ResidualBasis::kVelocity);
  const auto turned = at<Resonators>(memory, kTurned);
  at<Resonators>(memory, ResidualBasis::kPosition) =
      at<Resonators>(memory, kKept) * x - turned * v + at<Resonators>(memory, kPushed) * increment;
  at<Resonators>(memory, ResidualBasis::kVelocity) =
      turned * x + at<Resonators>(memory, kDamped) * v + at<Resonators>(memory, kDragged) * increment;
}

void checkSize(const char* parameter, std::size_t size, std::size_t accepted) {
  if (size != accepted) {
    throw std::invalid_argument(
        fmt::format("{}.{}: has {} values; accepted: {} values", kResidualName, parameter, size, accepted));
  }
}

template <std::size_t Size>
std::array<double, Size> listOf(const ElementDescription& description, const char* parameter) {
  const std::vector<double>& values = description.list(parameter);
  checkSize(parameter, values.size(), Size);
  std::array<double, Size> result{};
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

bool isNone(const std::vector<double>& values) { return values.size() == 1 && values[0] == 0.0; }

// Reads the parameters of the resonators, which have the single value 0 if there are no resonators.
void readResonators(const ElementDescription& description, ResidualBasis::Layout& layout, Residual::Weights& weights) {
  layout.resonant = !isNone(description.list("resonances"));
  if (!layout.resonant) {
    if (!isNone(description.list("resonance_weights"))) {
      throw std::invalid_argument(
          fmt::format("{}.resonance_weights: has {} values, but there are no resonances; accepted: a single 0",
                      kResidualName, description.list("resonance_weights").size()));
    }
    return;
  }
  layout.frequencies = listOf<kResonators>(description, "resonances");
  for (const double frequency : layout.frequencies) {
    if (!(frequency > 0.0)) {
      refuseValue(kResidualName, "resonances", frequency, "Hz", "greater than 0, or a single 0 for no resonators");
    }
  }
  weights.resonators = description.list("resonance_weights");
}

ElementPointer makeResidual(const ElementDescription& description) {
  ResidualBasis::Layout layout;
  Residual::Weights weights;
  layout.stroke = description.value("stroke");
  layout.lowest = description.value("lowest");
  layout.highest = description.value("highest");
  layout.stops = listOf<kStops>(description, "stops");
  layout.times = listOf<kRelaxing>(description, "relaxation_times");
  layout.amplitude_time = description.value("amplitude_time");
  layout.damping = description.value("resonance_damping");
  weights.products = description.list("weights");
  weights.characteristic = description.list("characteristic");
  weights.lowest_force = description.value("lowest_force");
  weights.highest_force = description.value("highest_force");
  layout.points = weights.characteristic.size();
  readResonators(description, layout, weights);
  return std::make_shared<const Residual>(layout, weights);
}

template <class List>
std::vector<double> vectorOf(const List& list) {
  return {list.begin(), list.end()};
}

}  // namespace

ResidualBasis::ResidualBasis(const Layout& layout)
    : layout_(layout), per_stroke_(1.0 / layout.stroke), stops_(layout.stops.data()) {
  if (layout.points < 2) {
    throw std::invalid_argument(
        fmt::format("{}.characteristic: has {} values; accepted: at least 2 values", kResidualName, layout.points));
  }

  if (layout.lowest < -layout.stroke) {
    refuseValue(kResidualName, "lowest", layout.lowest, "m",
                fmt::format("in [{:g}, 0], which is within the stroke", -layout.stroke));
  }
  const double narrowest = layout.lowest + kNarrowestRange * layout.stroke;
  if (layout.highest < narrowest || layout.highest > layout.stroke) {
    refuseValue(kResidualName, "highest", layout.highest, "m",
                fmt::format("in [{:g}, {:g}], which is above lowest and within the stroke", narrowest, layout.stroke));
  }
  spacing_ = static_cast<double>(layout.points - 1) * layout.stroke / (layout.highest - layout.lowest);
  lowest_share_ = layout.lowest * per_stroke_;
  last_point_ = static_cast<double>(layout.points - 1);
  rates_ = Relaxing(layout.times.data()).inverse();
  half_omega_ = kPi * Resonators(layout.frequencies.data());
}

double ResidualBasis::shareOf(double displacement) const {
  return std::min(std::max(displacement, layout_.lowest), layout_.highest) * per_stroke_;
}

void ResidualBasis::initialise(double displacement, double* memory) const {
  std::fill(memory, memory + kMemorySize, 0.0);
  memory[kShare] = shareOf(displacement);
  memory[kAmplitude] = std::abs(memory[kShare]);
}

// Approximates exp(-x) by 1/(1 + x + x^2/2), and its mean accordingly. Both are positive at any step length.
void ResidualBasis::prepare(double dt, double* memory) const {
  memory[kStepLength] = dt;
  memory[kAmplitudeDecay] = layout_.amplitude_time / (layout_.amplitude_time + dt);
  const Relaxing x = dt * rates_;
  const Relaxing half = 1.0 + 0.5 * x;
  const Relaxing decay = (1.0 + x * half).inverse();
  at<Relaxing>(memory, kDecay) = decay;
  at<Relaxing>(memory, kMean) = half * decay;
  if (layout_.resonant) {
    prepareResonators(dt, memory);
  }
}

// Computes the coefficients of the trapezoidal rule for e' = A e + (q', 0), e = (x, v), A = ((0, -omega), (omega, -2 D
// omega)), which is stable at any step length.
void ResidualBasis::prepareResonators(double dt, double* memory) const {
  const Resonators c = dt * half_omega_;
  const Resonators loss = 2.0 * layout_.damping * c;
  const Resonators scale = (1.0 + loss + c * c).inverse();
  at<Resonators>(memory, kKept) = (1.0 + loss - c * c) * scale;
  at<Resonators>(memory, kTurned) = 2.0 * c * scale;
  at<Resonators>(memory, kDamped) = (1.0 - loss - c * c) * scale;
  at<Resonators>(memory, kPushed) = (1.0 + loss) * scale;
  at<Resonators>(memory, kDragged) = c * scale;
}

void ResidualBasis::advance(const Motion& motion, double* memory) const {
  if (motion.dt != memory[kStepLength]) {
    prepare(motion.dt, memory);
  }
  const double share = shareOf(motion.displacement);
  const double before = memory[kShare];
  const double increment = share - before;
  memory[kShare] = share;
  auto stops = at<Stops>(memory, kStop);
  stops = (stops + increment).max(-stops_).min(stops_);
  auto relaxed = at<Relaxing>(memory, kRelaxed);
  relaxed = at<Relaxing>(memory, kDecay) * relaxed + at<Relaxing>(memory, kMean) * increment;
  memory[kAmplitude] = std::abs(share) + (memory[kAmplitude] - std::abs(share)) * memory[kAmplitudeDecay];
  if (layout_.resonant) {
    advanceResonators(increment, memory);
  }
}

Eigen::Index ResidualBasis::size() const {
  return static_cast<Eigen::Index>(kProducts + layout_.points + (layout_.resonant ? 2 * kResonators : 0));
}

ResidualBasis::Place ResidualBasis::placeOf(double share_of_stroke) const {
  const double place = std::min(std::max(0.0, (share_of_stroke - lowest_share_) * spacing_), last_point_);
  const Eigen::Index point = std::min(static_cast<Eigen::Index>(place), static_cast<Eigen::Index>(layout_.points) - 2);
  return {point, place - static_cast<double>(point)};
}

void ResidualBasis::evaluate(const double* memory, Eigen::Ref<Eigen::VectorXd> values) const {
  constexpr auto kCount = static_cast<Eigen::Index>(kProducts);
  const double share = memory[kShare];
  const Eigen::Matrix<double, kFactors, 1> factors(1.0, share, share * share, memory[kAmplitude]);
  Eigen::Matrix<double, kStates, 1> states;
  states << at<States>(memory, kStop), share;
  Eigen::Map<Eigen::Matrix<double, kFactors, kStates>>(values.data()).noalias() = factors * states.transpose();
  auto characteristic = values.segment(kCount, static_cast<Eigen::Index>(layout_.points));
  characteristic.setZero();
  const auto addHats = [&](double share_of_stroke, double sign) {
    const Place place = placeOf(share_of_stroke);
    characteristic[place.point] += sign * (1.0 - place.share);
    characteristic[place.point + 1] += sign * place.share;
  };
  addHats(memory[kShare], 1.0);
  addHats(0.0, -1.0);
  if (layout_.resonant) {
    const Eigen::Index first = kCount + characteristic.size();
    for (std::size_t k = 0; k < kResonators; ++k) {
      values[first + 2 * static_cast<Eigen::Index>(k)] = memory[kPosition + k];
      values[first + 2 * static_cast<Eigen::Index>(k) + 1] = memory[kVelocity + k];
    }
  }
}

Residual::Residual(const ResidualBasis::Layout& layout, const Weights& weights)
    : basis_(layout),
      characteristic_(weights.characteristic),
      lowest_force_(weights.lowest_force),
      highest_force_(weights.highest_force) {
  checkSize("weights", weights.products.size(), kProducts);
  checkSize("characteristic", weights.characteristic.size(), layout.points);
  checkSize("resonance_weights", weights.resonators.size(), layout.resonant ? 2 * kResonators : 0);
  products_ = Eigen::Map<const Eigen::Array<double, kFactors, kStates - 1>>(weights.products.data()).transpose();
  std::copy(weights.products.end() - kFactors, weights.products.end(), of_share_.begin());
  const ResidualBasis::Place zero = basis_.placeOf(0.0);
  const double* point = characteristic_.data() + zero.point;
  const double at_zero = point[0] + zero.share * (point[1] - point[0]);
  for (double& force : characteristic_) {
    force -= at_zero;
  }

  for (std::size_t k = 0; k < weights.resonators.size() / 2; ++k) {
    position_[static_cast<Eigen::Index>(k)] = weights.resonators[2 * k];
    velocity_[static_cast<Eigen::Index>(k)] = weights.resonators[2 * k + 1];
  }
}

double Residual::initialise(double displacement, double* memory) const {
  basis_.initialise(displacement, memory);
  return force(memory);
}

double Residual::step(const Motion& motion, double* memory) const {
  basis_.advance(motion, memory);
  return force(memory);
}

double Residual::force(const double* memory) const {
  const double share = memory[ResidualBasis::kShare];
  const double square = share * share;
  const double amplitude = memory[ResidualBasis::kAmplitude];
  const States weights =
      (products_.col(0) + share * products_.col(1)) + (square * products_.col(2) + amplitude * products_.col(3));
  double force = (weights * at<States>(memory, ResidualBasis::kStop)).sum();
  force += share * ((of_share_[0] + share * of_share_[1]) + (square * of_share_[2] + amplitude * of_share_[3]));
  const ResidualBasis::Place place = basis_.placeOf(share);
  const double* point = characteristic_.data() + place.point;
  force += point[0] + place.share * (point[1] - point[0]);
  if (basis_.layout().resonant) {
    force += (position_ * at<Resonators>(memory, ResidualBasis::kPosition) +
              velocity_ * at<Resonators>(memory, ResidualBasis::kVelocity))
                 .sum();
  }
  return std::min(std::max(lowest_force_, force), highest_force_);  // this order also bounds NaN
}

ElementDescription residualDescription(const ResidualBasis& basis, const Eigen::VectorXd& weights, double lowest_force,
                                       double highest_force) {
  const ResidualBasis::Layout& layout = basis.layout();
  const auto products = weights.head(static_cast<Eigen::Index>(kProducts));
  const auto characteristic =
      weights.segment(static_cast<Eigen::Index>(kProducts), static_cast<Eigen::Index>(layout.points));
  const auto resonators = weights.tail(weights.size() - products.size() - characteristic.size());
  ElementDescription result{kResidualName,
                            {{"stroke", {layout.stroke}},
                             {"lowest", {layout.lowest}},
                             {"highest", {layout.highest}},
                             {"lowest_force", {std::min(lowest_force, 0.0)}},
                             {"highest_force", {std::max(highest_force, 0.0)}},
                             {"stops", vectorOf(layout.stops)},
                             {"relaxation_times", vectorOf(layout.times)},
                             {"amplitude_time", {layout.amplitude_time}},
                             {"weights", vectorOf(products)},
                             {"characteristic", vectorOf(characteristic)}}};
  if (layout.resonant) {
    result.values["resonances"] = vectorOf(layout.frequencies);
    result.values["resonance_damping"] = {layout.damping};
    result.values["resonance_weights"] = vectorOf(resonators);
  }
  return result;
}

namespace {

ElementType residualType() {
  const Range any = Range::any();
  const Range positive = Range::positive();
  const Range time{kShortestTime, std::numeric_limits<double>::infinity(), false, false};
  const Range stroke{kShortestStroke, std::numeric_limits<double>::infinity(), false, false};
  const Range negative{-std::numeric_limits<double>::infinity(), 0.0, false, false};
  return {kResidualName,
          "Surrogate: a bounded force learned from logs, which a diagnosis writes if no effect explains the gap.",
          {{"stroke", "m", Role::choice, stroke, "displacement S to which the weights refer"},
           {"lowest", "m", Role::choice, negative, "lowest displacement in the logs; the force is constant below it"},
           {"highest", "m", Role::choice, Range::nonNegative(),
            "highest displacement in the logs; the force is constant above it"},
           {"lowest_force", "N", Role::choice, negative, "lower bound of the force"},
           {"highest_force", "N", Role::choice, Range::nonNegative(), "upper bound of the force"},
           {"stops", "1", Role::choice, positive, "widths of the 6 stop operators, in strokes", std::nullopt, true},
           {"relaxation_times", "s", Role::choice, time, "times of the 4 relaxing shares", std::nullopt, true},
           {"amplitude_time", "s", Role::choice, time, "time over which the amplitude of the motion is determined"},
           {"weights", "N", Role::scale, any,
            "44 forces: for the 6 stops, the 4 relaxing shares and the displacement, each times 1, q, q^2 and the "
            "amplitude; q is the displacement in strokes",
            std::nullopt, true},
           {"characteristic", "N", Role::scale, any, "forces at equally spaced displacements from lowest to highest",
            std::nullopt, true},
           {"resonances", "Hz", Role::choice, Range::closed(0.0, kHighestFrequency),
            "natural frequencies of the 8 resonators; 0: no resonators", 0.0, true},
           {"resonance_damping", "1", Role::choice, Range::closed(1e-3, 10.0), "damping ratio of the resonators", 0.15},
           {"resonance_weights", "N", Role::scale, any,
            "16 forces: one for the displacement and one for the velocity of each resonator", 0.0, true}},
          makeResidual};
}

const ElementEntry kResidualEntry(470, residualType());

}  // namespace
}  // namespace rubber_suspension::element
