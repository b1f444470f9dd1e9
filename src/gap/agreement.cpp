// Computes the agreement of two forces and writes it as a table and as JSON.
#include "gap/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "element/largest_number.h"
#include "element/refuse.h"
#include "gap/last_cycles.h"
#include "log/even_blocks.h"
#include "log/samples.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::gap {
namespace {

using nlohmann::ordered_json;

// Returns a log whose two channels are the measured and the simulated force.
log::Log bothForces(const log::Log& log, const std::vector<double>& simulated, std::size_t first) {
  const auto from = static_cast<std::ptrdiff_t>(first);
  log::Log both;
  both.stamp.assign(log.stamp.begin() + from, log.stamp.end());
  both.displacement.assign(log.force.begin() + from, log.force.end());
  both.force.assign(simulated.begin() + from, simulated.end());
  return both;
}

Iso18571 ratingOf(const log::Log& both) {
  log::TimeSteps steps;
  steps.add(both);
  std::vector<double> measured;
  std::vector<double> simulated;
  const auto append = [&](const log::EvenBlocks::Piece& piece) {
    measured.insert(measured.end(), piece.displacement, piece.displacement + piece.samples);
    simulated.insert(simulated.end(), piece.force, piece.force + piece.samples);
  };
  log::EvenBlocks even(steps.evenSteps());
  even.add(both, append);
  even.finish(append);
  const auto size = static_cast<Eigen::Index>(measured.size());
  return rateIso18571(Eigen::Map<const Eigen::VectorXd>(measured.data(), size),
                      Eigen::Map<const Eigen::VectorXd>(simulated.data(), size));
}

// Adds the work per cycle, over whole cycles of the motion.
void addEnergies(const log::Log& log, const log::Log& both, std::size_t first, Agreement& agreement) {
  log::Log motion;
  motion.displacement.assign(log.displacement.begin() + static_cast<std::ptrdiff_t>(first), log.displacement.end());
  motion.stamp = both.stamp;
  const std::vector<std::size_t> crossings = meanCrossings(motion);
  if (crossings.size() < 3) {
    return;
  }
  const std::size_t cycles = (crossings.size() - 1) / 2;
  const auto energy = [&](const std::vector<double>& force) {
    double work = 0.0;
    for (std::size_t i = crossings[0] + 1; i <= crossings[2 * cycles]; ++i) {
      work += 0.5 * (force[i] + force[i - 1]) * (motion.displacement[i] - motion.displacement[i - 1]);
    }
    return work / static_cast<double>(cycles);
  };
  agreement.measured_energy = energy(both.displacement);
  agreement.simulated_energy = energy(both.force);
}

// One line of the table: a number, its limit, and whether the number is within the limit.
struct Row {
  std::string name;
  std::string value;
  std::string limit;
  bool kept = true;
};

Row rowOf(const std::string& name, const std::string& value, std::optional<double> figure, std::optional<double> limit,
          const std::string& limit_text, bool at_least = false) {
  const bool kept = !limit || (figure && (at_least ? *figure >= *limit : *figure <= *limit));
  return {name, value, limit ? (at_least ? "at least " : "at most ") + limit_text : "", kept};
}

std::string energyText(const Agreement& a) {
  if (!a.measured_energy) {
    return "none, because the motion has no cycle";
  }
  const auto error = a.energyError();
  return fmt::format("{:.6g} J measured, {:.6g} J simulated{}", *a.measured_energy, *a.simulated_energy,
                     error ? fmt::format(" ({:+.2f} %)", 100.0 * *error) : "");
}

std::string ratingText(const Iso18571& iso) {
  return fmt::format("{:.3f} ({}): corridor {:.3f}, phase {:.3f}, magnitude {:.3f}, slope {:.3f}", iso.total,
                     iso18571Grade(iso.total), iso.corridor, iso.phase, iso.magnitude, iso.slope);
}

std::vector<Row> rowsOf(const ComparedForce& c) {
  const Agreement& a = c.agreement;
  const std::string unit = c.isMoment() ? "N m" : "N";
  const auto text = [](std::optional<double> limit, double factor, const std::string& of) {
    return fmt::format("{:g} {}", limit.value_or(0.0) * factor, of);
  };
  const auto error = a.energyError();
  return {
      rowOf("gap", fmt::format("{:.4f}", a.gap), a.gap, c.limits.gap, fmt::format("{:g}", c.limits.gap.value_or(0))),
      rowOf("RMS error", fmt::format("{:.6g} {}", a.rms, unit), a.rms, c.limits.rms, text(c.limits.rms, 1.0, unit)),
      rowOf("peak error", fmt::format("{:.6g} {}, {:.6g} s after the start", a.peak, unit, a.peak_time), a.peak,
            c.limits.peak, text(c.limits.peak, 1.0, unit)),
      rowOf("energy per cycle", energyText(a), error ? std::optional<double>(std::abs(*error)) : std::nullopt,
            c.limits.energy, text(c.limits.energy, 100.0, "%")),
      rowOf("ISO/TS 18571", ratingText(a.iso18571), a.iso18571.total, c.limits.iso18571,
            fmt::format("{:g}", c.limits.iso18571.value_or(0)), true)};
}

std::vector<std::string> notesOf(const Iso18571& iso) {
  std::vector<std::string> notes;
  if (iso.repeats) {
    notes.emplace_back(
        "the measured force is periodic, but ISO/TS 18571 applies to signals that are not periodic: its shift in time "
        "may lead to another cycle");
  }
  if (iso.blocks > 1) {
    notes.push_back(fmt::format("the magnitude of ISO/TS 18571 was computed in {} blocks: the log exceeds {} samples",
                                iso.blocks, kWarpedWhole));
  }
  return notes;
}

ordered_json jsonOf(const ComparedForce& c) {
  const Agreement& a = c.agreement;
  const auto orNull = [](std::optional<double> value) { return value ? ordered_json(*value) : ordered_json(nullptr); };
  const std::string unit = c.isMoment() ? "_Nm" : "_N";
  ordered_json json = {{"gap", a.gap},
                       {"rms" + unit, a.rms},
                       {"peak_error" + unit, a.peak},
                       {"peak_error_time_s", a.peak_time},
                       {"energy_per_cycle",
                        {{"measured_J", orNull(a.measured_energy)},
                         {"simulated_J", orNull(a.simulated_energy)},
                         {"error", orNull(a.energyError())}}},
                       {"iso18571",
                        {{"corridor", a.iso18571.corridor},
                         {"phase", a.iso18571.phase},
                         {"magnitude", a.iso18571.magnitude},
                         {"slope", a.iso18571.slope},
                         {"total", a.iso18571.total}}},
                       {"notes", notesOf(a.iso18571)}};
  json["beyond_limits"] = ordered_json::array();
  for (const Row& row : rowsOf(c)) {
    if (!row.kept) {
      json["beyond_limits"].push_back(row.name);
    }
  }
  return json;
}

}  // namespace

