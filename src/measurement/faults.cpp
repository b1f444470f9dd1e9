// Spikes, held values and saturation, by rules relative to the log itself.
#include "rubber_suspension/measurement/faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <optional>

#include "measurement/statistics.h"

namespace rubber_suspension::measurement {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index kLongestSpike = 2;   // samples of a spike
constexpr double kSpikeLimit = 6.0;  // standard deviations from the prediction, which noise hardly ever exceeds
// If more samples are spikes, they are part of the signal rather than a fault of a cable.
constexpr double kMostSpikes = 0.01;
// If a sine lacks a fifth of its samples at a peak, it lacks a tenth of its range. Stiffness and loss at the largest
// amplitude can then not be determined.
constexpr double kLargestClippedShare = 0.2;
constexpr double kRare = 4.6;      // -ln of the probability, 1 %, that chance imitates a mass
constexpr Index kScaleBlock = 64;  // samples over which the scatter is assumed constant
constexpr Index kAround = 6;       // samples about a spike that belong to the same visit of a displacement
constexpr Index kMostVisits = 1000;
constexpr double kOddsOfSpike = 9.0;
constexpr double kShareBesideSpikes = 5.0 * kMostSpikes;  // share of visits with a corner; a spike causes five corners

// A noisy channel repeats less than this share of its samples, except at its extremes and in long runs.
constexpr double kFewRepeats = 0.02;
double repeats(const VectorXd& samples) {
  constexpr Index kLong = 4;
  const double high = samples.maxCoeff();
  const double low = samples.minCoeff();
  Index equal = 0;
  Index length = 1;
  for (Index i = 1; i < samples.size(); ++i) {
    const bool same = samples[i] == samples[i - 1] && samples[i] != high && samples[i] != low;
    length = same ? length + 1 : 1;
    equal += same && length < kLong ? 1 : 0;
  }
  return static_cast<double>(equal) / static_cast<double>(samples.size());
}

// Returns the standard deviation, at each of `count` samples, of a statistic that is defined from `first` to `last`,
// computed from its median magnitude in blocks of `length` samples.
template <class Statistic>
VectorXd scaleAbout(Statistic statistic, Index first, Index last, Index count, Index length, double least) {
  std::vector<double> all;
  std::vector<double> blocks;
  for (Index begin = 0; begin < count; begin += length) {
    std::vector<double> block;
    for (Index i = std::max(begin, first); i < std::min(begin + length, last); ++i) {
      block.push_back(std::abs(statistic(i)));
    }
    all.insert(all.end(), block.begin(), block.end());
    blocks.push_back(kMadToDeviation * medianOf(std::move(block)));
  }
  least = std::max(least, kMadToDeviation * medianOf(std::move(all)));
  VectorXd scale(count);
  for (Index i = 0; i < count; ++i) {
    const auto block = static_cast<std::size_t>(i / length);
    const double before = block > 0 ? blocks[block - 1] : 0.0;
    const double after = block + 1 < blocks.size() ? blocks[block + 1] : 0.0;
    scale[i] = std::max({least, blocks[block], std::min(before, after)});
  }
  return scale;
}

// One channel, and the scatter of its samples about a prediction from their neighbours.
struct Channel {
  Channel(const VectorXd& samples, bool of_force);

  // Returns the mean of one or two samples minus the cubic through the two neighbours on either side.
  double deviation(Index i, Index width) const {
    const double beside = values[i - 1] + values[i + width];
    const double beyond = values[i - 2] + values[i + width + 1];
    return width == 1 ? values[i] - (4.0 * beside - beyond) / 6.0
                      : 0.5 * (values[i] + values[i + 1]) - 0.75 * beside + 0.25 * beyond;
  }
  // Returns the largest deviation at a sample, with its sign; 0 if all are within `limit` standard deviations.
  double corner(Index i, double limit = kSpikeLimit) const {
    double largest = 0.0;
    for (Index width = 1; width <= kLongestSpike && i >= 2 && i + width + 1 < values.size(); ++width) {
      const double size = deviation(i, width);
      if (std::abs(size) > std::max(std::abs(largest), limit * scaleOf(width)[i])) {
        largest = size;
      }
    }
    return largest;
  }
  const VectorXd& scaleOf(Index width) const { return width == 1 ? scale : scale_of_two; }
  const char* name() const { return is_force ? "force" : "displacement"; }
  double coarseStep() const { return step > 1e-4 * range ? step : 0.0; }  // 0 if the sensor's resolution is fine

