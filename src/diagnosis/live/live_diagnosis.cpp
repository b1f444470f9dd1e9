// Diagnoses one component while its bench runs.
#include "diagnosis/live/live_diagnosis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "element/each.h"
#include "io/cancellation.h"
#include "log/even_blocks.h"
#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::diagnosis::live {
namespace {

constexpr double kNoForce = std::numeric_limits<double>::quiet_NaN();
constexpr double kSettling = 5.0;        // time after a start until the response to earlier motion has decayed [s]
constexpr double kShortestPause = 10.0;  // shortest time between two looks [s]
constexpr double kLogLength = 30.0;      // least length of the logs into which a window is cut [s]
constexpr std::size_t kMostPieces = 4;
constexpr double kFewestInBlock = 20;
constexpr double kSamplesPerPeriod = 16.0;  // least number of samples per period of the fastest motion after thinning
constexpr int kResamplings = 100;

double seconds(std::int64_t nanoseconds) { return 1e-9 * static_cast<double>(nanoseconds); }
std::int64_t nanoseconds(double time) { return static_cast<std::int64_t>(std::llround(1e9 * time)); }

std::string placeOf(const std::vector<gap::GapCell>& cells) {
  if (cells.empty()) {
    return {};
  }
  const gap::GapCell& cell = cells.front();
  const std::string band =
      cell.frequency[0] > 0.0 ? fmt::format("{:.3g} to {:.3g} Hz, ", cell.frequency[0], cell.frequency[1]) : "";
  return fmt::format("{:.0f} % of the gap: {} at {}{:.3g} to {:.3g} mm", 100.0 * cell.share,
                     gap::toString(cell.quantity), band, 1e3 * cell.amplitude[0], 1e3 * cell.amplitude[1]);
}

double probabilityOf(const std::string& effect, const Diagnosis& diagnosis) {
  const auto found = std::find_if(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                                  [&](const CandidateResult& candidate) { return candidate.effect == effect; });
  return found == diagnosis.candidates.end() ? 0.0 : found->probability;
}

// Returns every `step`-th sample from index `first` on.
log::Log logOf(const std::deque<LiveSample>& samples, std::size_t first, std::size_t step) {
  log::Log log;
  log.name = "live";
  for (std::size_t i = first; i < samples.size(); i += step) {
    log.stamp.push_back(samples[i].stamp);
    log.displacement.push_back(samples[i].displacement);
    log.force.push_back(samples[i].force);
  }
  return log;
}

// Returns the largest step of thinning that keeps enough samples per period of the fastest motion above the noise.
std::size_t largestStep(const log::Log& log) {
  const log::Record record = log::makeRecord(log::longestStretch(log));
  const double rate = kSamplesPerPeriod * std::max(record.highest_frequency, record.mean_frequency);
  return rate > 0.0 ? static_cast<std::size_t>(std::max(1.0, std::floor(1.0 / (rate * record.dt)))) : 1;
}

std::vector<log::Log> cut(const log::Log& whole) {
  const double duration = whole.time(whole.size() - 1) - whole.time(0);
  const auto count = std::clamp<std::size_t>(static_cast<std::size_t>(duration / kLogLength), 1, kMostPieces);
  std::vector<log::Log> logs(count);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    log::Log& log = logs[i * count / whole.size()];
    log.stamp.push_back(whole.stamp[i]);
    log.displacement.push_back(whole.displacement[i]);
    log.force.push_back(whole.force[i]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    logs[i].name = fmt::format("live_{}", i + 1);
  }
  return logs;
}

}  // namespace

class LiveDiagnosis::Model {
 public:
  explicit Model(const io::ComponentDescription& description)
      : component_(description.makeComponent()), stream_(component_) {}
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  // Returns NaN if the model refuses the sample.
  double force(const LiveSample& sample) {
    const component::StreamForce answer = stream_.push(sample.stamp, sample.displacement);
    return component::isAccepted(answer.acceptance) ? answer.force.total : kNoForce;
  }

 private:
  const component::Component component_;
  component::SampleStream stream_;
};

struct LiveDiagnosis::Block {
  class Spread {
   public:
    void add(double value) {
      sum_ += value;
      square_ += value * value;
    }

