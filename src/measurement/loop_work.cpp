// Stiffness and work of a log's loops; channels that measured nothing.
#include "measurement/loop_work.h"

#include "measurement/spectrum.h"
#include "measurement/statistics.h"
#include "numerics/least_squares.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::measurement {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::pair<double, double> jackknife(const std::vector<double>& energies, const std::vector<double>& scales) {
  double energy = 0.0;
  double scale = 0.0;
  for (std::size_t i = 0; i < energies.size(); ++i) {
    energy += energies[i];
    scale += scales[i];
  }
  if (scale <= 0.0) {
    return {0.0, 1.0};
  }
  double variance = 0.0;
  for (std::size_t i = 0; i < energies.size(); ++i) {
    const double without = scale > scales[i] ? (energy - energies[i]) / (scale - scales[i]) : energy / scale;
    variance += std::pow(without - energy / scale, 2);
  }
  const auto count = static_cast<double>(energies.size());
  return {energy / scale, std::sqrt(variance * (count - 1.0) / count)};
}

// Lowest and highest value of a channel in a part of a log.
struct Part {
  double low = 0.0;
  double high = 0.0;
};

std::vector<Part> partsOf(const VectorXd& values, Index length) {
  std::vector<Part> parts;
  for (Index first = 0; first + length <= values.size(); first += length) {
    parts.push_back({values.segment(first, length).minCoeff(), values.segment(first, length).maxCoeff()});
  }
  return parts;
}

// Returns how often a signal without trend swings from beyond half of its deviation to beyond it on the other side.
int swingsOf(const VectorXd& values, double deviation) {
  int swings = 0;
  double side = 0.0;
  for (const double value : values) {
    const double now = value > 0.5 * deviation ? 1.0 : value < -0.5 * deviation ? -1.0 : side;
    swings += side != 0.0 && now != side ? 1 : 0;
    side = now;
  }
  return swings;
}

VectorXd withoutTrend(const VectorXd& values) {
  const VectorXd time = VectorXd::LinSpaced(values.size(), -1.0, 1.0);
  const VectorXd centred = values.array() - values.mean();
  return centred - centred.dot(time) / time.squaredNorm() * time;
}

}  // namespace

double typicalPhase(const VectorXd& displacement) {
  const Index count = displacement.size();
  const VectorXd step = displacement.tail(count - 1) - displacement.head(count - 1);
  return rmsOf(step) / std::max(gap::standardDeviation(displacement), 1e-300);
}

Slope slopeOf(const VectorXd& displacement, const VectorXd& force) {
  const Index count = displacement.size();
  const double smallest = 0.1 * rangeOf(displacement);
  std::vector<double> slopes;
  double zz = 0.0;
  double zf = 0.0;
  double ff = 0.0;
  for (const double phase : {0.5 * element::kPi, element::kPi}) {
    const double samples = phase / typicalPhase(displacement);
    const Index lag = std::clamp(static_cast<Index>(samples), Index{1}, count - 1);
    const Index stride = std::max<Index>(1, count / 20000);
    for (Index i = 0; i + lag < count; i += stride) {
      const double z = displacement[i + lag] - displacement[i];
      const double f = force[i + lag] - force[i];
      zz += z * z;
      zf += z * f;
      ff += f * f;
      if (std::abs(z) > smallest) {
        slopes.push_back(f / z);
      }
    }
  }
  const double scale = std::sqrt(zz * ff);
  return {slopes.empty() ? (zz > 0.0 ? zf / zz : 0.0) : medianOf(std::move(slopes)), scale > 0.0 ? zf / scale : 0.0};
}

CrossSpectrum::CrossSpectrum(const VectorXd& displacement, const VectorXd& force) {
  const Index segment = std::max<Index>(16, displacement.size() / 4);
  for (Index begin = 0; begin + segment <= displacement.size(); begin += std::max<Index>(1, segment / 2)) {
    add(displacement.segment(begin, segment), force.segment(begin, segment));
  }
}

std::pair<double, double> CrossSpectrum::work(double forward) const {
  std::vector<double> energies;
  std::vector<double> scales;
  for (const auto& window : windows_) {
    double energy = 0.0;
    double scale = 0.0;
    for (const Octave& octave : window) {
      const std::complex<double> turned =
          octave.cross * std::polar(1.0, 2.0 * element::kPi * octave.frequency * forward);
      energy += octave.frequency * turned.imag();
      scale += octave.frequency * std::abs(octave.cross);
    }
    energies.push_back(energy);
    scales.push_back(scale);
  }
  return jackknife(energies, scales);
}

