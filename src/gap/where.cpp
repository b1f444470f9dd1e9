// Computes the map of the gap.
#include "rubber_suspension/gap/where.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <tuple>

#include "numerics/fourier.h"

namespace rubber_suspension::gap {
namespace {

using Spectrum = std::vector<std::complex<double>>;

struct Key {
  std::size_t log;
  int frequency_band;  // octave from 2^b to 2^(b+1) Hz; kWholeBand for mean and drift
  int amplitude_band;  // half a decade, from 10^(b/2) to 10^((b+1)/2) m
  Quantity quantity;

  bool operator<(const Key& other) const {
    return std::tie(log, frequency_band, amplitude_band, quantity) <
           std::tie(other.log, other.frequency_band, other.amplitude_band, other.quantity);
  }
};

struct Energy {
  // Squared residual, divided by the variance of the force and averaged over the logs.
  double squared = 0.0;
  // Share of the spectral lines of the log, from which the noise in the cell is estimated.
  double lines = 0.0;
};

constexpr int kWholeBand = 1 << 20;
constexpr double kFewestPeriods = 2.0;  // number of periods of the slowest motion in a window
constexpr double kFewestCycles = 8.0;   // number of cycles of the mean frequency in a window

Spectrum transform(const Eigen::VectorXd& values) { return numerics::paddedSpectrum({values.begin(), values.end()}); }

// Returns the least length of a window [s]. Such a window contains the slowest motion, and the octaves around the mean
// frequency have several spectral lines.
double shortestWindow(const log::Record& record) {
  const double slowest = kFewestPeriods / record.lowest_frequency;
  return record.mean_frequency > 0.0 ? std::max(slowest, kFewestCycles / record.mean_frequency) : slowest;
}

class Map {
 public:
  Map(const std::vector<PreparedRecord>& records, const std::vector<Eigen::VectorXd>& residual)
      : records_(records), residual_(residual) {}

  std::map<Key, Energy> build() {
    for (std::size_t r = 0; r < records_.size(); ++r) {
      addLog(r);
    }
    return std::move(cells_);
  }

 private:
  void addLog(std::size_t r) {
    const PreparedRecord& record = records_[r];
    const double mean = residual_[r].mean();
    const auto windows =
        std::max<Eigen::Index>(1, static_cast<Eigen::Index>(record.duration() / shortestWindow(record)));
    for (Eigen::Index w = 0; w < windows; ++w) {
      const Eigen::Index first = record.size() * w / windows;
      addWindow(r, first, record.size() * (w + 1) / windows - first, mean);
    }
  }

  void addWindow(std::size_t r, Eigen::Index first, Eigen::Index count, double mean) {
    const PreparedRecord& record = records_[r];
    const auto part = record.displacement.segment(first, count);
    const double amplitude = std::max(1e-12, 0.5 * (part.maxCoeff() - part.minCoeff()));
    const int amplitude_band = static_cast<int>(std::floor(2.0 * std::log10(amplitude)));
    // Parseval: the sum of squares is 1/count times the sum of |R|^2 over all spectral lines.
    const double scale = record.weight / (static_cast<double>(record.size()) * std::pow(record.force_deviation, 2) *
                                          static_cast<double>(records_.size()));
    const double window_mean = residual_[r].segment(first, count).mean();
    const double samples = static_cast<double>(count);
    add({r, kWholeBand, amplitude_band, Quantity::mean}, scale * samples * mean * (2.0 * window_mean - mean), 0.0);
    add({r, kWholeBand, amplitude_band, Quantity::drift}, scale * samples * std::pow(window_mean - mean, 2), 0.0);

    const Eigen::VectorXd error = residual_[r].segment(first, count).array() - window_mean;
    const Eigen::VectorXd motion = part.array() - part.mean();
    const Spectrum residual = transform(error);
    const Spectrum displacement = transform(motion);
    const std::size_t half = residual.size() - 1;
    const double length = static_cast<double>(2 * half);
    const double line = 1.0 / (length * record.dt);
    for (std::size_t i = 1; i <= half;) {
      const int band = static_cast<int>(std::floor(std::log2(static_cast<double>(i) * line)));
      std::size_t end = i;
      while (end <= half && static_cast<int>(std::floor(std::log2(static_cast<double>(end) * line))) == band) {
        ++end;
      }
      addBand({r, band, amplitude_band, Quantity::harmonics}, residual, displacement, i, end, scale / length,
              samples / (length * static_cast<double>(record.size())));
      i = end;
    }
  }

  void addBand(Key key, const Spectrum& residual, const Spectrum& displacement, std::size_t begin, std::size_t end,
               double scale, double line_share) {
    std::complex<double> cross = 0.0;
    double displacement_power = 0.0;
    double residual_power = 0.0;
    double lines = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const double twice = i == residual.size() - 1 ? 1.0 : 2.0;  // counts the line at the negative frequency
      cross += twice * residual[i] * std::conj(displacement[i]);
      displacement_power += twice * std::norm(displacement[i]);
      residual_power += twice * std::norm(residual[i]);
      lines += twice * line_share;
    }
    double stiffness = 0.0;
    double loss = 0.0;
    if (displacement_power > 0.0) {
      stiffness = std::pow(cross.real(), 2) / displacement_power;
      loss = std::pow(cross.imag(), 2) / displacement_power;
    }
    key.quantity = Quantity::stiffness;
    add(key, scale * stiffness, 0.5 * line_share);
    key.quantity = Quantity::loss;
    add(key, scale * loss, 0.5 * line_share);
    key.quantity = Quantity::harmonics;
    add(key, scale * std::max(0.0, residual_power - stiffness - loss), lines);
  }

  void add(const Key& key, double squared, double lines) {
    Energy& energy = cells_[key];
    energy.squared += squared;
    energy.lines += lines;
  }

  const std::vector<PreparedRecord>& records_;
  const std::vector<Eigen::VectorXd>& residual_;
  std::map<Key, Energy> cells_;
};

}  // namespace

std::string toString(Quantity quantity) {
  static const char* const names[] = {"stiffness", "loss", "harmonics", "mean", "drift"};
  return names[static_cast<int>(quantity)];
}

std::vector<GapCell> gapMap(const std::vector<PreparedRecord>& records, const std::vector<Eigen::VectorXd>& residual,
                            const std::vector<double>& noise) {
  const std::map<Key, Energy> cells = Map(records, residual).build();
  double total = 0.0;
  for (const auto& [key, energy] : cells) {
    total += std::max(0.0, energy.squared);
  }
  std::vector<GapCell> result;
  for (const auto& [key, energy] : cells) {
    if (!(energy.squared > 0.0)) {
      continue;
    }
    GapCell cell;
    cell.log = records[key.log].name;
    const bool whole = key.frequency_band == kWholeBand;
    cell.frequency = {whole ? 0.0 : std::exp2(key.frequency_band),
                      whole ? 0.5 / records[key.log].dt : std::exp2(key.frequency_band + 1)};
    cell.amplitude = {std::pow(10.0, 0.5 * key.amplitude_band), std::pow(10.0, 0.5 * (key.amplitude_band + 1))};
    cell.quantity = key.quantity;
    cell.share = energy.squared / total;
    cell.squared = energy.squared;
    const double expected = noise[key.log] * noise[key.log] * energy.lines / static_cast<double>(records.size());
    cell.noise_ratio = expected > 0.0 ? std::sqrt(energy.squared / expected) : 0.0;
    result.push_back(cell);
  }
  std::sort(result.begin(), result.end(), [](const GapCell& a, const GapCell& b) { return a.share > b.share; });
  return result;
}

}  // namespace rubber_suspension::gap