    double deviation(double count) const {
      const double mean = sum_ / count;
      return std::sqrt(std::max(0.0, square_ / count - mean * mean));
    }

   private:
    double sum_ = 0.0;
    double square_ = 0.0;
  };

  std::int64_t begin = 0;  // [ns]
  std::int64_t last = 0;
  double samples = 0.0;
  bool whole = true;  // true if no stretch of the block lacks samples
  Spread force;
  Spread configured;
  Spread re_estimated;
  Spread augmented;
};

LiveDiagnosis::LiveDiagnosis(io::ComponentDescription configured, const LiveSettings& settings)
    : configured_(std::move(configured)), settings_(settings), judgement_(settings.criteria) {
  restart();
}

LiveDiagnosis::~LiveDiagnosis() = default;

void LiveDiagnosis::restart() {
  judgement_ = LiveJudgement(settings_.criteria);
  samples_.clear();
  configured_model_ = std::make_unique<Model>(configured_);
  re_estimated_model_.reset();
  augmented_model_.reset();
  block_.reset();
  findings_ = LiveFindings();
  findings_.sentence = "too few samples with a measured force so far";
  candidate_.reset();
  last_look_ = 0;
  last_window_ = 0.0;
}

void LiveDiagnosis::add(const LiveSample& sample) {
  if (!samples_.empty() && sample.stamp <= samples_.back().stamp) {
    if (samples_.back().stamp - sample.stamp <= component::SampleStream::kNanosecondsPerSecond) {
      return;
    }
    restart();
  }
  if (samples_.empty()) {
    first_ = sample.stamp;
    last_look_ = sample.stamp;
    regime_begin_ = sample.stamp;
  }
  keep(sample);
  simulate(sample);
}

void LiveDiagnosis::keep(const LiveSample& sample) {
  samples_.push_back(sample);
  const std::int64_t oldest = sample.stamp - nanoseconds(settings_.longest_window);
  while (samples_.size() > settings_.memory || samples_.front().stamp < oldest) {
    samples_.pop_front();
  }
}

void LiveDiagnosis::simulate(const LiveSample& sample) {
  const std::int64_t length = nanoseconds(settings_.criteria.block);
  const std::int64_t begin = first_ + (sample.stamp - first_) / length * length;
  if (block_ && block_->begin != begin) {
    finishBlock();
  }
  if (!block_) {
    block_ = std::make_unique<Block>();
    block_->begin = begin;
    block_->last = begin;
  }
  Block& block = *block_;
  block.whole = block.whole && sample.stamp - block.last < length / 4;
  block.last = sample.stamp;
  block.samples += 1.0;
  block.force.add(sample.force);
  block.configured.add(sample.force - configured_model_->force(sample));
  block.re_estimated.add(re_estimated_model_ ? sample.force - re_estimated_model_->force(sample) : kNoForce);
  block.augmented.add(augmented_model_ ? sample.force - augmented_model_->force(sample) : kNoForce);
}

void LiveDiagnosis::finishBlock() {
  const Block& block = *block_;
  if (block.whole && block.samples >= kFewestInBlock && seconds(block.begin - first_) >= kSettling) {
    judgement_.addBlock({block.begin, block.force.deviation(block.samples), block.configured.deviation(block.samples),
                         re_estimated_model_ ? block.re_estimated.deviation(block.samples) : kNoForce,
                         augmented_model_ ? block.augmented.deviation(block.samples) : kNoForce});
    regime_begin_ = judgement_.regimeBegin().value_or(first_);
  }
  block_.reset();
}

std::int64_t LiveDiagnosis::windowBegin() const { return std::max(samples_.front().stamp, regime_begin_); }

bool LiveDiagnosis::lookIsDue() const {
  if (samples_.empty()) {
    return false;
  }
  const std::int64_t now = samples_.back().stamp;
  const std::int64_t begin = windowBegin();
  const double pause = std::clamp(0.5 * last_window_, kShortestPause, settings_.longest_pause);
  const bool is_new = seconds(last_look_ - regime_begin_) < settings_.shortest_window;  // no look covers the regime
  return seconds(now - begin) >= settings_.shortest_window && (is_new || seconds(now - last_look_) >= pause);
}

