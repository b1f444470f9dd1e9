// The pictures of the first screen: where the gap lies, what removes it and how far, how sure that is. They are HTML,
// so that their text keeps its size on any screen; patterns tell on paper without colours what colours tell elsewhere.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/report/page.h"
#include "diagnosis/report/report_figures.h"
#include "diagnosis/words/text.h"
#include "element/each.h"

namespace rubber_suspension::diagnosis::report {
namespace {

using words::escape;
using words::percent;

using Band = std::array<double, 2>;

std::string figure(const std::string& title, const std::string& html, const std::string& caption) {
  return "<figure class=picture><h3>" + title + "</h3>" + html +
         (caption.empty() ? "" : "<figcaption>" + caption + "</figcaption>") + "</figure>\n";
}

// Bands of the cells, in their order; neighbours are put together until there are few enough to be read at 400 px.
std::vector<Band> bandsOf(const std::vector<gap::GapCell>& cells, Band gap::GapCell::*band, std::size_t most) {
  std::vector<Band> bands = element::each(cells, band);
  std::sort(bands.begin(), bands.end());
  bands.erase(std::unique(bands.begin(), bands.end()), bands.end());
  const std::size_t together = (bands.size() + most - 1) / most;
  std::vector<Band> result;
  for (std::size_t i = 0; i < bands.size(); i += together) {
    result.push_back({bands[i][0], bands[std::min(i + together, bands.size()) - 1][1]});
  }
  return result;
}

std::size_t placeOf(const std::vector<Band>& bands, const Band& band) {
  const auto found =
      std::find_if(bands.begin(), bands.end(), [&](const Band& one) { return band[0] >= one[0] && band[1] <= one[1]; });
  return static_cast<std::size_t>(found - bands.begin());
}

// "0.25\u20130.5": short enough for a cell at 400 px.
std::string shortText(const Band& band, double factor) {
  const auto text = [&](double value) {
    return fmt::format(value * factor < 10.0 ? "{:.2g}" : "{:.0f}", value * factor);
  };
  const std::string low = text(band[0]);
  const std::string high = text(band[1]);
  return low == high ? low : low + "\u2013" + high;
}

// The squared gap over bands of amplitude, the largest first, and of frequency.
struct Map {
  std::vector<Band> frequencies;
  std::vector<Band> amplitudes;
  std::vector<std::vector<double>> before;
  std::vector<std::vector<double>> after;
  std::vector<std::vector<bool>> measured;
  double elsewhere = 0.0;  // mean and drift as configured
  std::array<std::size_t, 2> largest{};

  explicit Map(const Diagnosis& d) {
    const auto cells = mappedCells(d, d.where.before);
    frequencies = bandsOf(cells, &gap::GapCell::frequency, 8);
    amplitudes = bandsOf(cells, &gap::GapCell::amplitude, 6);
    const std::vector<double> nothing(frequencies.size(), 0.0);
    before = after = std::vector<std::vector<double>>(amplitudes.size(), nothing);
    measured.assign(amplitudes.size(), std::vector<bool>(frequencies.size(), false));
    add(cells, before);
    add(mappedCells(d, d.where.after), after);
    for (const gap::GapCell& cell : d.where.before) {
      elsewhere += cell.frequency[0] > 0.0 ? 0.0 : cell.squared;
    }
    for (std::size_t a = 0; a < amplitudes.size(); ++a) {
      for (std::size_t f = 0; f < frequencies.size(); ++f) {
        if (before[a][f] > before[largest[0]][largest[1]]) {
          largest = {a, f};
        }
      }
    }
  }

  void add(const std::vector<gap::GapCell>& cells, std::vector<std::vector<double>>& squares) {
    for (const gap::GapCell& cell : cells) {
      const std::size_t a = placeOf(amplitudes, cell.amplitude);
      const std::size_t f = placeOf(frequencies, cell.frequency);
      if (a < amplitudes.size() && f < frequencies.size()) {
        squares[a][f] += cell.squared;
        measured[a][f] = true;
      }
    }
  }

