// Implanted effects, and the plans that tell of them: on the page, for a terminal, as JSON.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>

#include "diagnosis/report/page.h"
#include "diagnosis/report/run_record.h"
#include "diagnosis/words/text.h"
#include "element/each.h"
#include "io/output_files.h"
#include "log/new_file.h"
#include "rubber_suspension/diagnosis/plan.h"

namespace rubber_suspension::diagnosis {
namespace {

using nlohmann::ordered_json;
using words::escape;
using words::spoken;

// Each outcome and what it is called.
constexpr std::pair<const char*, const char*> kOutcomes[] = {{"found", "found"},
                                                             {"confounded", "found in a set"},
                                                             {"taken_for", "taken for another"},
                                                             {"unexplained", "left unexplained"},
                                                             {"out_of_reach", "out of reach"}};

std::string outcomeText(const std::string& outcome) {
  const auto* const row =
      std::find_if(std::begin(kOutcomes), std::end(kOutcomes), [&](const auto& one) { return one.first == outcome; });
  return row->second;
}

// What `text` says of each outcome, by its name, and of the effects that have it; nothing of one that none has.
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

std::string leastSizeText(double size) { return std::isfinite(size) ? fmt::format("{:.2g} %", 100.0 * size) : "none"; }

std::string namesText(const std::vector<std::string>& names, std::size_t most) {
  const auto shown = static_cast<std::ptrdiff_t>(std::min(most, names.size()));
  return words::enumerated({names.begin(), names.begin() + shown}) +
         (names.size() > most ? fmt::format(" (and {} more)", names.size() - most) : "");
}

std::string outcomeTable(const CouldShow& could_show) {
  return words::table({"implanted", "would be", "with, or as", "#left by other parameter values", "#least size seen"},
                      could_show.implanted, [](const ImplantedEffect& row) -> words::Row {
                        return {escape(spoken(row.effect)), outcomeText(row.outcome),
                                escape(spoken(namesText(row.taken_for, 4))),
                                words::wholePercent(row.visible_share) + " %", leastSizeText(row.least_size)};
                      });
}

// What the shapes of an effect would be named, largest share first.
std::string namedFirst(const CouldShow& could_show, const ImplantedEffect& row) {
  std::multimap<double, std::string, std::greater<>> shares;
  for (std::size_t e = 0; e < row.named_as.size(); ++e) {
    shares.emplace(row.named_as[e], spoken(could_show.effects[e]));
  }
  shares.emplace(row.nothing_named, "nothing");
  std::vector<std::string> texts;
  for (const auto& [share, name] : shares) {
    if (share > 0.0) {
      texts.push_back(fmt::format("{} {} %", name, words::wholePercent(share)));
    }
  }
  return words::enumerated(texts);
}

std::string confusionTable(const CouldShow& could_show) {
  return words::table({"implanted", "would be named first"}, could_show.implanted,
                      [&](const ImplantedEffect& row) -> words::Row {
                        return {escape(spoken(row.effect)), escape(namedFirst(could_show, row))};
                      });
}

// "Found: friction, creep. Out of reach: inertia.", which is all that fits on paper.
std::string outcomesInWords(const CouldShow& could_show) {
  return eachOutcome(could_show, " ", [](const std::string& name, const std::vector<std::string>& effects) {
    return words::capitalised(name) + ": " + words::enumerated(effects) + ".";
  });
}

ordered_json rowJson(const CouldShow& could_show, const ImplantedEffect& row) {
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
          {"least_size", row.least_size}};
}

std::string logTable(const Plan& plan) {
  return words::table({"log", "#length [s]", "#rate [Hz]", "#largest |z|", "#largest speed", "#largest force"},
                      plan.logs, [](const PlannedLog& log) -> words::Row {
                        return {escape(log.log),
                                fmt::format("{:.1f}", log.duration),
                                fmt::format("{:.4g}", 1.0 / log.dt),
                                words::quantity(log.largest_displacement, "m"),
                                words::quantity(log.highest_rate, "m/s"),
                                words::quantity(log.largest_force, "N")};
                      });
}

}  // namespace