  const VectorXd& values;
  bool is_force;
  double highest;
  double lowest;
  double range;
  double step;            // smallest step between samples
  bool noisy;             // true if values hardly ever repeat, except at the extremes
  VectorXd scale;         // standard deviation of deviation() for one sample
  VectorXd scale_of_two;  // standard deviation of deviation() for two samples
};

Channel::Channel(const VectorXd& samples, bool of_force)
    : values(samples),
      is_force(of_force),
      highest(samples.maxCoeff()),
      lowest(samples.minCoeff()),
      range(highest - lowest),
      step(smallestStep(samples)),
      noisy(repeats(samples) < kFewRepeats),
      scale(samples.size()) {
  // A log that is mostly at rest has no scatter. The scale is therefore at least 1e-5 of the range, and one step of the
  // sensor.
  const double least = std::max(1e-5 * range, std::min(step, 0.01 * range));
  const auto scale_for = [&](Index width) {
    return scaleAbout([&](Index i) { return deviation(i, width); }, 2, values.size() - width - 1, values.size(),
                      kScaleBlock, least);
  };
  scale = scale_for(1);
  scale_of_two = scale_for(2);
}

// A run of samples [begin, begin + width) that stands out from its neighbours like a spike.
struct Hole {
  Index begin;
  Index width;
  double size;        // deviation of the sample that stands out most, with its sign
  double prediction;  // predicted value of the sample that stands out most
};

// Returns how far samples exceed three straight lines through their neighbours (left, right and across), if they do so
// with one sign and by more than the lines differ. A step or a kink lies on one of the lines.
std::optional<Hole> holeAt(const VectorXd& x, Index begin, Index width) {
  if (begin < 2 || begin + width + 1 >= x.size()) {
    return std::nullopt;
  }
  const double a = x[begin - 2];
  const double b = x[begin - 1];
  const double c = x[begin + width];
  const double d = x[begin + width + 1];
  const auto w = static_cast<double>(width);
  Hole hole{begin, width, 0.0, 0.0};
  double sign = 0.0;
  for (Index j = 0; j < width; ++j) {
    const auto t = static_cast<double>(j);  // neighbours are at -2, -1, w, w + 1
    const double left = b + (b - a) * (t + 1.0);
    const double right = c + (c - d) * (w - t);
    const double between = b + (c - b) * (t + 1.0) / (w + 1.0);
    const double value = x[begin + j];
    const double high = std::max({left, right, between});
    const double low = std::min({left, right, between});
    const double size = value > high ? value - high : (value < low ? value - low : 0.0);
    if (size == 0.0 || (sign != 0.0 && size * sign < 0.0) || high - low > std::abs(size)) {
      return std::nullopt;
    }
    sign = size;
    if (std::abs(size) > std::abs(hole.size)) {
      hole.size = size;
      hole.prediction = between;
    }
  }
  return hole;
}

std::optional<Hole> spikeAt(const Channel& channel, Index begin) {
  for (Index width = 1; width <= kLongestSpike; ++width) {
    const std::optional<Hole> hole = holeAt(channel.values, begin, width);
    if (hole && std::abs(hole->size) > kSpikeLimit * channel.scaleOf(width)[begin]) {
      return hole;
    }
  }
  return std::nullopt;
}

// Smallest sharpness of a corner, relative to a spike, that may have caused the spike. A corner appears less sharp by
// up to this factor where samples miss it, or where the force is steeper than elsewhere.
constexpr double kAlike = 0.2;

// Returns true if a corner is due to another spike than `hole`, because samples beside a spike have corners, too.
bool isOfAnotherSpike(const Channel& channel, Index corner, const Hole& hole) {
  for (Index i = corner - 2; i <= corner + kLongestSpike + 1; ++i) {
    const bool elsewhere = i < hole.begin - 1 || i > hole.begin + hole.width;
    if (elsewhere && channel.corner(i) != 0.0 && spikeAt(channel, i)) {
      return true;
    }
  }
  return false;
}

// Returns true if the other channel has a corner nearby that may have caused the hole, as at the end of a ramp.
bool cornerNear(const Channel& channel, const Channel& other, const Hole& hole) {
  for (Index i = std::max<Index>(0, hole.begin - 1); i <= hole.begin + hole.width; ++i) {
    if (std::abs(other.corner(i)) / other.range > kAlike * std::abs(hole.size) / channel.range &&
        !isOfAnotherSpike(other, i, hole)) {
      return true;
    }
  }
  return false;
}

// Peaks of the force that a mass causes where the speed of the displacement jumps. Noise may hide a jump between two
// samples, so jumps are measured as changes of slope over many samples.
class Mass {
 public:
  Mass(const Channel& force, const VectorXd& z, const std::vector<Hole>& holes)
      : force_(force), jump_(VectorXd::Zero(z.size())) {
    const Index count = z.size();
    VectorXd sum = VectorXd::Zero(count + 1);
    for (Index i = 0; i < count; ++i) {
      sum[i + 1] = sum[i] + z[i] - z[0];
    }
    VectorXd deviation = VectorXd::Constant(count, HUGE_VAL);
    for (const Index k : {4, 8, 16, 32}) {
      const auto mean = [&](Index i) { return (sum[i + k / 2 + 1] - sum[i - k / 2]) / static_cast<double>(k + 1); };
      const auto jump = [&](Index i) {  // jump is 1 if the slope changes by 1 per sample
        return (4.0 * (mean(i - k) + mean(i + k)) - mean(i - 2 * k) - mean(i + 2 * k) - 6.0 * mean(i)) /
               (1.6 * static_cast<double>(k));
      };
      const Index reach = 3 * k;
      if (count <= 2 * reach) {
        break;
      }
      const VectorXd scale = scaleAbout(jump, reach, count - reach, count, std::max(kScaleBlock, 8 * k),
                                        1e-6 * rangeOf(z) / static_cast<double>(k));
      for (Index i = reach; i < count - reach; ++i) {
        if (scale[i] < deviation[i]) {
          deviation[i] = scale[i];
          jump_[i] = jump(i);
        }
      }
    }
    fit(deviation, holes);
  }