std::optional<double> Agreement::energyError() const {
  return measured_energy && *measured_energy != 0.0
             ? std::optional<double>((*simulated_energy - *measured_energy) / std::abs(*measured_energy))
             : std::nullopt;
}

Agreement agreementOf(const log::Log& log, const std::vector<double>& simulated, std::size_t first) {
  element::refuseIf(simulated.size() != log.size() || log.force.size() != log.size(),
                    "{}: {} measured and {} simulated forces for {} samples; accepted: one measured and one simulated "
                    "force for each sample",
                    log.name, log.force.size(), simulated.size(), log.size());
  element::refuseIf(first + 2 > log.size(), "{}: fewer than two samples remain to be compared", log.name);
  const log::Log both = bothForces(log, simulated, first);
  for (std::size_t i = 0; i < both.size(); ++i) {
    element::refuseIf(std::abs(both.force[i]) > element::kLargestNumber,
                      "{}: sample {}, {:g} s after the start: the simulated force is {:g} N; accepted: up to {:g} N",
                      log.name, first + i + 1, log.duration(0, first + i), both.force[i], element::kLargestNumber);
  }
  Agreement agreement;
  const std::vector<double> counts =
      log.counts.empty()
          ? log.counts
          : std::vector<double>(log.counts.begin() + static_cast<std::ptrdiff_t>(first), log.counts.end());
  agreement.gap = relativeGap(both.displacement, both.force, counts);
  double squares = 0.0;
  double compared = 0.0;
  for (std::size_t i = 0; i < both.size(); ++i) {
    if (!log::isCounted(log, first + i)) {
      continue;
    }
    compared += 1.0;
    const double difference = std::abs(both.force[i] - both.displacement[i]);
    squares += difference * difference;
    if (!(difference <= agreement.peak)) {
      agreement.peak = difference;
      agreement.peak_time = log.duration(0, first + i);
    }
  }
  agreement.rms = std::sqrt(squares / compared);
  addEnergies(log, both, first, agreement);
  agreement.iso18571 = ratingOf(both);
  return agreement;
}

std::string agreementTable(const ComparedForce& compared) {
  std::string table = compared.direction.empty() ? "" : compared.direction + ":\n";
  for (const Row& row : rowsOf(compared)) {
    table += fmt::format("  {:18}{}{}\n", row.name, row.value,
                         row.limit.empty() ? "" : fmt::format("; {}: {}", row.limit, row.kept ? "kept" : "BEYOND"));
  }
  for (const std::string& note : notesOf(compared.agreement.iso18571)) {
    table += "  note: " + note + "\n";
  }
  return table;
}

std::string beyondLimits(const ComparedForce& compared) {
  std::string text;
  for (const Row& row : rowsOf(compared)) {
    if (!row.kept) {
      text += fmt::format("{}{}{}: {}, accepted: {}", text.empty() ? "" : "; ",
                          compared.direction.empty() ? "" : compared.direction + ": ", row.name, row.value, row.limit);
    }
  }
  return text;
}

std::string agreementJson(const std::string& component, const std::string& log,
                          const std::vector<ComparedForce>& compared) {
  ordered_json json = {{"schema", "rubber_suspension/agreement/1"}, {"component", component}, {"log", log}};
  for (const ComparedForce& one : compared) {
    if (one.direction.empty()) {
      json.update(jsonOf(one));
    } else {
      json["directions"][one.direction] = jsonOf(one);
    }
  }
  return json.dump(2) + "\n";
}

}  // namespace rubber_suspension::gap
