// Selects excerpts of long logs.
#include "diagnosis/prepare/excerpts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "diagnosis/prepare/lead_in.h"
#include "element/each.h"
#include "log/samples.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::diagnosis::prepare {
namespace {

constexpr std::size_t kWindows = 8;  // windows per log: its beginning, its largest motion, and six of other amplitudes
constexpr double kCyclesOfExcerpt = 10.0;  // cycles per window: the first is not compared, and folds need several
constexpr double kMoves = 0.1;  // a window that moves less than this share of the largest motion is at standstill
constexpr std::size_t kLeastShare = 2000;  // least number of samples per log: ten cycles of 200 samples

struct Window {
  std::size_t first;
  std::size_t last;  // one past the end
};

// Divides a log into windows of equal length, which is a multiple of the length of the stretches in the survey.
std::vector<Window> windowsOf(const LogSurvey& log, std::size_t share) {
  const double least = kCyclesOfExcerpt * log.motion.samplesPerCycle();
  const double most = static_cast<double>(share) / least;
  const auto windows = static_cast<std::size_t>(std::clamp(most, 1.0, static_cast<double>(kWindows)));
  const std::size_t stretch = log.motion.stretch();
  const std::size_t length = std::max(share / windows / stretch, std::size_t{1}) * stretch;
  std::vector<Window> result;
  for (std::size_t first = 0; first + length <= log.samples(); first += length) {
    result.push_back({first, first + length});
  }
  return result;
}

std::size_t largestMotion(const LogSurvey& log, const std::vector<Window>& windows) {
  return std::min(log.motion.largest() / (windows[0].last - windows[0].first), windows.size() - 1);
}

std::vector<double> motionOf(const LogSurvey& log, const std::vector<Window>& windows) {
  return element::each(windows, [&](const Window& window) { return log.motion.deviation(window.first, window.last); });
}

// Returns the standard deviation of the displacement [m] below which a window is at standstill.
double standstillOf(const std::vector<double>& motion) {
  return kMoves * *std::max_element(motion.begin(), motion.end());
}

// Returns up to `count` indices in ascending order. The first window and the window with most motion have priority.
std::vector<std::size_t> choose(const std::vector<double>& motion, std::size_t largest, std::size_t count) {
  const double least = standstillOf(motion);
  std::vector<std::size_t> chosen;
  for (const std::size_t window : {std::size_t{0}, largest}) {
    if (motion[window] >= least && chosen.size() < count && (chosen.empty() || chosen[0] != window)) {
      chosen.push_back(window);
    }
  }
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    if (motion[i] >= least && std::find(chosen.begin(), chosen.end(), i) == chosen.end()) {
      others.push_back(i);
    }
  }
  std::stable_sort(others.begin(), others.end(), [&](std::size_t a, std::size_t b) { return motion[a] < motion[b]; });
  const std::size_t further = std::min(count - chosen.size(), others.size());
  for (std::size_t i = 0; i < further; ++i) {  // the middle window of each of `further` groups
    chosen.push_back(others[(2 * i + 1) * others.size() / (2 * further)]);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::vector<Window> joined(const std::vector<Window>& windows, const std::vector<std::size_t>& chosen) {
  std::vector<Window> result;
  for (const std::size_t place : chosen) {
    if (!result.empty() && result.back().last == windows[place].first) {
      result.back().last = windows[place].last;
    } else {
      result.push_back(windows[place]);
    }
  }
  return result;
}

std::string nameOf(const log::Log& part, const LogSurvey& log) {
  const auto since = [&](std::int64_t stamp) { return static_cast<double>(stamp - log.steps.firstStamp()) * 1e-9; };
  return fmt::format("{} ({:.0f} to {:.0f} s)", log.source->name(), since(part.stamp.front()),
                     since(part.stamp.back()));
}

double secondsBetween(std::int64_t earlier, std::int64_t later) { return static_cast<double>(later - earlier) * 1e-9; }

// Returns the lead-in over a time gap. The lead-in ends one time step before the stretch, with the displacement on the
// straight line across the gap, as in `replay` and the node.
log::LeadIn stepOver(const log::Log& before, std::size_t last, const log::Log& stretch) {
  const double step = secondsBetween(stretch.stamp[0], stretch.stamp[1]);
  const double gap = secondsBetween(before.stamp[last], stretch.stamp[0]);
  const double z = before.displacement[last];
  return {gap - step, {z + (stretch.displacement[0] - z) * (gap - step) / gap}, true};
}

bool changes(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *low < *high;
}

// Splits a log or an excerpt at its time gaps, because a spectrum must not span a gap. Stretches from which no record
// can be made are omitted. If no stretch remains, the log is added unsplit.
void addStretches(const LogSurvey& survey, log::Log log, log::LeadIn lead_in, std::vector<log::Log>& logs,
                  std::vector<log::LeadIn>& lead_ins) {
  const std::vector<std::size_t> first = log::stretchesOf(log);
  std::size_t last = 0;      // last sample of the stretch that was added last
  std::size_t left_out = 0;  // number of samples in omitted stretches
  const std::size_t before = logs.size();
  for (std::size_t i = 0; first.size() > 1 && !log.force.empty() && i < first.size(); ++i) {
    const std::size_t end = i + 1 < first.size() ? first[i + 1] : log.size();
    log::Log stretch = log::samplesOf(log, first[i], end - first[i]);
    if (stretch.size() < log::kFewestSamples || !changes(stretch.displacement) || !changes(stretch.force)) {
      left_out += stretch.size();
      continue;
    }
    stretch.name = nameOf(stretch, survey);
    stretch.notes = log.notes;
    lead_ins.push_back(i == 0 ? lead_in : logs.size() == before ? log::LeadIn{} : stepOver(log, last, stretch));
    logs.push_back(std::move(stretch));
    last = end - 1;
  }
  if (logs.size() == before) {
    logs.push_back(std::move(log));
    lead_ins.push_back(std::move(lead_in));
    return;
  }
  logs[before].notes.push_back(
      fmt::format("{} time gaps: a new spectrum begins after each gap; {} samples between the gaps are skipped",
                  first.size() - 1, left_out));
}

// Reads the excerpts of a log and their lead-ins in one pass.
class ExcerptTaker {
 public:
  /// `windows` are in ascending order; `coarse` is the number of samples per step of a lead-in.
  ExcerptTaker(const LogSurvey& log, const std::vector<Window>& windows, std::size_t coarse, double standstill)
      : log_(log) {
    std::size_t done = 0;
    const std::int64_t longest_step = log.steps.evenSteps().longest_step;
    for (const Window& window : windows) {
      taken_.push_back({done, window, {done, window.first, coarse, standstill, longest_step}, {}});
      done = window.last;
    }
  }

  void take() {
    readAgain(log_, [this](const log::Log& block, std::size_t first) {
      for (Taken& excerpt : taken_) {
        addTo(excerpt, block, first);
      }
      return first + block.size() < taken_.back().window.last;
    });
  }

  std::vector<log::Log> excerpts() const {
    std::vector<log::Log> result;
    for (const Taken& excerpt : taken_) {
      result.push_back(excerpt.log);
      describe(excerpt.log, result.back());
    }
    return result;
  }

  std::vector<log::LeadIn> leadIns() const {
    std::vector<log::LeadIn> result;
    std::size_t done = 0;
    for (const Taken& excerpt : taken_) {
      result.push_back(excerpt.window.first > done ? excerpt.lead_in.finish() : log::LeadIn{});
      result.back().continues = done > 0;
      done = excerpt.window.last;
    }
    return result;
  }

 private:
  struct Taken {
    std::size_t led_from;
    Window window;
    LeadInBuilder lead_in;
    log::Log log;
  };

  static void addTo(Taken& excerpt, const log::Log& block, std::size_t first) {
    const std::size_t end = first + block.size();
    for (std::size_t i = std::max(first, excerpt.led_from); i < std::min(end, excerpt.window.first); ++i) {
      excerpt.lead_in.add(i, block.stamp[i - first], block.displacement[i - first]);
    }
    const std::size_t from = std::max(first, excerpt.window.first);
    const std::size_t until = std::min(end, excerpt.window.last);
    if (from < until) {
      log::appendSamples(block, from - first, until - from, excerpt.log);
    }
  }

  void describe(const log::Log& taken, log::Log& excerpt) const {
    excerpt.name = nameOf(taken, log_);
    excerpt.notes = log_.notes;
    excerpt.notes.push_back(fmt::format("excerpt of {:.0f} s", log_.duration()));
  }

  const LogSurvey& log_;
  std::vector<Taken> taken_;
};

log::Log takeWhole(const LogSurvey& survey) {
  log::Log log;
  readAgain(survey, [&](const log::Log& block, std::size_t) {
    log::appendSamples(block, 0, block.size(), log);
    return true;
  });
  log.name = survey.source->name();
  log.notes = survey.notes;
  return log;
}

// Returns the largest number of samples per log for which all logs together have at most `most` samples, but at least
// kLeastShare. Samples that short logs do not need go to long logs.
std::size_t fairShare(const std::vector<std::size_t>& sizes, std::size_t most) {
  std::vector<std::size_t> ascending = sizes;
  std::sort(ascending.begin(), ascending.end());
  std::size_t left = most;
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    const std::size_t share = left / (ascending.size() - i);
    if (ascending[i] > share) {
      return std::max(share, kLeastShare);
    }
    left -= ascending[i];
  }
  return ascending.back();
}

void addExcerptsOfTheFit(const LogSurvey& log, std::size_t share, Excerpts& result) {
  const std::vector<Window> windows = windowsOf(log, share);
  const std::size_t count = std::max(share / (windows[0].last - windows[0].first), std::size_t{1});
  const std::size_t coarse = (log.samples() - 1) / share + 1;
  const std::vector<double> motion = motionOf(log, windows);
  const std::vector<std::size_t> chosen = choose(motion, largestMotion(log, windows), count);
  ExcerptTaker taker(log, joined(windows, chosen), coarse, standstillOf(motion));
  taker.take();
  std::vector<log::Log> excerpts = taker.excerpts();
  std::vector<log::LeadIn> lead_ins = taker.leadIns();
  for (std::size_t i = 0; i < excerpts.size(); ++i) {
    addStretches(log, std::move(excerpts[i]), std::move(lead_ins[i]), result.logs, result.lead_in);
  }
}

log::Log beginningOf(const LogSurvey& log, std::size_t share) {
  ExcerptTaker taker(log, {{0, share}}, share, 0.0);
  taker.take();
  return taker.excerpts().front();
}

std::size_t samplesOf(const std::vector<log::Log>& logs) {
  return std::accumulate(logs.begin(), logs.end(), std::size_t{0},
                         [](std::size_t sum, const log::Log& log) { return sum + log.size(); });
}

}  // namespace