  // Returns true if the jump at a hole is more than half of the jump that the mass needs for such a peak.
  bool explains(const Hole& hole) const {
    const Index at = middleOf(hole);
    return jump_[at] / (peakAt(at) * jump_over_peak_) > 0.5;
  }

 private:
  static constexpr Index kReach = 64;  // largest number of samples around a jump that show the jump
  static constexpr Index kBeside = 3;  // samples within which the time of a jump is known

  static Index middleOf(const Hole& hole) { return hole.begin + (hole.width - 1) / 2; }

  double peakAt(Index i) const {
    double peak = 0.0;
    for (Index j = i - kBeside; j <= i + kBeside; ++j) {
      const double corner = force_.corner(j, 0.0);
      peak = std::abs(corner) > std::abs(peak) ? corner : peak;
    }
    return peak;
  }

  // Fits one mass to all holes and to all significant jumps. The mass is accepted only if it explains more than half of
  // the holes and of the jumps, and if chance is unlikely to do so.
  void fit(const VectorXd& deviation, const std::vector<Hole>& holes) {
    double product = 0.0;
    double peaks = 0.0;
    double jumps = 0.0;
    const auto add = [&](Index i) {
      const double peak = peakAt(i) / deviation[i];
      const double jump = jump_[i] / deviation[i];
      product += peak * jump;
      peaks += peak * peak;
      jumps += jump * jump;
    };
    VectorXd sizes = jump_.cwiseAbs();
    for (const Hole& hole : holes) {
      add(middleOf(hole));
      const Index first = std::max<Index>(0, hole.begin - kReach);
      sizes.segment(first, std::min(sizes.size(), hole.begin + kReach) - first).setZero();
    }
    for (Index i = kReach; i + kReach < sizes.size(); ++i) {
      if (sizes[i] > kSpikeLimit * deviation[i] && sizes[i] == sizes.segment(i - kReach, 2 * kReach + 1).maxCoeff()) {
        add(i);
      }
    }
    const double explained = product * product;
    if (explained > 0.5 * peaks * jumps && explained > 2.0 * kRare * peaks) {
      jump_over_peak_ = product / peaks;
    }
  }

