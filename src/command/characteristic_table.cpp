// Computes the table of a component, and notes on what the table cannot show.
#include "command/characteristic_table.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "command/sweep_values.h"
#include "element/refuse.h"
#include "estimation/root.h"
#include "io/progress.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::command {
namespace {

constexpr double kWidest = 1.0;  // [m]; more than the travel of any suspension component

std::vector<std::string> notesOnTable(const component::Component& component) {
  const char* const kPath =
      "friction depends on the path: the table does not determine its force under two sines at once";
  // For each law, what its settled loop under a sine does not show.
  static const std::map<std::string, std::string> losses = {
      {"stress_softening", "the force softens over the first cycles; the table holds the state after them"},
      {"self_heating", "the component heats up over minutes; the table holds the warm state under each sine"},
      {"time_delay", "the table shows a delay of the force as a loss angle that rises with frequency"},
      {"force_offset", "the table does not show a constant force"},
      {"force_drift", "the table does not show a drift of the force"},
      {"creep", "the table does not show creep at rest, but slightly more stiffness and loss at low frequency"},
      {"friction", kPath},
      {"coulomb_friction", kPath},
      {"iwan", kPath},
      {"iwan_table", kPath}};
  std::vector<std::string> notes;
  for (const element::ElementDescription& element : component.elements()) {
    const auto found = losses.find(element.type);
    if (found != losses.end()) {
      notes.push_back(element.type + ": " + found->second);
    }
  }
  if (!component.linear()) {
    notes.emplace_back(
        "the component is nonlinear: stiffness and loss angle are those of the whole loop under one sine; the table "
        "does not contain the shape of the loop");
  }
  return notes;
}

// Returns the first harmonic of the force divided by A, for a displacement with the phase of -A cos(phase).
std::complex<double> firstHarmonic(const response::SettledLoop& loop) {
  std::complex<double> sum = 0.0;
  const std::size_t samples = loop.force.size();
  for (std::size_t i = 0; i < samples; ++i) {
    const double phase = 2.0 * element::kPi * static_cast<double>(i) / static_cast<double>(samples);
    sum += loop.force[i] * std::complex<double>(-std::cos(phase), std::sin(phase));
  }
  return 2.0 * sum / (static_cast<double>(samples) * loop.amplitude);
}

TableRow rowAt(const component::Component& component, double frequency, double amplitude, double preload, double mean) {
  TableRow row;
  row.preload = preload;
  row.mean = mean;
  if (const auto stiffness = component.complexStiffness(frequency)) {
    row.point = {frequency, amplitude, response::characteristicsOfEllipse(*stiffness, amplitude), true};
    row.complex_stiffness = *stiffness;
    return row;
  }
  const response::SettledLoop loop = response::simulateSettledLoop(component, frequency, amplitude, loopsAbout(mean));
  row.point = {frequency, amplitude, loop.characteristics(), loop.settled};
  row.complex_stiffness = firstHarmonic(loop);
  return row;
}

}  // namespace

double restingDisplacement(const component::Component& component, double force) {
  component::ComponentState state = component.makeState();
  const auto excess = [&](double displacement) { return component.initialise(state, displacement).total - force; };
  const double at_rest = excess(0.0);
  if (at_rest == 0.0) {
    return 0.0;
  }
  const double end = at_rest < 0.0 ? kWidest : -kWidest;
  const double at_end = excess(end);
  element::refuseIf(
      !(at_rest * at_end <= 0.0),
      "preload: {:g} N is not reached within {:g} m; accepted: a force that the component carries at rest", force,
      kWidest);
  return end > 0.0 ? estimation::rootBetween(excess, 0.0, end, at_rest, at_end)
                   : estimation::rootBetween(excess, end, 0.0, at_end, at_rest);
}

CharacteristicTable makeTable(const std::string& name, const component::Component& component, const TableGrid& grid) {
  CharacteristicTable table;
  table.component = name;
  table.notes = notesOnTable(component);
  io::Progress progress("table of " + name, grid.preloads.size() * grid.amplitudes.size() * grid.frequencies.size());
  for (const double preload : grid.preloads) {
    const double mean = preload == 0.0 ? 0.0 : restingDisplacement(component, preload);
    for (const double amplitude : grid.amplitudes) {
      for (const double frequency : grid.frequencies) {
        table.rows.push_back(rowAt(component, frequency, amplitude, preload, mean));
        if (!table.rows.back().point.settled) {
          table.notes.push_back(
              fmt::format("{:g} Hz, {:g} m, {:g} N: the loop did not settle", frequency, amplitude, preload));
        }
        progress.advance(1);
      }
    }
  }
  return table;
}

std::string toCsv(const CharacteristicTable& table) {
  std::string text =
      "frequency_Hz,amplitude_m,preload_N,mean_displacement_m,stiffness_N_per_m,loss_angle_rad,"
      "storage_stiffness_N_per_m,loss_stiffness_N_per_m\n";
  for (const TableRow& row : table.rows) {
    text += fmt::format("{},{},{},{},{},{},{},{}\n", row.point.frequency, row.point.amplitude, row.preload, row.mean,
                        row.point.characteristics.stiffness, row.point.characteristics.loss_angle,
                        row.complex_stiffness.real(), row.complex_stiffness.imag());
  }
  return text;
}

}  // namespace rubber_suspension::command