Excerpts makeExcerpts(const std::vector<LogSurvey>& logs, const std::vector<LogSurvey>& hold_out, std::size_t most) {
  Excerpts result;
  std::vector<std::size_t> sizes;
  for (const auto* list : {&logs, &hold_out}) {
    for (const LogSurvey& log : *list) {
      sizes.push_back(log.samples());
    }
  }
  result.of = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  const std::size_t share = fairShare(sizes, most);
  for (const LogSurvey& log : logs) {
    if (log.samples() <= share) {
      addStretches(log, takeWhole(log), {}, result.logs, result.lead_in);
    } else {
      addExcerptsOfTheFit(log, share, result);
    }
  }
  for (const LogSurvey& log : hold_out) {
    std::vector<log::LeadIn> each_is_new;
    addStretches(log, log.samples() <= share ? takeWhole(log) : beginningOf(log, share), {}, result.hold_out,
                 each_is_new);
  }
  result.samples = samplesOf(result.logs) + samplesOf(result.hold_out);
  return result;
}

std::vector<RawChannels> rawChannels(const std::vector<log::Log>& logs, const std::vector<log::Log>& hold_out) {
  std::vector<RawChannels> channels;
  for (const auto* list : {&logs, &hold_out}) {
    for (const log::Log& log : *list) {
      log::Record raw = log::rawRecord(log);
      channels.push_back({std::move(raw.raw_displacement), std::move(raw.force), std::move(raw.counts), {}});
    }
  }
  return channels;
}

}  // namespace rubber_suspension::diagnosis::prepare