  const Channel& force_;
  VectorXd jump_;                     // jump of the slope of the displacement [per sample]
  double jump_over_peak_ = HUGE_VAL;  // ratio of jump to peak; infinite without a mass, so that nothing is explained
};

// Returns true if a corner at or beside a sample is about as sharp as a hole is deep, with the same sign.
bool alikeAt(const Channel& channel, Index i, const Hole& hole) {
  const auto sharp = [&](Index at) { return channel.corner(at) / hole.size > kAlike; };
  return sharp(i - 1) || sharp(i) || sharp(i + 1);
}

// Returns true if the force has similar corners at other visits to the same displacement at a similar speed, as at a
// bump stop or in a clearance. The share of visits with a corner is arbitrary if corners belong to the displacement,
// and small if they are spikes. The prior of a spike is 0.9.
bool belongsToThePlace(const Channel& channel, const Channel& other, const Hole& hole) {
  const VectorXd& z = other.values;
  const auto step = [&](Index i) { return z[i + 2] - z[i - 2]; };
  const double place = z[hole.begin];
  const double speed = step(hole.begin);
  Index visits = 0;
  Index alike = 0;
  for (Index i = 2; i + 2 < z.size() && visits < kMostVisits; ++i) {
    if (std::abs(z[i] - place) < 0.01 * other.range && std::abs(i - hole.begin) > kAround &&
        std::abs(step(i) - speed) < 0.2 * std::abs(speed) + 0.01 * other.range) {
      ++visits;
      alike += alikeAt(channel, i, hole) ? 1 : 0;
      i += kAround;  // skips the samples of this visit
    }
  }
  const auto others = static_cast<double>(visits - alike);
  const double beside = boost::math::ibeta(static_cast<double>(alike + 1), others + 1.0, kShareBesideSpikes);
  return kOddsOfSpike * beside < kShareBesideSpikes;
}

void exclude(Mask& mask, Index begin, Index end) { mask.segment(begin, end - begin).setConstant(false); }

std::vector<Hole> findSpikes(const Channel& channel, const Channel& other) {
  std::vector<Hole> holes;
  const Index count = channel.values.size();
  const auto most = static_cast<std::size_t>(std::max(3.0, kMostSpikes * static_cast<double>(count)));
  for (Index i = 2; i + 2 < count; ++i) {
    if (channel.corner(i) == 0.0) {
      continue;
    }
    const std::optional<Hole> hole = spikeAt(channel, i);
    if (hole && !cornerNear(channel, other, *hole)) {
      holes.push_back(*hole);
      i += hole->width;
    }
    if (holes.size() > most) {
      return {};
    }
  }
  if (channel.is_force && !holes.empty()) {
    VectorXd displacement = other.values;
    Mask measured = Mask::Constant(displacement.size(), true);
    for (const Hole& hole : findSpikes(other, channel)) {
      exclude(measured, hole.begin, hole.begin + hole.width);
    }
    bridge(displacement, measured);
    const Mass mass(channel, displacement, holes);
    holes.erase(std::remove_if(
                    holes.begin(), holes.end(),
                    [&](const Hole& hole) { return mass.explains(hole) || belongsToThePlace(channel, other, hole); }),
                holes.end());
  }
  return holes;
}

// Samples [begin, end) that are equal bit by bit.
struct Run {
  Index begin;
  Index end;
};

std::vector<Run> equalRuns(const VectorXd& values, Index shortest) {
  std::vector<Run> runs;
  Index begin = 0;
  for (Index i = 1; i <= values.size(); ++i) {
    if (i == values.size() || values[i] != values[begin]) {
      if (i - begin >= shortest) {
        runs.push_back({begin, i});
      }
      begin = i;
    }
  }
  return runs;
}

constexpr Index kShortestHold = 4;

double typicalStep(const VectorXd& values, const Run& run) {
  constexpr Index kReach = 50;
  std::vector<double> steps;
  for (Index i = std::max<Index>(1, run.begin - kReach); i < std::min(run.end + kReach, values.size()); ++i) {
    if (i <= run.begin || i > run.end) {
      steps.push_back(std::abs(values[i] - values[i - 1]));
    }
  }
  return medianOf(std::move(steps));
}

double rangeWithin(const VectorXd& values, const Run& run) {
  return rangeOf(values.segment(run.begin, run.end - run.begin));
}

// Returns true if the other channel turns within `reach` samples of the end of a run, or moves by less than its
// scatter, because a force at the limit of friction changes there, too.
bool turnsAtEnd(const VectorXd& other, const Run& run, Index reach, double scatter) {
  const Index last = run.end - 1;
  if (last < reach || last + reach >= other.size()) {
    return true;
  }
  const double before = other[last] - other[last - reach];
  const double after = other[last + reach] - other[last];
  return before * after <= 0.0 || std::min(std::abs(before), std::abs(after)) < scatter;
}

// Returns true if a noisy force repeats one value while the displacement moves.
bool repeatsAgainstNoise(const Channel& force, const Channel& displacement, const Run& run) {
  const double moved = rangeWithin(displacement.values, run);
  return force.noisy && moved > 0.005 * displacement.range && moved > kSpikeLimit * displacement.scale[run.begin];
}

bool isHeld(const Channel& channel, const Channel& other, const Run& run) {
  const double jump = std::abs(channel.values[run.end] - channel.values[run.end - 1]);
  const double other_jump = std::abs(other.values[run.end] - other.values[run.end - 1]) / other.range;
  if (jump <= 4.0 * typicalStep(channel.values, run) || jump <= 3.0 * channel.coarseStep() ||
      jump < 1e-3 * channel.range) {
    return false;
  }
  return other_jump < 0.5 * jump / channel.range &&
         rangeWithin(other.values, run) / other.range > 0.25 * jump / channel.range &&
         !turnsAtEnd(other.values, run, 3, 0.0);
}

bool atExtreme(const Channel& channel, const Run& run) {
  const double value = channel.values[run.begin];
  return value == channel.highest || value == channel.lowest;
}

// Returns runs of held values. `mask`: false for spikes, at which a run may end.
std::vector<Run> findHolds(const Channel& channel, const Channel& other, const Mask& mask) {
  std::vector<Run> held;
  for (const Run& run : equalRuns(channel.values, kShortestHold)) {
    if (atExtreme(channel, run) || run.end >= channel.values.size() || !mask[run.end]) {
      continue;  // the sensor may be saturated
    }
    if (isHeld(channel, other, run) || (channel.is_force && repeatsAgainstNoise(channel, other, run))) {
      held.push_back(run);
    }
  }
  return held;
}

// Returns how far the other channel bulges outwards over a run: the mean of its middle third minus that of the outer
// thirds. A channel that relaxes towards a value bulges inwards.
double bulge(const VectorXd& other, const Run& run) {
  const Index length = run.end - run.begin;
  const Index third = std::max<Index>(1, length / 3);
  const Index middle = length - 2 * third;
  const double ends = other.segment(run.begin, third).sum() + other.segment(run.end - third, third).sum();
  return other.segment(run.begin + third, middle).mean() - ends / static_cast<double>(2 * third);
}

struct Saturation {
  Index samples = 0;
  double limit = 0.0;
};

// Finds a saturated channel: many samples equal its extreme value, few lie just short of it, and meanwhile the other
// channel goes further out and returns.
std::optional<Saturation> findSaturation(const Channel& channel, const Channel& other, double outward) {
  Saturation found;
  found.limit = outward > 0.0 ? channel.highest : channel.lowest;
  double bulging = 0.0;
  double variance = 0.0;
  double travelled = 0.0;
  Index in_motion = 0;
  for (const Run& run : equalRuns(channel.values, 3)) {
    if (channel.values[run.begin] == found.limit) {
      const auto length = static_cast<double>(run.end - run.begin);
      found.samples += run.end - run.begin;
      // If the other channel only passes through, as under friction at its limit, it does not bulge.
      const double passed = std::abs(other.values[run.end - 1] - other.values[run.begin]);
      const double size = outward * bulge(other.values, run);
      bulging += passed < 3.0 * std::abs(size) ? size * length : 0.0;
      travelled += passed * length;
      const Index reach = std::max<Index>(3, (run.end - run.begin) / 8);
      const bool turns = turnsAtEnd(other.values, run, reach, kSpikeLimit * other.scale[run.begin]);
      in_motion += turns ? 0 : run.end - run.begin;
      variance += 4.5 * std::pow(other.scale[run.begin], 2) * length;  // variance: (3/n + 3/(2 n)) n^2
    }
  }
  const double width = std::max(3.5 * channel.coarseStep(), 0.005 * channel.range);
  const auto distance = (outward * (found.limit - channel.values.array())).eval();
  const Index near = (distance > 0.0 && distance < width).count();
  // A peak that is merely rounded has as many samples on the three levels below its extreme value as on this value.
  if (found.samples < 5 || found.samples <= 2 * near) {
    return std::nullopt;
  }
  // The sign is reversed if force and displacement have opposite signs.
  const double slope = (channel.values.array() - channel.values.mean()).matrix().dot(other.values);
  bulging *= slope < 0.0 ? -1.0 : 1.0;
  // The bulge has to exceed the scatter and the bulge of a peak that is cut at 1 % of the range.
  const bool bulges =
      bulging > 4.0 * std::sqrt(variance) && bulging > 3e-3 * other.range * static_cast<double>(found.samples);
  // The noise of a saturated force vanishes, whereas that of friction at its limit continues along a stroke.
  const bool silent =
      channel.is_force && channel.noisy && travelled < 0.2 * other.range * static_cast<double>(found.samples);
  // Friction leaves its limit where the displacement turns; a delayed force leaves saturation between turning points.
  const bool behind = channel.is_force && 2 * in_motion > found.samples;
  return bulges || silent || behind ? std::optional<Saturation>(found) : std::nullopt;
}

RigFinding counted(const std::string& log, const char* finding, double count, std::string text) {
  return {log, finding, count, {count, count}, "1", false, false, std::move(text)};
}

void addSpikes(const std::string& name, const Channel& channel, const Channel& other, Mask& mask,
               std::vector<RigFinding>& findings) {
  const std::vector<Hole> holes = findSpikes(channel, other);
  if (holes.empty()) {
    return;
  }
  double largest = 0.0;
  for (const Hole& hole : holes) {
    largest = std::max(largest, std::abs(hole.size));
    exclude(mask, hole.begin, hole.begin + hole.width);
  }
  findings.push_back(counted(name, finding::kSpikes, static_cast<double>(holes.size()),
                             fmt::format("{} spike{} in the {} only, the first at sample {}, the largest {:.2g} % of "
                                         "its range: these samples are excluded; check cable and connector",
                                         holes.size(), holes.size() == 1 ? "" : "s", channel.name(),
                                         holes.front().begin + 1, 100.0 * largest / channel.range)));
}

void addHolds(const std::string& name, const Channel& channel, const Channel& other, Mask& mask,
              std::vector<RigFinding>& findings) {
  const std::vector<Run> holds = findHolds(channel, other, mask);
  if (holds.empty()) {
    return;
  }
  Index samples = 0;
  for (const Run& run : holds) {
    samples += run.end - run.begin;
    exclude(mask, run.begin + 1, run.end);  // the first sample of a run was measured
  }
  findings.push_back(
      counted(name, finding::kHeldValues, static_cast<double>(samples),
              fmt::format("the {} repeats its value for {} samples in {} place{}, the first from sample {}, while the "
                          "{} continues to change: these samples are excluded; check the connection for dropouts",
                          channel.name(), samples, holds.size(), holds.size() == 1 ? "" : "s", holds.front().begin + 1,
                          other.name())));
}

void addSaturation(const std::string& name, const Channel& channel, const Channel& other, Mask& mask,
                   std::vector<RigFinding>& findings) {
  for (const double outward : {1.0, -1.0}) {
    const std::optional<Saturation> found = findSaturation(channel, other, outward);
    if (!found) {
      continue;
    }
    // Samples just below the limit are also excluded, because their noise is one-sided.
    mask = mask && (channel.scale.array() * kSpikeLimit < outward * (found->limit - channel.values.array()));
    const double share = static_cast<double>(found->samples) / static_cast<double>(mask.size());
    findings.push_back(counted(name, finding::kSaturation, static_cast<double>(found->samples),
                               fmt::format("the {} stays at its {} {:.4g} {} for {} samples while the {} continues "
                                           "(clipped): these samples are excluded; choose a larger measuring range",
                                           channel.name(), outward > 0.0 ? "maximum" : "minimum", found->limit,
                                           channel.is_force ? "N" : "m", found->samples, other.name())));
    findings.back().fatal = share > kLargestClippedShare;
  }
}

}  // namespace

