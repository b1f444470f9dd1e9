// Implanted effects: on the page, for a terminal, as JSON.
#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <functional>
#include <map>

#include "diagnosis/report/json_parts.h"
#include "diagnosis/report/page.h"
#include "diagnosis/report/text.h"
#include "rubber_suspension/diagnosis/plan.h"

namespace rubber_suspension::diagnosis {
namespace {

using nlohmann::ordered_json;

std::string leastSizeText(double size) { return std::isfinite(size) ? fmt::format("{:.2g} %", 100.0 * size) : "none"; }

std::string namesText(const std::vector<std::string>& names, std::size_t most) {
  if (names.size() <= most) {
    return enumerated(names);
  }
  return enumerated({names.begin(), names.begin() + static_cast<std::ptrdiff_t>(most)}) +
         fmt::format(" (and {} more)", names.size() - most);
}

std::string outcomeTable(const CouldShow& could_show) {
  Table table({"implanted", "would be", "with, or as", "#left by other parameter values", "#least size seen"});
  for (const ImplantedEffect& row : could_show.implanted) {
    table.add({escape(spoken(row.effect)), outcomeText(row.outcome), escape(spoken(namesText(row.taken_for, 4))),
               wholePercent(row.visible_share) + " %", leastSizeText(row.least_size)});
  }
  return table.html();
}

// The matrix as a list: of each effect what its shapes would be named, largest share first.
std::string confusionTable(const CouldShow& could_show) {
  Table table({"implanted", "would be named first"});
  for (const ImplantedEffect& row : could_show.implanted) {
    std::multimap<double, std::string, std::greater<>> shares;
    for (std::size_t e = 0; e < row.named_as.size(); ++e) {
      if (row.named_as[e] > 0.0) {
        shares.emplace(row.named_as[e], spoken(could_show.effects[e]));
      }
    }
    if (row.nothing_named > 0.0) {
      shares.emplace(row.nothing_named, "nothing");
    }
    std::vector<std::string> texts;
    for (const auto& [share, name] : shares) {
      texts.push_back(fmt::format("{} {} %", name, wholePercent(share)));
    }
    table.add({escape(spoken(row.effect)), escape(enumerated(texts))});
  }
  return table.html();
}

// "Found: friction, creep. Out of reach: inertia.", which is all that fits on paper.
std::string outcomesInWords(const CouldShow& could_show) {
  std::string text;
  for (const char* outcome : {"found", "confounded", "taken_for", "unexplained", "out_of_reach"}) {
    std::vector<std::string> effects;
    for (const ImplantedEffect& row : could_show.implanted) {
      if (row.outcome == outcome) {
        effects.push_back(spoken(row.effect));
      }
    }
    if (!effects.empty()) {
      std::string sentence = outcomeText(outcome) + ": " + enumerated(effects) + ".";
      sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
      text += (text.empty() ? "" : " ") + sentence;
    }
  }
  return text;
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

std::string outcomeText(const std::string& outcome) {
  static const std::map<std::string, std::string> texts = {{"found", "found"},
                                                           {"confounded", "found in a set"},
                                                           {"taken_for", "taken for another"},
                                                           {"unexplained", "left unexplained"},
                                                           {"out_of_reach", "out of reach"}};
  return texts.at(outcome);
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
