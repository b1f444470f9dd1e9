// Reports simulated effects and the plans of experiments, for a terminal and as JSON.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "diagnosis/report/report_parts.h"
#include "diagnosis/report/run_record.h"
#include "diagnosis/words/text.h"
#include "element/each.h"
#include "io/output_files.h"
#include "io/page.h"
#include "log/new_file.h"
#include "rubber_suspension/diagnosis/plan.h"

namespace rubber_suspension::diagnosis {
namespace {

using nlohmann::ordered_json;
using words::spoken;

// Outcomes in JSON, and their names in the report.
constexpr std::pair<const char*, const char*> kOutcomes[] = {{"found", "found"},
                                                             {"confounded", "found in a set"},
                                                             {"taken_for", "named as another"},
                                                             {"unexplained", "unexplained"},
                                                             {"out_of_reach", "out of reach"}};

std::string outcomeText(const std::string& outcome) {
  const auto* const row =
      std::find_if(std::begin(kOutcomes), std::end(kOutcomes), [&](const auto& one) { return one.first == outcome; });
  return row->second;
}

// Calls `text` with the name and the effects of each outcome that occurs, and joins the results.
template <class Text>
std::string eachOutcome(const CouldShow& could_show, const std::string& separator, const Text& text) {
  std::vector<std::string> texts;
  for (const auto& [outcome, name] : kOutcomes) {
    const auto rows =
        element::those(could_show.implanted, [&, of = outcome](const auto& row) { return row.outcome == of; });
    if (!rows.empty()) {
      texts.push_back(text(name, element::each(rows, [](const ImplantedEffect& row) { return spoken(row.effect); })));
    }
  }
  return fmt::format("{}", fmt::join(texts, separator));
}

std::string percentText(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

std::string leastSizeText(double size) { return std::isfinite(size) ? percentText(size) : "none"; }

std::string namesText(const std::vector<std::string>& names, std::size_t most) {
  const auto shown = static_cast<std::ptrdiff_t>(std::min(most, names.size()));
  return words::enumerated({names.begin(), names.begin() + shown}) +
         (names.size() > most ? fmt::format(" (and {} more)", names.size() - most) : "");
}

// Returns the number of effects for each outcome, such as "12 found, 3 out of reach".
std::string outcomesInNumbers(const CouldShow& could_show) {
  return eachOutcome(could_show, ", ", [](const std::string& name, const std::vector<std::string>& effects) {
    return fmt::format("{} {}", effects.size(), name);
  });
}

// Returns a text such as "Found: friction, creep. Out of reach: inertia.", which is short enough for a printed page.
std::string outcomesInWords(const CouldShow& could_show) {
  return eachOutcome(could_show, " ", [](const std::string& name, const std::vector<std::string>& effects) {
    return words::capitalised(name) + ": " + words::enumerated(effects) + ".";
  });
}

ordered_json implantedJson(const CouldShow& could_show, const ImplantedEffect& row) {
  ordered_json named = ordered_json::object();
  for (std::size_t e = 0; e < row.named_as.size(); ++e) {
    if (row.named_as[e] > 0.0) {
      named[could_show.effects[e]] = row.named_as[e];
    }
  }
  return {{"effect", row.effect},
          {"outcome", row.outcome},
          {"taken_for", row.taken_for},
          {"named_as", named},
          {"nothing_named", row.nothing_named},
          {"visible_share", row.visible_share},
          {"least_size", row.least_size},
          {"outcome_text", outcomeText(row.outcome)},
          {"taken_for_text", namesText(row.taken_for, 4)},
          {"least_size_text", leastSizeText(row.least_size)}};
}

}  // namespace

std::string toText(const CouldShow& could_show) {
  std::string text = fmt::format("simulated effects, each with {} of the force ({}); noise {}\n",
                                 percentText(could_show.size), could_show.why, percentText(could_show.noise));
  text += fmt::format("{:<25}{:<19}{:>10}  {}\n", "implanted", "would be", "least size", "other effects");
  for (const ImplantedEffect& row : could_show.implanted) {
    text += fmt::format("{:<25}{:<19}{:>10}  {}\n", row.effect, outcomeText(row.outcome), leastSizeText(row.least_size),
                        namesText(row.taken_for, 4));
  }
  return text;
}

ordered_json report::toJson(const CouldShow& could_show) {
  const auto row_json = [&](const ImplantedEffect& row) { return implantedJson(could_show, row); };
  return {{"size", could_show.size},
          {"size_N", could_show.force},
          {"why", could_show.why},
          {"noise_floor", could_show.noise},
          {"size_text", percentText(could_show.size)},
          {"noise_floor_text", percentText(could_show.noise)},
          {"outcomes_in_numbers", outcomesInNumbers(could_show)},
          {"outcomes_in_words", outcomesInWords(could_show)},
          {"implanted", element::each(could_show.implanted, row_json)}};
}

std::string toJson(const Plan& plan) {
  const auto log_json = [](const PlannedLog& log) -> ordered_json {
    return {{"log", log.log},
            {"duration_s", log.duration},
            {"sampling_rate_hz", 1.0 / log.dt},
            {"largest_displacement_m", log.largest_displacement},
            {"highest_rate_m_per_s", log.highest_rate},
            {"largest_force_N", log.largest_force},
            {"in_words",
             {{"largest_displacement", words::quantity(log.largest_displacement, "m")},
              {"highest_rate", words::quantity(log.highest_rate, "m/s")},
              {"largest_force", words::quantity(log.largest_force, "N")}}}};
  };
  const ordered_json report = {{"schema", "rubber_suspension/experiment_plan/1"},
                               {"component", plan.component},
                               {"logs", element::each(plan.logs, log_json)},
                               {"could_show", report::toJson(plan.could_show)},
                               {"meta", report::metaJson(plan.run)}};
  return report.dump(2) + "\n";
}

std::vector<std::string> planFiles() { return {"plan.json", "plan.html"}; }

std::string writePlan(const Plan& plan, const std::string& folder) {
  io::makeFolder(folder);
  const std::filesystem::path path(folder);
  io::removePage((path / "plan.html").string());
  log::writeNewFile((path / "plan.json").string(), toJson(plan));
  return io::renderPage((path / "plan.json").string());
}

}  // namespace rubber_suspension::diagnosis
