// Implanted effects: on the page, for a terminal, as JSON.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "diagnosis/report/json_parts.h"
#include "diagnosis/report/page.h"
#include "diagnosis/words/text.h"
#include "rubber_suspension/diagnosis/plan.h"

namespace rubber_suspension::diagnosis {
namespace {

using nlohmann::ordered_json;

constexpr std::array kOutcomes = {"found", "confounded", "taken_for", "unexplained", "out_of_reach"};

std::string outcomeText(const std::string& outcome) {
  static const std::map<std::string, std::string> texts = {{"found", "found"},
                                                           {"confounded", "found in a set"},
                                                           {"taken_for", "taken for another"},
                                                           {"unexplained", "left unexplained"},
                                                           {"out_of_reach", "out of reach"}};
  return texts.at(outcome);
}

std::vector<std::string> effectsWith(const std::string& outcome, const CouldShow& could_show) {
  std::vector<std::string> effects;
  for (const ImplantedEffect& row : could_show.implanted) {
    if (row.outcome == outcome) {
      effects.push_back(spoken(row.effect));
    }
  }
  return effects;
}

std::string leastSizeText(double size) { return std::isfinite(size) ? fmt::format("{:.2g} %", 100.0 * size) : "none"; }

std::string namesText(const std::vector<std::string>& names, std::size_t most) {
  if (names.size() <= most) {
    return enumerated(names);
  }
  return enumerated({names.begin(), names.begin() + static_cast<std::ptrdiff_t>(most)}) +
         fmt::format(" (and {} more)", names.size() - most);
}

std::string outcomeTable(const CouldShow& could_show) {
  return table({"implanted", "would be", "with, or as", "#left by other parameter values", "#least size seen"},
               could_show.implanted, [](const ImplantedEffect& row) -> Row {
                 return {escape(spoken(row.effect)), outcomeText(row.outcome),
                         escape(spoken(namesText(row.taken_for, 4))), wholePercent(row.visible_share) + " %",
                         leastSizeText(row.least_size)};
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
      texts.push_back(fmt::format("{} {} %", name, wholePercent(share)));
    }
  }
  return enumerated(texts);
}

std::string confusionTable(const CouldShow& could_show) {
  return table({"implanted", "would be named first"}, could_show.implanted, [&](const ImplantedEffect& row) -> Row {
    return {escape(spoken(row.effect)), escape(namedFirst(could_show, row))};
  });
}

// "Found: friction, creep. Out of reach: inertia.", which is all that fits on paper.
std::string outcomesInWords(const CouldShow& could_show) {
  std::vector<std::string> sentences;
  for (const char* outcome : kOutcomes) {
    if (const auto effects = effectsWith(outcome, could_show); !effects.empty()) {
      sentences.push_back(capitalised(outcomeText(outcome)) + ": " + enumerated(effects) + ".");
    }
  }
  return fmt::format("{}", fmt::join(sentences, " "));
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

}  // namespace

std::string outcomesInNumbers(const CouldShow& could_show) {
  std::vector<std::string> counts;
  for (const char* outcome : kOutcomes) {
    if (const auto effects = effectsWith(outcome, could_show); !effects.empty()) {
      counts.push_back(fmt::format("{} {}", effects.size(), outcomeText(outcome)));
    }
  }
  return fmt::format("{}", fmt::join(counts, ", "));
}

std::string couldShowHtml(const CouldShow& could_show) {
  return fmt::format(
             "<p class=\"note screen\">Each effect is implanted into this component, motion and noise, in several "
             "shapes of its "
             "law, with an RMS force of {} % of the force's standard deviation ({}; noise floor {} %), and judged as "
             "the logs are. From the least size on, half of the shapes are found, alone or in a set, and wrong values "
             "of the model do not explain them.</p>\n",
             fmt::format("{:.2g}", 100.0 * could_show.size), escape(could_show.why),
             fmt::format("{:.2g}", 100.0 * could_show.noise)) +
         "<p>" + escape(outcomesInWords(could_show)) + "</p>\n<div class=screen>" + outcomeTable(could_show) +
         "</div>\n" + folded("What would be taken for what", confusionTable(could_show));
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

ordered_json toJson(const CouldShow& could_show) {
  ordered_json rows = ordered_json::array();
  for (const ImplantedEffect& row : could_show.implanted) {
    rows.push_back(rowJson(could_show, row));
  }
  return {{"size", could_show.size},
          {"size_N", could_show.force},
          {"why", could_show.why},
          {"noise_floor", could_show.noise},
          {"implanted", rows}};
}

}  // namespace rubber_suspension::diagnosis