  bool isAtLargest(const gap::GapCell& cell) const {
    return placeOf(amplitudes, cell.amplitude) == largest[0] && placeOf(frequencies, cell.frequency) == largest[1];
  }
};

// Shades 0 to 5 of the square root, from nothing to the largest before.
std::string mapTable(const Diagnosis& d, const Map& map, const std::vector<std::vector<double>>& squares,
                     const std::string& title) {
  constexpr double kShades = 5.0;
  const double most = std::sqrt(map.before[map.largest[0]][map.largest[1]]);
  std::string html =
      "<table class=map><caption>" + title + "</caption><thead><tr><th>" + words::inUnits(d, "[mm]") + " \\ [Hz]</th>";
  for (const Band& band : map.frequencies) {
    html += "<th>" + shortText(band, 1.0) + "</th>";
  }
  html += "</tr></thead><tbody>";
  for (std::size_t a = map.amplitudes.size(); a-- > 0;) {
    html += "<tr><th>" + shortText(map.amplitudes[a], 1e3) + "</th>";
    for (std::size_t f = 0; f < map.frequencies.size(); ++f) {
      const double size = std::sqrt(std::max(0.0, squares[a][f]));
      const bool largest = map.largest == std::array{a, f};
      const int shade = most > 0.0 ? static_cast<int>(std::ceil(kShades * std::min(1.0, size / most) - 0.5)) : 0;
      html += fmt::format("<td data-title=\"\" class=\"s{}{}\">{}</td>", shade, largest ? " largest" : "",
                          map.measured[a][f] ? fmt::format("{:.{}f}", 100.0 * size, size < 0.0995 ? 1 : 0) : "");
    }
    html += "</tr>";
  }
  return html + "</tbody></table>";
}

// "stiffness in sines": which quantity of which log has most of the framed cell.
std::string mostOf(const Diagnosis& d, const Map& map) {
  const auto cells = mappedCells(d, d.where.before);
  const auto found =
      std::find_if(cells.begin(), cells.end(), [&](const gap::GapCell& cell) { return map.isAtLargest(cell); });
  return found == cells.end() ? "" : fmt::format(", most of it {} in {}", gap::toString(found->quantity), found->log);
}

// A bar from 0 to `size` of `whole`, in parts; a whisker over an interval.
struct Bar {
  std::string name;
  std::string number;
  std::vector<std::pair<std::string, double>> parts;  // class, size
  Band whisker{};
};

std::string barRow(const Bar& bar, double whole) {
  const auto share = [&](double size) { return whole > 0.0 ? 100.0 * std::clamp(size / whole, 0.0, 1.0) : 0.0; };
  std::string rail;
  for (const auto& [kind, size] : bar.parts) {
    rail += fmt::format("<i class=\"{}\" style=\"width:{:.1f}%\"></i>", kind, share(size));
  }
  if (bar.whisker[1] > bar.whisker[0]) {
    rail += fmt::format("<b class=whisker style=\"left:{:.1f}%;width:{:.1f}%\"></b>", share(bar.whisker[0]),
                        share(bar.whisker[1]) - share(bar.whisker[0]));
  }
  return fmt::format("<div class=row><span>{}</span><span class=rail>{}</span><span class=n>{}</span></div>", bar.name,
                     rail, bar.number);
}

constexpr std::size_t kPatterns = 5;

std::string patternOf(std::size_t part) { return fmt::format("p{}", part % kPatterns); }

std::string keyEntry(const std::string& pattern, const std::string& text) {
  return "<span class=key><i class=\"" + pattern + "\"></i>" + text + "</span> ";
}

// What values and effects remove of the gap as configured, and what is left of it.
Bar configuredBar(const Diagnosis& d, std::string& key) {
  Bar bar{"as configured", percent(d.gaps.unseen.as_configured), {}};
  double left = 1.0;
  for (std::size_t i = 0; i < d.shares.size(); ++i) {
    const GapShare& share = d.shares[i];
    bar.parts.emplace_back(patternOf(i), share.share * d.gaps.unseen.as_configured);
    key += keyEntry(patternOf(i), fmt::format("{} {} %", i == 0 ? "other values" : escape(words::spoken(share.by)),
                                              words::wholePercent(share.share)));
    left -= share.share;
  }
  bar.parts.emplace_back("rest", std::max(0.0, left) * d.gaps.unseen.as_configured);
  key += keyEntry("rest", fmt::format("left {} %", words::wholePercent(std::max(0.0, left))));
  return bar;
}

std::string setName(const std::vector<std::string>& effects) {
  return escape(element::joined(effects, " + ", words::spoken));
}

std::string answerName(Verdict verdict, const std::vector<std::string>& effects) {
  return !effects.empty()                      ? setName(effects)
         : verdict == Verdict::none            ? "no gap"
         : verdict == Verdict::parameter_error ? "other values alone"
                                               : "none of the list";
}

}  // namespace

std::string whereMaps(const Diagnosis& d) {
  const Map map(d);
  if (map.frequencies.empty()) {
    return "";
  }
  const Band frequency = map.frequencies[map.largest[1]];
  const Band amplitude = map.amplitudes[map.largest[0]];
  std::string caption =
      fmt::format("RMS of the residual in % of the force. Framed: the largest as configured, at {} Hz and {}{}.",
                  words::rangeText(frequency, 1.0), words::inUnits(d, words::rangeText(amplitude, 1e3) + " mm"),
                  escape(mostOf(d, map)));
  if (map.elsewhere > 1e-8) {
    caption += fmt::format(" Mean and drift have {} besides.", percent(std::sqrt(map.elsewhere)));
  }
  caption += fmt::format(" <a class=screen href=\"{0}\">{0}</a>", figureDataFile(kWhere));
  return figure("Where",
                "<div class=maps>" + mapTable(d, map, map.before, "before: as configured") +
                    mapTable(d, map, map.after, "after: augmented") + "</div>",
                caption);
}

std::string gapBars(const Diagnosis& d) {
  const Gap& gap = d.gaps.unseen;
  const double whole = std::max({gap.as_configured, gap.re_estimated, gap.augmented, gap.noise_floor});
  std::string key;
  std::vector<Bar> bars = {configuredBar(d, key)};
  const double closable = gap.re_estimated - gap.noise_floor;
  const bool interval = !d.answer.effects.empty() && closable > 0.0;
  const auto at = [&](double closed) { return std::max(0.0, gap.re_estimated - std::min(1.0, closed) * closable); };
  bars.push_back({"re-estimated", percent(gap.re_estimated), {{"plain", gap.re_estimated}}});
  bars.push_back({"augmented", percent(gap.augmented), {{"rest", gap.augmented}}});
  if (interval) {
    bars.back().whisker = {at(d.gaps.closed_interval[1]), at(d.gaps.closed_interval[0])};
  }
  bars.push_back({"noise", percent(gap.noise_floor), {{"floor", gap.noise_floor}}});
  std::string caption = "Gap: RMS of the force difference over the standard deviation of the force.";
  if (interval) {
    caption +=
        fmt::format(" Of what other values leave above the noise, {} % is removed (95 %, whisker: {} to {} %).",
                    words::wholePercent(d.gaps.closed), words::wholePercent(std::min(1.0, d.gaps.closed_interval[0])),
                    words::wholePercent(std::min(1.0, d.gaps.closed_interval[1])));
  }
  return figure("Which, and how far",
                "<div class=bars>" + element::joined(bars, "", [&](const Bar& bar) { return barRow(bar, whole); }) +
                    "</div><p class=keys>" + key + "</p>",
                caption);
}

std::string probabilityBars(const Diagnosis& d) {
  std::vector<std::pair<std::string, double>> answers = {
      {answerName(d.answer.verdict, d.answer.effects), d.answer.probability}};
  for (const Alternative& other : d.answer.alternatives) {
    answers.emplace_back(answerName(other.verdict, other.effects), other.probability);
  }
  constexpr std::size_t kMost = 5;
  answers.resize(std::min(answers.size(), kMost));
  double rest = 1.0;
  for (const auto& answer : answers) {
    rest -= answer.second;
  }
  constexpr double kWorthABar = 5e-3;
  if (rest > kWorthABar) {
    answers.emplace_back("all else", rest);
  }
  const std::string rows = element::joined(answers, "", [](const auto& answer) {
    return barRow({answer.first, words::chance(answer.second) + " %", {{"plain", answer.second}}}, 1.0);
  });
  return figure("How sure", "<div class=bars>" + rows + "</div>",
                "Probability of each set of effects, given the logs.");
}

}  // namespace rubber_suspension::diagnosis::report
