// Compares two reports.
#include "diagnosis/report/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "diagnosis/words/text.h"
#include "element/each.h"
#include "log/text.h"

namespace rubber_suspension::diagnosis::report {
namespace {

using nlohmann::json;

constexpr const char* kReportSchema = "rubber_suspension/gap_report/1";
constexpr std::size_t kLargestReport = 16UL * 1024 * 1024;  // bytes; a report on six logs has about 0.1 MB

struct Measured {
  double value = 0.0;
  std::array<double, 2> interval{};
  std::string unit;
};

double numberOf(const json& value) { return value.is_number() ? value.get<double>() : kNotComputed; }

std::array<double, 2> pairOf(const json& pair) { return {numberOf(pair.at(0)), numberOf(pair.at(1))}; }

std::vector<SizedValue> readSizes(const json& report, const char* list) {
  return element::each(report.value(list, json::array()), [](const json& entry) -> SizedValue {
    return {entry.at("owner"),
            entry.at("name"),
            entry.at("unit"),
            kNotComputed,
            numberOf(entry.at("value")),
            pairOf(entry.at("interval_95"))};
  });
}

measurement::RigFinding readFinding(const json& entry) {
  measurement::RigFinding finding;
  finding.log = entry.at("log");
  finding.finding = entry.at("finding");
  finding.value = numberOf(entry.at("value"));
  finding.interval_95 = pairOf(entry.at("interval_95"));
  finding.unit = entry.at("unit");
  finding.frequency = entry.value("frequency_Hz", 0.0);
  return finding;
}

gap::Quantity quantityOf(const std::string& word) {
  using gap::Quantity;
  for (const Quantity quantity :
       {Quantity::stiffness, Quantity::loss, Quantity::harmonics, Quantity::mean, Quantity::drift}) {
    if (toString(quantity) == word) {
      return quantity;
    }
  }
  throw std::invalid_argument("unknown quantity: " + word);
}

gap::GapCell readCell(const json& cell) {
  return {"", pairOf(cell.at("frequency_hz")), pairOf(cell.at("amplitude_m")), quantityOf(cell.at("quantity")),
          numberOf(cell.at("share"))};
}

Diagnosis readReport(const json& report) {
  Diagnosis d;
  const json& gap = report.at("gap");
  d.component = report.at("component");
  d.answer.verdict = verdictOf(report.at("verdict"));
  d.answer.effects = report.at("effects").get<std::vector<std::string>>();
  d.gaps.unseen = {numberOf(gap.at("as_configured")), numberOf(gap.at("re_estimated")), numberOf(gap.at("augmented")),
                   numberOf(gap.at("noise_floor"))};
  d.law.model_sizes = readSizes(report, "model_sizes");
  d.law.effect_sizes = readSizes(report, "effect_sizes");
  d.rig_findings = element::each(report.value("rig_findings", json::array()), readFinding);
  d.where.before = element::each(report.at("where"), readCell);
  if (report.contains("meta") && report.at("meta").is_object()) {
    d.run.date = report.at("meta").value("date", "");
  }
  return d;
}

std::string measuredText(const Measured& measured) {
  const SizedValue size{"", "", measured.unit, kNotComputed, measured.value, measured.interval};
  return measured.interval[0] < measured.interval[1] ? words::quantity(size)
                                                     : words::quantity(measured.value, measured.unit);
}

bool differ(const Measured& before, const Measured& after) {
  return before.interval[1] < after.interval[0] || after.interval[1] < before.interval[0];
}

using Values = std::map<std::string, Measured>;

Values sizesOf(const Diagnosis& d) {
  Values values;
  for (const auto* sizes : {&d.law.model_sizes, &d.law.effect_sizes}) {
    for (const SizedValue& size : *sizes) {
      values[size.owner == "specification" ? words::symbolOf(size.name) : words::spoken(size.owner + " " + size.name)] =
          {size.value, size.interval_95, size.unit};
    }
  }
  return values;
}

Values findingsOf(const Diagnosis& d) {
  Values values;
  for (const measurement::RigFinding& finding : d.rig_findings) {
    const std::string at = finding.frequency > 0.0 ? fmt::format(" at {:.0f} Hz", finding.frequency) : "";
    values[words::spoken(finding.finding) + at + " of " + finding.log] = {finding.value, finding.interval_95,
                                                                          finding.unit};
  }
  return values;
}

std::string effectsOf(const Diagnosis& d) {
  return d.answer.effects.empty() ? "none" : words::enumerated(d.answer.effects);
}

// Identifies a part of the gap by frequency band, amplitude band and quantity. Names of logs differ from day to day.
using Place = std::tuple<double, double, double, double, std::string>;

// Returns the size of each part of the gap as configured, divided by the standard deviation of the force.
std::map<Place, double> placesOf(const Diagnosis& d) {
  std::map<Place, double> squares;
  for (const gap::GapCell& cell : d.where.before) {
    // The band of mean and drift is ignored: it ends at half of the sampling rate, which depends on the recorder.
    const std::array<double, 2> band = cell.frequency[0] <= 0.0 ? std::array<double, 2>{} : cell.frequency;
    squares[{band[0], band[1], cell.amplitude[0], cell.amplitude[1], toString(cell.quantity)}] +=
        cell.share * d.gaps.unseen.as_configured * d.gaps.unseen.as_configured;
  }
  for (auto& [place, square] : squares) {
    square = std::sqrt(std::max(0.0, square));
  }
  return squares;
}

std::string placeText(const Place& place) {
  const auto& [f_low, f_high, a_low, a_high, kind] = place;
  const std::string band = f_high > 0.0 ? words::rangeText({f_low, f_high}, 1.0) + " Hz, " : "";
  return fmt::format("{} at {}{} mm", kind, band, words::rangeText({a_low, a_high}, 1e3));
}

class Comparer {
 public:
  Comparer(const Diagnosis& before, const Diagnosis& after) : before_(before), after_(after) {}