Faults findFaults(const std::string& name, const VectorXd& displacement, const VectorXd& force) {
  Faults faults;
  faults.displacement = Mask::Constant(displacement.size(), true);
  faults.force = faults.displacement;
  if (displacement.size() < 2 * kAround || rangeOf(displacement) <= 0.0 || rangeOf(force) <= 0.0) {
    return faults;
  }
  const Channel z(displacement, false);
  const Channel f(force, true);
  for (const auto add : {addSpikes, addHolds, addSaturation}) {
    add(name, f, z, faults.force, faults.findings);
    add(name, z, f, faults.displacement, faults.findings);
  }
  return faults;
}

Faults findFaults(const log::Log& log) {
  if (log.force.empty()) {
    const Mask all = Mask::Constant(static_cast<Index>(log.size()), true);
    return {all, all, {}};
  }
  return findFaults(log.name, asVector(log.displacement), asVector(log.force));
}

log::Log repaired(const log::Log& log, const Faults& faults) {
  log::Log result = log;
  const auto repair = [](std::vector<double>& values, const Mask& mask) {
    if (!values.empty() && mask.any()) {
      bridge(Eigen::Map<VectorXd>(values.data(), mask.size()), mask);
    }
  };
  repair(result.displacement, faults.displacement);
  repair(result.force, faults.force);
  return result;
}

