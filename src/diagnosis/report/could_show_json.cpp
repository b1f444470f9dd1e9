// Implanted effects as JSON.
#include "diagnosis/report/could_show_json.h"

#include <cmath>

namespace rubber_suspension::diagnosis {
namespace {

using nlohmann::ordered_json;

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
          {"least_size", std::isfinite(row.least_size) ? ordered_json(row.least_size) : ordered_json(nullptr)}};
}

}  // namespace

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