std::vector<Octave> CrossSpectrum::octaves() const {
  std::vector<Octave> sum;
  for (const auto& window : windows_) {
    sum.resize(std::max(sum.size(), window.size()));
    for (std::size_t i = 0; i < window.size(); ++i) {
      sum[i].frequency = window[i].frequency > 0.0 ? window[i].frequency : sum[i].frequency;
      sum[i].cross += window[i].cross;
      sum[i].power += window[i].power;
    }
  }
  return sum;
}

void CrossSpectrum::add(const VectorXd& displacement, const VectorXd& force) {
  constexpr std::size_t kShortest = 16;
  const auto z = hannSpectrum(displacement, kShortest);
  const auto f = hannSpectrum(force, kShortest);
  double most = 0.0;
  for (std::size_t i = 1; i < z.size(); ++i) {
    most = std::max(most, std::norm(z[i]));
  }
  std::vector<Octave> window;
  std::size_t end = 2;
  for (std::size_t begin = 1; begin < z.size(); begin = end, end = 2 * begin) {
    Octave octave;
    double weighted = 0.0;
    for (std::size_t i = begin; i < std::min(end, z.size()); ++i) {
      if (std::norm(z[i]) > 1e-3 * most) {  // excited: less than 30 dB below the highest line
        octave.cross += std::conj(z[i]) * f[i];
        octave.power += std::norm(z[i]);
        weighted += static_cast<double>(i) * std::norm(z[i]);
      }
    }
    octave.frequency = octave.power > 0.0 ? weighted / octave.power / static_cast<double>(2 * (z.size() - 1)) : 0.0;
    window.push_back(octave);
  }
  windows_.push_back(window);
}

DeadPart deadPart(const VectorXd& channel, const VectorXd& other, double least_of_other) {
  constexpr Index kParts = 200;
  constexpr double kStill = 0.005;  // share of the range; allows for the noise of a sensor
  constexpr int kFewestSwings = 4;
  const Index length = std::max<Index>(1, channel.size() / kParts);
  const std::vector<Part> parts = partsOf(channel, length);
  const double still = kStill * rangeOf(channel);
  DeadPart longest;
  std::size_t begin = 0;
  Part run{HUGE_VAL, -HUGE_VAL};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part wider{std::min(run.low, parts[i].low), std::max(run.high, parts[i].high)};
    const bool goes_on = wider.high - wider.low <= still;
    begin = goes_on ? begin : parts[i].high - parts[i].low <= still ? i : i + 1;
    run = goes_on ? wider : begin == i ? parts[i] : Part{HUGE_VAL, -HUGE_VAL};
    const DeadPart found{static_cast<Index>(begin) * length, static_cast<Index>(i + 1) * length};
    longest = found.end - found.begin > longest.end - longest.begin ? found : longest;
  }
  const Index dead = longest.end - longest.begin;
  if (10 * dead < channel.size() || dead == channel.size()) {
    return {};
  }
  const VectorXd meanwhile = withoutTrend(other.segment(longest.begin, dead));
  VectorXd rest(other.size() - dead);
  rest << other.head(longest.begin), other.tail(other.size() - longest.end);
  const double deviation = gap::standardDeviation(meanwhile);
  const bool goes_on =
      deviation > least_of_other * gap::standardDeviation(rest) && swingsOf(meanwhile, deviation) >= kFewestSwings;
  return goes_on ? longest : DeadPart{};
}

bool isOfAMotion(const VectorXd& force, const VectorXd& displacement, const DeadPart& dead) {
  constexpr double kMore = 1.25;  // hum differs by a smaller factor between two parts of a log
  const Index length = dead.end - dead.begin;
  const auto rest = [&](const VectorXd& values) {
    VectorXd kept(values.size() - length);
    kept << values.head(dead.begin), values.tail(values.size() - dead.end);
    return VectorXd(kept.array() - kept.mean());
  };
  VectorXd rate = VectorXd::Zero(displacement.size());
  rate.tail(rate.size() - 1) = displacement.tail(rate.size() - 1) - displacement.head(rate.size() - 1);
  Eigen::MatrixXd motion(displacement.size() - length, 2);
  motion << rest(displacement), rest(rate);
  const VectorXd hum = rest(force) - motion * numerics::solveLeastNorm(motion, rest(force));
  return gap::standardDeviation(force.segment(dead.begin, length)) > kMore * gap::standardDeviation(hum);
}

double correlationOf(const VectorXd& one, const VectorXd& other) {
  const VectorXd x = one.array() - one.mean();
  const VectorXd y = other.array() - other.mean();
  const double scale = x.norm() * y.norm();
  return scale > 0.0 ? x.dot(y) / scale : 0.0;
}

}  // namespace rubber_suspension::measurement