  std::vector<ReportChange> run() {
    compareWords("component", before_.component, after_.component);
    compareWords("verdict", toString(before_.answer.verdict), toString(after_.answer.verdict));
    compareWords("effects", effectsOf(before_), effectsOf(after_));
    compareGap("gap as configured", &Gap::as_configured);
    compareGap("gap re-estimated", &Gap::re_estimated);
    compareGap("gap augmented", &Gap::augmented);
    compareGap("noise floor", &Gap::noise_floor);
    compareValues(sizesOf(before_), sizesOf(after_), "not given");
    compareValues(findingsOf(before_), findingsOf(after_), "not found");
    comparePlaces();
    return std::move(changes_);
  }

 private:
  void compareWords(const std::string& what, const std::string& before, const std::string& after) {
    changes_.push_back({what, before, after, before != after});
  }

  double noise() const { return before_.gaps.unseen.noise_floor + after_.gaps.unseen.noise_floor; }

  void compareGap(const std::string& title, double Gap::* gap) {
    const double before = before_.gaps.unseen.*gap;
    const double after = after_.gaps.unseen.*gap;
    const bool differs = gap != &Gap::noise_floor &&
                         (std::isfinite(before) != std::isfinite(after) || std::abs(after - before) > noise());
    changes_.push_back({title, words::percent(before), words::percent(after), differs});
  }

  void compareValues(const Values& before, const Values& after, const std::string& absent) {
    Values all = before;
    all.insert(after.begin(), after.end());
    for (const auto& [name, value] : all) {
      const auto old_value = before.find(name);
      const auto new_value = after.find(name);
      const bool both = old_value != before.end() && new_value != after.end();
      changes_.push_back({name, old_value == before.end() ? absent : measuredText(old_value->second),
                          new_value == after.end() ? absent : measuredText(new_value->second),
                          !both || differ(old_value->second, new_value->second)});
    }
  }

  void comparePlaces() {
    constexpr std::size_t kMost = 8;
    std::map<Place, std::pair<double, double>> places;
    for (const auto& [place, size] : placesOf(before_)) {
      places[place].first = size;
    }
    for (const auto& [place, size] : placesOf(after_)) {
      places[place].second = size;
    }
    std::vector<std::pair<Place, std::pair<double, double>>> sorted(places.begin(), places.end());
    const auto change = [](const auto& entry) { return std::abs(entry.second.second - entry.second.first); };
    std::stable_sort(sorted.begin(), sorted.end(), [&](const auto& a, const auto& b) { return change(a) > change(b); });
    sorted.resize(std::min(sorted.size(), kMost));
    for (const auto& entry : sorted) {
      changes_.push_back({"gap in " + placeText(entry.first), words::percent(entry.second.first),
                          words::percent(entry.second.second), change(entry) > noise()});
    }
  }

  const Diagnosis& before_;
  const Diagnosis& after_;
  std::vector<ReportChange> changes_;
};

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  throw std::runtime_error(log::oneLine(
      fmt::format("{}: {}; accepted: a report.json of `diagnose`, schema {}", path, reason, kReportSchema)));
}

}  // namespace

EarlierReport::EarlierReport(const std::string& path) : path_(path) {
  const json report = json::parse(log::readInput(path, kLargestReport), nullptr, false);
  if (!report.is_object()) {
    refuse(path, "the file is not a JSON object");
  }
  if (!report.contains("schema") || report["schema"] != kReportSchema) {
    refuse(path, "the value of 'schema' is " + (report.contains("schema") ? report["schema"].dump() : "missing"));
  }
  try {
    report_ = readReport(report);
  } catch (const std::exception& error) {
    refuse(path, error.what());
  }
}

Comparison EarlierReport::compare(const Diagnosis& diagnosis) const {
  return {path_, report_.run.date, Comparer(report_, diagnosis).run()};
}

std::string toText(const Comparison& comparison) {
  if (comparison.with.empty()) {
    return "";
  }
  const std::vector<ReportChange> differing = element::those(comparison.changes, &ReportChange::differs);
  return "since " + comparison.with + (comparison.date.empty() ? "" : " (" + comparison.date + ")") + ":\n" +
         element::joined(differing, "",
                         [](const ReportChange& change) {
                           return "  " + log::oneLine(change.what + ": " + change.before + " -> " + change.after) +
                                  "\n";
                         }) +
         fmt::format("  {} of {} values have changed by no more than noise and intervals\n",
                     comparison.changes.size() - differing.size(), comparison.changes.size());
}

}  // namespace rubber_suspension::diagnosis::report
