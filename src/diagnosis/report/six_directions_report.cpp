// Writes the files of a diagnosis of six directions.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "diagnosis/report/augmented_yaml.h"
#include "diagnosis/report/run_record.h"
#include "diagnosis/words/text.h"
#include "element/each.h"
#include "io/output_files.h"
#include "io/page.h"
#include "log/new_file.h"
#include "rubber_suspension/diagnosis/six_directions.h"

namespace rubber_suspension::diagnosis {
namespace {

using element::each;
using nlohmann::ordered_json;
using words::percent;

constexpr double kSaid = 0.1;  // least share of a squared residual with which a pair is named
constexpr const char* kSixDirectionsMeaning =
    "Share of the squared residual force in one direction that the displacement in another direction predicts in "
    "addition to the motion in the first direction; computed with the augmented component, on parts of the logs that "
    "were not used in the fit";

std::string forceText(const CrossShare& pair) {
  return words::quantity(pair.force, component::isRotation(pair.of) ? "N m" : "N");
}

std::vector<std::string> directionNames() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    names.emplace_back(toString(static_cast<component::Direction>(i)));
  }
  return names;
}

std::string shareText(const CrossShare& pair) {
  return std::isnan(pair.share) ? "-" : words::wholePercent(pair.share) + " %";
}

// Returns for each direction the share of the squared residual of `of` that this direction predicts. The text is "-" if
// the share is not known, and empty for `of` itself.
std::vector<std::string> shareTexts(const std::vector<CrossShare>& map, component::Direction of) {
  std::vector<std::string> texts(component::kDirections);
  for (const CrossShare& pair : map) {
    if (pair.of == of) {
      texts[pair.by] = shareText(pair);
    }
  }
  return texts;
}

ordered_json directionJson(const DirectionDiagnosis& found) {
  const Diagnosis& d = found.diagnosis;
  return {{"direction", toString(found.direction)},
          {"report", std::string(toString(found.direction)) + "/report.json"},
          {"verdict", toString(d.answer.verdict)},
          {"effects", d.answer.effects},
          {"sentence", d.sentence},
          {"in_words",
           {{"gap",
             {{"as_configured", percent(d.gaps.unseen.as_configured)},
              {"augmented", percent(d.gaps.unseen.augmented)},
              {"noise_floor", percent(d.gaps.unseen.noise_floor)}}}}},
          {"gap",
           {{"as_configured", d.gaps.unseen.as_configured},
            {"re_estimated", d.gaps.unseen.re_estimated},
            {"augmented", d.gaps.unseen.augmented},
            {"noise_floor", d.gaps.unseen.noise_floor}}}};
}

ordered_json shareJson(const CrossShare& pair) {
  return {{"of", toString(pair.of)}, {"by", toString(pair.by)},
          {"share", pair.share},     {"share_text", shareText(pair)},
          {"rms", pair.force},       {"unit", component::isRotation(pair.of) ? "N m" : "N"}};
}

// Returns the diagnosis of the direction to which this name of a number belongs, and the name within that direction.
// Returns nothing if there is no diagnosis.
std::optional<std::pair<const Diagnosis*, std::string>> placeIn(const SixDirectionsDiagnosis& diagnosis,
                                                                const std::string& place) {
  for (const auto& [direction, d] : diagnosis.directions) {
    const std::string prefix = fmt::format("directions.{}.", toString(direction));
    if (hasComponentFile(d) && place.compare(0, prefix.size(), prefix) == 0) {
      return std::pair(&d, place.substr(prefix.size()));
    }
  }
  return std::nullopt;
}

std::string componentText(const SixDirectionsDiagnosis& diagnosis) {
  io::YamlStyle style;
  style.number = [&](const std::string& place, double value) {
    const auto found = placeIn(diagnosis, place);
    return found ? report::augmentedStyle(*found->first).number(found->second, value) : fmt::format("{}", value);
  };
  style.note = [&](const std::string& place) {
    const auto found = placeIn(diagnosis, place);
    return found ? report::augmentedStyle(*found->first).note(found->second) : "";
  };
  style.head = fmt::format(
      "# Diagnosis of {}, each direction separately; the other directions are as configured, except for "
      "radial_stiffness.\n",
      diagnosis.component);
  for (const auto& [direction, d] : diagnosis.directions) {
    style.head += fmt::format("# {}: {}. Gap {} as configured, {} with this file; noise floor {}.\n",
                              toString(direction), toString(d.answer.verdict), percent(d.gaps.unseen.as_configured),
                              percent(d.gaps.unseen.augmented), percent(d.gaps.unseen.noise_floor));
  }
  return io::toYaml({diagnosis.augmented}, style);
}

}  // namespace

std::string crossMapSentence(const SixDirectionsDiagnosis& diagnosis) {
  const auto said = element::those(diagnosis.cross_map, [](const CrossShare& pair) { return pair.share >= kSaid; });
  const std::vector<std::string> pairs = each(said, [](const CrossShare& pair) {
    return fmt::format("{} couples with {} ({} % of the squared residual, {} RMS)", toString(pair.of),
                       toString(pair.by), words::wholePercent(pair.share), forceText(pair));
  });
  return pairs.empty()
             ? fmt::format("No displacement predicts {} % or more of the squared residual force of another direction.",
                           words::wholePercent(kSaid))
             : words::enumerated(pairs) + ".";
}

std::string crossMapText(const SixDirectionsDiagnosis& diagnosis) {
  std::string text = fmt::format(
      "share of the squared residual in one direction (row) that another direction (column) predicts\n          {:>7}",
      fmt::join(directionNames(), ""));
  for (const DirectionDiagnosis& found : diagnosis.directions) {
    text += fmt::format("\n{:<10}{:>7}", toString(found.direction),
                        fmt::join(shareTexts(diagnosis.cross_map, found.direction), ""));
  }
  return text + "\n";
}

std::string toJson(const SixDirectionsDiagnosis& diagnosis) {
  const ordered_json report = {{"schema", "rubber_suspension/gap_report/six_directions/1"},
                               {"component", diagnosis.component},
                               {"directions", each(diagnosis.directions, directionJson)},
                               {"cross_map",
                                {{"meaning", kSixDirectionsMeaning},
                                 {"sentence", crossMapSentence(diagnosis)},
                                 {"shares", each(diagnosis.cross_map, shareJson)}}},
                               {"meta", report::metaJson(diagnosis.run)}};
  return report.dump(2) + "\n";
}

std::vector<std::string> sixDirectionsFiles() { return {"report.json", "augmented.yaml", "report.html"}; }

std::string writeReports(const SixDirectionsDiagnosis& diagnosis, const std::string& folder) {
  const std::filesystem::path path(folder);
  io::makeFolder(folder);
  io::removePage((path / "report.html").string());
  for (const auto& [direction, d] : diagnosis.directions) {
    writeReportData(d, (path / toString(direction)).string());
  }
  log::writeNewFile((path / "report.json").string(), toJson(diagnosis));
  log::writeNewFile((path / "augmented.yaml").string(), componentText(diagnosis));
  return io::renderPage((path / "report.json").string());
}

}  // namespace rubber_suspension::diagnosis