Mask resampled(const Mask& mask, const log::Log& log, const log::Record& record) {
  if (record.size() == mask.size()) {
    return mask;
  }
  Mask result = Mask::Constant(record.size(), true);
  std::size_t left = 0;
  for (Index i = 0; i < record.size(); ++i) {
    const double time = static_cast<double>(i) * record.dt;
    while (left + 2 < log.size() && log.time(left + 1) - log.time(0) < time) {
      ++left;
    }
    result[i] = mask[static_cast<Index>(left)] && mask[static_cast<Index>(left + 1)];
  }
  return result;
}

VectorXd huberWeights(const VectorXd& normalised) {
  constexpr double kBend = 1.345;
  return normalised.array().abs().max(kBend).inverse() * kBend;
}

double robustDeviation(const VectorXd& values, const Mask& mask) {
  std::vector<double> magnitudes;
  magnitudes.reserve(static_cast<std::size_t>(values.size()));
  for (Index i = 0; i < values.size(); ++i) {
    if (mask[i]) {
      magnitudes.push_back(std::abs(values[i]));
    }
  }
  return kMadToDeviation * medianOf(std::move(magnitudes));
}

Mask maskOf(const log::Record& record) {
  return record.counts.size() == 0 ? Mask::Constant(record.size(), true).eval() : (record.counts.array() > 0.0).eval();
}

}  // namespace rubber_suspension::measurement
