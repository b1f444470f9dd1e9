// Excerpts of logs.
#include "diagnosis/excerpts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace rubber_suspension::diagnosis {
namespace {

constexpr std::size_t kWindows = 8;        // of a log: its beginning, its largest motion, and six of other amplitudes
constexpr double kCycles = 10.0;           // in a window: the first does not count, and some are to be left for folds
constexpr double kMoves = 0.1;             // of the deviation of the window that moves most: less is a standstill
constexpr double kCrossing = 0.5;          // of the deviation to both sides of the mean: a crossing beyond the noise
constexpr std::size_t kLeastShare = 2000;  // samples of a log, however many logs there are: ten cycles of 200 samples

struct Window {
  std::size_t first;
  std::size_t last;  // one behind
};

double deviationOf(const std::vector<double>& values, const Window& window) {
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(window.first);
  const auto last = values.begin() + static_cast<std::ptrdiff_t>(window.last);
  const auto count = static_cast<double>(window.last - window.first);
  const double mean = std::accumulate(first, last, 0.0) / count;
  const double squares =
      std::accumulate(first, last, 0.0, [&](double sum, double z) { return sum + (z - mean) * (z - mean); });
  return std::sqrt(squares / count);
}

// Samples of a cycle, by how often the displacement goes from one side of its mean to the other.
double samplesPerCycle(const std::vector<double>& displacement) {
  const auto count = static_cast<double>(displacement.size());
  const double mean = std::accumulate(displacement.begin(), displacement.end(), 0.0) / count;
  const double threshold = kCrossing * deviationOf(displacement, {0, displacement.size()});
  int side = 0;
  double crossings = 0.0;
  for (const double z : displacement) {
    const int now = z - mean > threshold ? 1 : z - mean < -threshold ? -1 : side;
    crossings += now * side < 0 ? 1.0 : 0.0;
    side = now;
  }
  return 2.0 * count / std::max(crossings, 1.0);
}

// Even parts of a log with as many samples each as a window of a share has.
std::vector<Window> windowsOf(const log::Log& log, std::size_t share) {
  const double least = kCycles * samplesPerCycle(log.displacement);
  const double most = static_cast<double>(share) / least;
  const auto windows = static_cast<std::size_t>(std::clamp(most, 1.0, static_cast<double>(kWindows)));
  const std::size_t length = share / windows;
  std::vector<Window> result;
  for (std::size_t first = 0; first + length <= log.size(); first += length) {
    result.push_back({first, first + length});
  }
  return result;
}

std::size_t largestMotion(const log::Log& log, const std::vector<Window>& windows) {
  const auto largest = std::max_element(log.displacement.begin(), log.displacement.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); });
  const auto sample = static_cast<std::size_t>(largest - log.displacement.begin());
  return std::min(sample / (windows[0].last - windows[0].first), windows.size() - 1);
}