std::string report::outcomesInNumbers(const CouldShow& could_show) {
  return eachOutcome(could_show, ", ", [](const std::string& name, const std::vector<std::string>& effects) {
    return fmt::format("{} {}", effects.size(), name);
  });
}

std::string report::couldShowHtml(const CouldShow& could_show) {
  return fmt::format(
             "<p class=\"note screen\">Each effect is implanted into this component, motion and noise, in several "
             "shapes of its "
             "law, with an RMS force of {:.2g} % of the force's standard deviation ({}; noise floor {:.2g} %), and "
             "judged as "
             "the logs are. From the least size on, half of the shapes are found, alone or in a set, and wrong values "
             "of the model do not explain them.</p>\n",
             100.0 * could_show.size, escape(could_show.why), 100.0 * could_show.noise) +
         "<p>" + escape(outcomesInWords(could_show)) + "</p>\n<div class=screen>" + outcomeTable(could_show) +
         "</div>\n" + words::folded("What would be taken for what", confusionTable(could_show));
}

std::string toText(const CouldShow& could_show) {
  std::string text = fmt::format("effects of {:.2g} % of the force ({}), noise {:.2g} %\n", 100.0 * could_show.size,
                                 could_show.why, 100.0 * could_show.noise);
  text += fmt::format("{:<25}{:<19}{:>10}  {}\n", "implanted", "would be", "least size", "with, or as");
  for (const ImplantedEffect& row : could_show.implanted) {
    text += fmt::format("{:<25}{:<19}{:>10}  {}\n", row.effect, outcomeText(row.outcome), leastSizeText(row.least_size),
                        namesText(row.taken_for, 4));
  }
  return text;
}

ordered_json report::toJson(const CouldShow& could_show) {
  const auto row_json = [&](const ImplantedEffect& row) { return rowJson(could_show, row); };
  return {{"size", could_show.size},
          {"size_N", could_show.force},
          {"why", could_show.why},
          {"noise_floor", could_show.noise},
          {"implanted", element::each(could_show.implanted, row_json)}};
}

std::string toJson(const Plan& plan) {
  const auto log_json = [](const PlannedLog& log) -> ordered_json {
    return {{"log", log.log},
            {"duration_s", log.duration},
            {"sampling_rate_hz", 1.0 / log.dt},
            {"largest_displacement_m", log.largest_displacement},
            {"highest_rate_m_per_s", log.highest_rate},
            {"largest_force_N", log.largest_force}};
  };
  const ordered_json report = {{"schema", "rubber_suspension/experiment_plan/1"},
                               {"component", plan.component},
                               {"logs", element::each(plan.logs, log_json)},
                               {"could_show", report::toJson(plan.could_show)},
                               {"meta", report::metaJson(plan.run)}};
  return report.dump(2) + "\n";
}

std::string toHtml(const Plan& plan) {
  const std::string title = "Experiment plan: " + plan.component;
  return report::page(title,
                      fmt::format("<p class=kicker>{}</p>\n<h1>Of {} effects: {}.</h1>\n", escape(title),
                                  plan.could_show.implanted.size(), report::outcomesInNumbers(plan.could_show)) +
                          report::couldShowHtml(plan.could_show) + "<h2>The programmes</h2>\n" + logTable(plan) +
                          fmt::format("<p class=note>Forces are those of the component as configured. Made by:</p>\n"
                                      "<pre>{}</pre>\n",
                                      escape(plan.run.command_line)));
}

std::vector<std::string> planFiles() { return {"plan.json", "plan.html"}; }

void writePlan(const Plan& plan, const std::string& folder) {
  io::makeFolder(folder);
  log::writeNewFile((std::filesystem::path(folder) / "plan.json").string(), toJson(plan));
  log::writeNewFile((std::filesystem::path(folder) / "plan.html").string(), toHtml(plan));
}

}  // namespace rubber_suspension::diagnosis