std::vector<log::Log> LiveDiagnosis::windowLogs(std::int64_t begin) const {
  const auto first =
      std::find_if(samples_.begin(), samples_.end(), [&](const LiveSample& sample) { return sample.stamp >= begin; });
  const auto before = static_cast<std::size_t>(first - samples_.begin());
  const std::size_t count = samples_.size() - before;
  std::size_t step = (count + settings_.most_samples - 1) / settings_.most_samples;
  if (step > 1) {
    step = std::min(step, largestStep(logOf(samples_, before, 1)));
  }
  const std::size_t taken = std::min(count, step * settings_.most_samples);
  return cut(logOf(samples_, samples_.size() - taken, step));
}

void LiveDiagnosis::look(const std::function<bool()>& stop) {
  const std::int64_t begin = windowBegin();
  last_look_ = samples_.back().stamp;
  last_window_ = seconds(last_look_ - begin);
  DiagnosisOptions options;
  options.threads = 1;
  options.resamplings = kResamplings;
  const io::Cancellable cancellable(stop);
  try {
    const std::vector<log::Log> logs = windowLogs(begin);
    const Diagnosis diagnosis = diagnose(configured_, logs, {}, options);
    ++findings_.looks;
    judgement_.addLook({diagnosis.answer.verdict, diagnosis.answer.effects});
    if (diagnosis.answer.effects.empty() && !judgement_.now().effects.empty()) {
      return;  // a look without an effect does not withdraw the named effect
    }
    findings_.stamp = last_look_;
    findings_.samples = 0;
    for (const log::Log& log : logs) {
      findings_.samples += log.size();
    }
    findings_.window = last_window_;
    takeUp(diagnosis);
  } catch (const log::LogError& error) {
    findings_.sentence = error.what();
  }
}

std::unique_ptr<LiveDiagnosis::Model> LiveDiagnosis::warmedUp(const io::ComponentDescription& component) const {
  auto model = std::make_unique<Model>(component);
  for (const LiveSample& sample : samples_) {
    model->force(sample);
  }
  return model;
}

void LiveDiagnosis::takeUp(const Diagnosis& diagnosis) {
  findings_.gap = diagnosis.gaps.unseen;
  findings_.where = diagnosis.answer.verdict == Verdict::none ? "" : placeOf(diagnosis.where.before);
  findings_.sentence = diagnosis.sentence;
  findings_.rig_findings = element::each(diagnosis.rig_findings, &measurement::RigFinding::text);
  findings_.probabilities =
      element::each(diagnosis.answer.effects, [&](const auto& effect) { return probabilityOf(effect, diagnosis); });
  findings_.confounded = element::each(diagnosis.answer.confounded,
                                       [](const auto& set) { return fmt::format("{}", fmt::join(set, " + ")); });
  const bool has_effect = !diagnosis.answer.effects.empty();
  if (block_) {
    block_->whole = false;  // the look includes the beginning of this block
  }
  re_estimated_model_ = has_effect ? warmedUp(diagnosis.re_estimated) : nullptr;
  augmented_model_ = has_effect ? warmedUp(diagnosis.law.augmented) : nullptr;
  candidate_.reset();
  if (has_effect || diagnosis.answer.verdict == Verdict::parameter_error) {
    candidate_ = diagnosis.law.augmented;
  }
}

LiveFindings LiveDiagnosis::findings() const {
  LiveFindings findings = findings_;
  findings.now = judgement_.now();
  if (!findings.now.verdict && augmented_model_) {
    findings.sentence = fmt::format("Not yet confirmed on new samples (evidence {:.2g}, required {:.2g}): {}",
                                    findings.now.evidence, findings.now.threshold, findings_.sentence);
  }
  return findings;
}

std::optional<io::ComponentDescription> LiveDiagnosis::found() const {
  const LiveVerdict now = judgement_.now();
  const bool closes = !now.effects.empty() || now.verdict == Verdict::parameter_error;
  return closes ? candidate_ : std::nullopt;
}

}  // namespace rubber_suspension::diagnosis::live
