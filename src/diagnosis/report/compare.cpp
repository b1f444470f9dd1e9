// Changes between two reports.
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
using words::escape;

constexpr const char* kReportSchema = "rubber_suspension/gap_report/1";
constexpr std::size_t kLargestReport = 16UL * 1024 * 1024;  // bytes; one about six logs has some 0.1 MB

// A value with the interval that its report gives it.
struct Measured {
  double value = 0.0;
  std::array<double, 2> interval{};
  std::string unit;
};

double numberOf(const json& value) { return value.is_number() ? value.get<double>() : std::nan(""); }

Measured measuredOf(const json& entry) {
  return {numberOf(entry.at("value")),
          {numberOf(entry.at("interval_95").at(0)), numberOf(entry.at("interval_95").at(1))},
          entry.at("unit").get<std::string>()};
}

std::string measuredText(const Measured& measured) {
  const SizedValue size{"", "", measured.unit, std::nan(""), measured.value, measured.interval};
  return measured.interval[0] < measured.interval[1] ? words::quantity(size)
                                                     : words::quantity(measured.value, measured.unit);
}

bool differ(const Measured& before, const Measured& after) {
  return before.interval[1] < after.interval[0] || after.interval[1] < before.interval[0];
}

using Values = std::map<std::string, Measured>;

// A list of a report; empty where it has none.
json listIn(const json& report, const char* name) { return report.value(name, json::array()); }

Values sizesIn(const json& report) {
  Values values;
  for (const char* list : {"model_sizes", "effect_sizes"}) {
    for (const json& entry : listIn(report, list)) {
      const std::string owner = entry.at("owner").get<std::string>();
      const std::string name = entry.at("name").get<std::string>();
      values[owner == "specification" ? words::symbolOf(name) : words::spoken(owner + " " + name)] = measuredOf(entry);
    }
  }
  return values;
}

Values findingsIn(const json& report) {
  Values values;
  for (const json& entry : listIn(report, "rig_findings")) {
    values[words::spoken(entry.at("finding").get<std::string>()) + " of " + entry.at("log").get<std::string>()] =
        measuredOf(entry);
  }
  return values;
}

std::string effectsIn(const json& report) {
  const auto effects = report.at("effects").get<std::vector<std::string>>();
  return effects.empty() ? "none" : words::enumerated(effects);
}

// A place of the gap, over all logs: these have other names on another day.
using Place = std::tuple<double, double, double, double, std::string>;

// The part of the gap as configured in each place, of the force's standard deviation.
std::map<Place, double> placesIn(const json& report) {
  std::map<Place, double> squares;
  const double gap = numberOf(report.at("gap").at("as_configured"));
  for (const json& cell : report.at("where")) {
    const json& f = cell.at("frequency_hz");
    const json& a = cell.at("amplitude_m");
    const std::string kind = cell.at("quantity").get<std::string>();
    // The band of mean and drift ends at half of the sampling rate, which is another one for another recorder.
    const bool whole = numberOf(f.at(0)) <= 0.0;
    squares[{whole ? 0.0 : numberOf(f.at(0)), whole ? 0.0 : numberOf(f.at(1)), numberOf(a.at(0)), numberOf(a.at(1)),
             kind}] += numberOf(cell.at("share")) * gap * gap;
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
  Comparer(const json& before, const json& after) : before_(before), after_(after) {}

  std::vector<ReportChange> run() {
    compareWords("component", before_.at("component"), after_.at("component"));
    compareWords("verdict", before_.at("verdict"), after_.at("verdict"));
    compareWords("effects", effectsIn(before_), effectsIn(after_));
    compareGaps();
    compareValues(sizesIn(before_), sizesIn(after_), "not given");
    compareValues(findingsIn(before_), findingsIn(after_), "not found");
    comparePlaces();
    return std::move(changes_);
  }

 private:
  void compareWords(const std::string& what, const std::string& before, const std::string& after) {
    changes_.push_back({what, before, after, before != after});
  }

  double noise() const {
    return numberOf(before_.at("gap").at("noise_floor")) + numberOf(after_.at("gap").at("noise_floor"));
  }

  void compareGaps() {
    static const std::vector<std::pair<std::string, std::string>> gaps = {{"as_configured", "gap as configured"},
                                                                          {"re_estimated", "gap re-estimated"},
                                                                          {"augmented", "gap augmented"},
                                                                          {"noise_floor", "noise floor"}};
    for (const auto& [name, title] : gaps) {
      const double before = numberOf(before_.at("gap").at(name));
      const double after = numberOf(after_.at("gap").at(name));
      const bool differs = name != "noise_floor" &&
                           (std::isfinite(before) != std::isfinite(after) || std::abs(after - before) > noise());
      changes_.push_back({title, words::percent(before), words::percent(after), differs});
    }
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

  // The places that changed most.
  void comparePlaces() {
    constexpr std::size_t kMost = 8;
    std::map<Place, std::pair<double, double>> places;
    for (const auto& [place, size] : placesIn(before_)) {
      places[place].first = size;
    }
    for (const auto& [place, size] : placesIn(after_)) {
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

  const json& before_;
  const json& after_;
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
    refuse(path, "is no JSON object");
  }
  if (!report.contains("schema") || report["schema"] != kReportSchema) {
    refuse(path, "schema is " + (report.contains("schema") ? report["schema"].dump() : "missing"));
  }
  try {
    Comparer(report, report).run();  // all that a comparison reads is there
  } catch (const json::exception& error) {
    refuse(path, error.what());
  }
  report_ = std::make_shared<const json>(report);
}

Comparison EarlierReport::compare(const Diagnosis& diagnosis) const {
  Comparison comparison;
  comparison.with = path_;
  if (report_->contains("meta") && report_->at("meta").is_object()) {
    comparison.date = report_->at("meta").value("date", "");
  }
  comparison.changes = Comparer(*report_, json::parse(toJson(diagnosis))).run();
  return comparison;
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
         fmt::format("  {} of {} values are as they were, within noise and intervals\n",
                     comparison.changes.size() - differing.size(), comparison.changes.size());
}

std::string comparisonSection(const Comparison& comparison) {
  if (comparison.with.empty()) {
    return "";
  }
  std::vector<words::Row> differing;
  std::vector<words::Row> same;
  for (const ReportChange& change : comparison.changes) {
    (change.differs ? differing : same).push_back({escape(change.what), escape(change.before), escape(change.after)});
  }
  const words::Row titles = {"", "before", "now"};
  return "<h2>What changed</h2>\n<p>Since <code>" + escape(comparison.with) + "</code>" +
         (comparison.date.empty() ? "" : ", " + escape(comparison.date)) +
         ". Values differ here where their 95 % intervals have nothing in common, gaps where they changed by more than "
         "both noise floors together.</p>\n" +
         (differing.empty() ? "<p>Nothing differs beyond noise and intervals.</p>\n"
                            : words::table(titles, differing)) +
         (same.empty() ? "" : words::folded("As before, within noise and intervals", words::table(titles, same)));
}

}  // namespace rubber_suspension::diagnosis::report