// `count` of the windows by their place, ascending.
std::vector<std::size_t> choose(const log::Log& log, const std::vector<Window>& windows, std::size_t count) {
  std::vector<double> motion;
  std::transform(windows.begin(), windows.end(), std::back_inserter(motion),
                 [&](const Window& window) { return deviationOf(log.displacement, window); });
  const double least = kMoves * *std::max_element(motion.begin(), motion.end());
  std::vector<std::size_t> chosen;
  for (const std::size_t window : {std::size_t{0}, largestMotion(log, windows)}) {
    if (motion[window] >= least && chosen.size() < count && (chosen.empty() || chosen[0] != window)) {
      chosen.push_back(window);
    }
  }
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (motion[i] >= least && std::find(chosen.begin(), chosen.end(), i) == chosen.end()) {
      others.push_back(i);
    }
  }
  std::stable_sort(others.begin(), others.end(), [&](std::size_t a, std::size_t b) { return motion[a] < motion[b]; });
  const std::size_t further = std::min(count - chosen.size(), others.size());
  for (std::size_t i = 0; i < further; ++i) {  // the middles of as many groups of equal size
    chosen.push_back(others[(2 * i + 1) * others.size() / (2 * further)]);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

// Windows that touch are one.
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

template <class T>
std::vector<T> part(const std::vector<T>& values, const Window& window) {
  if (values.empty()) {
    return {};
  }
  return {values.begin() + static_cast<std::ptrdiff_t>(window.first),
          values.begin() + static_cast<std::ptrdiff_t>(window.last)};
}

log::Log excerpt(const log::Log& log, const Window& window) {
  const auto since = [&](std::size_t sample) { return log.time(sample) - log.time(0); };
  const double from = since(window.first);
  const double until = since(window.last - 1);
  log::Log result;
  result.name = fmt::format("{} ({:.0f} to {:.0f} s)", log.name, from, until);
  result.stamp = part(log.stamp, window);
  result.displacement = part(log.displacement, window);
  result.force = part(log.force, window);
  result.temperature = part(log.temperature, window);
  result.notes = log.notes;
  result.notes.push_back(fmt::format("excerpt of {:.0f} s", since(log.size() - 1)));
  return result;
}

// Most samples that each log may give, all together no more than `most`: what short ones leave goes to the long ones.
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

// The motion of a window in means over `coarse` samples each, but for what is left of them at its beginning.
LeadIn leadIn(const log::Log& log, const Window& window, std::size_t coarse) {
  const std::size_t count = (window.last - window.first) / coarse;
  LeadIn result;
  result.continues = window.first > 0;
  result.dt = (log.time(window.last - 1) - log.time(window.first)) /
              static_cast<double>(window.last - 1 - window.first) * static_cast<double>(coarse);
  for (std::size_t i = 0; i < count; ++i) {
    const auto end = log.displacement.begin() + static_cast<std::ptrdiff_t>(window.last - (count - 1 - i) * coarse);
    result.displacement.push_back(std::accumulate(end - static_cast<std::ptrdiff_t>(coarse), end, 0.0) /
                                  static_cast<double>(coarse));
  }
  return result;
}

void addExcerptsOfTheFit(const log::Log& log, std::size_t share, Excerpts& result) {
  const std::vector<Window> windows = windowsOf(log, share);
  const std::size_t count = share / (windows[0].last - windows[0].first);
  const std::size_t coarse = (log.size() - 1) / share + 1;
  std::size_t done = 0;
  for (const Window& window : joined(windows, choose(log, windows, count))) {
    result.lead_in.push_back(window.first > done ? leadIn(log, {done, window.first}, coarse) : LeadIn{});
    result.logs.push_back(excerpt(log, window));
    done = window.last;
  }
}

std::size_t samplesOf(const std::vector<log::Log>& logs) {
  return std::accumulate(logs.begin(), logs.end(), std::size_t{0},
                         [](std::size_t sum, const log::Log& log) { return sum + log.size(); });
}

}  // namespace

Excerpts makeExcerpts(const std::vector<log::Log>& logs, const std::vector<log::Log>& hold_out, std::size_t most) {
  Excerpts result;
  std::vector<std::size_t> sizes;
  for (const auto* list : {&logs, &hold_out}) {
    std::transform(list->begin(), list->end(), std::back_inserter(sizes),
                   [](const log::Log& log) { return log.size(); });
  }
  result.of = samplesOf(logs) + samplesOf(hold_out);
  const std::size_t share = fairShare(sizes, most);
  for (const log::Log& log : logs) {
    if (log.size() <= share) {
      result.logs.push_back(log);
      result.lead_in.emplace_back();
    } else {
      addExcerptsOfTheFit(log, share, result);
    }
  }
  for (const log::Log& log : hold_out) {
    result.hold_out.push_back(log.size() <= share ? log : excerpt(log, {0, share}));
  }
  result.samples = samplesOf(result.logs) + samplesOf(result.hold_out);
  return result;
}

void addLeadIns(const std::vector<LeadIn>& lead_in, std::vector<log::Record>& records) {
  for (std::size_t i = 0; i < lead_in.size(); ++i) {
    const std::vector<double>& z = lead_in[i].displacement;
    records[i].lead_in = Eigen::Map<const Eigen::VectorXd>(z.data(), static_cast<Eigen::Index>(z.size()));
    records[i].lead_in_dt = lead_in[i].dt;
    records[i].continues = lead_in[i].continues;
  }
}

}  // namespace rubber_suspension::diagnosis
