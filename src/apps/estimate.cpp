// The command `estimate` prints parameters, stiffness and loss angle of components. It estimates the parameters from a
// specification or a data sheet, or identifies them from logs or a table.
#include "command/estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "command/data_sheet.h"
#include "command/identify.h"
#include "command/linear_part.h"
#include "command/measured_table.h"
#include "command/table_fit_text.h"
#include "command_line/command.h"
#include "command_line/component_options.h"
#include "command_line/log_options.h"
#include "command_line/plot_option.h"
#include "command_line/warnings.h"
#include "element/each.h"
#include "element/refuse.h"
#include "gap/odd_motion.h"
#include "log/new_file.h"
#include "log/text.h"

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

namespace {

struct Options {
  std::string config;
  std::string data_sheet;
  std::string component;
  bool without_rig = false;
  bool json = false;
  std::string plot;
  std::string csv;
  std::string state_space;
  std::vector<std::string> models;
  std::optional<double> sensitivity;    // [-]
  std::vector<double> frequency_range;  // [Hz]
  std::vector<double> amplitude_range;  // [m]
  command::SweepOptions sweeps;
  std::vector<std::string> logs;
  std::string table_path;
  std::string series;
  LogOptions log_options;
  fit::IdentificationOptions identification;
  std::string output;

  OptionTable table();
};

// Each way to estimate has its own options and refuses those of the others.
OptionTable Options::table() {
  OptionTable options = {
      Option("--config", config, "FILE", "component file").reads(),
      Option("--data-sheet", data_sheet, "FILE",
             "data sheet instead of --config; contains hardness and shape, a dynamic-to-static ratio, or loss angles "
             "at two frequencies; the resulting component file is printed")
          .reads(),
      Option("--component", component, "NAME", "name of the component; default: all components"),
      withoutRigOption(without_rig),
      Option("--json", json, "print JSON, in SI units").rare(),
      plotOption(plot, "stiffness and loss angle"),
      Option("--csv", csv, "FILE",
             "CSV to write: stiffness, loss angle, K', K'' and the equivalent K_e and C_e at each point of the sweeps")
          .rare()
          .writes(io::file_kind::characteristics_csv),
      Option("--state-space", state_space, "FILE",
             "FILE.json or FILE.mat to write: matrices A, B, C, D of the linear part, with the inputs z and dz/dt")
          .rare()
          .standsFor([this] {
            const io::FileKind kind =
                log::endsWith(state_space, ".mat") ? io::file_kind::mat : io::file_kind::state_space_json;
            return Files{{}, {{"--state-space", state_space, kind}}};
          }),
      Option("--models", models, "MODEL",
             "models to compare, all estimated from the same specification: M1 to M6, their names, or a number of "
             "Maxwell elements, such as M1 M2 5")
          .rare(),
      Option("--sensitivity",
             Quantity{&sensitivity, "1", {0.0, 0.5, true, false}, "a share up to 50 %, such as '5 %' or 0.05"}, "SHARE",
             "change each input by this share, such as '5 %', and show how stiffness and loss angle change")
          .rare(),
      Option("--frequencies", Quantity{&frequency_range, "Hz"}, "HZ", "lowest and highest frequency, such as 0.5 20")
          .rare()
          .values(2, 2),
      Option("--amplitudes", Quantity{&amplitude_range, "m"}, "METRES",
             "smallest and largest amplitude, such as '0.1 mm' '5 mm'")
          .rare()
          .values(2, 2),
      Option("--frequency", Quantity{&sweeps.frequency, "Hz"}, "HZ", "frequency of the sweep over amplitudes").rare(),
      Option("--amplitude", Quantity{&sweeps.amplitude, "m"}, "METRES",
             "amplitude of the sweep over frequencies, such as '2 mm'")
          .rare(),
      Option("--product", Quantity{&sweeps.product, "m Hz"}, "PRODUCT",
             "product of amplitude and frequency in the sweep with a constant product, such as '8 mm Hz'")
          .rare(),
      Option("--points", sweeps.points, "COUNT", "number of points in each sweep").rare().within(2, 10000),
      Option("--from-log", logs, "FILE",
             "measured log with a force, from which to identify the parameters; text, .mat, HDF5, RPC III or .bag; may "
             "be given several times")
          .readsEachOnce(),
      Option("--from-table", table_path, "FILE",
             "measured table of stiffness and loss angle, to identify the parameters")
          .reads(),
      Option("--series", series, "SERIES",
             "with --from-table: series of elements to fit in place of the component's own elements; the series covers "
             "the frequencies of the master curve, into which the rows of all temperatures are shifted")
          .rare()
          .oneOf({"prony", "springpot"}),
      Option("--hold", identification.held, "ELEMENT.PARAMETER",
             "with --from-log: parameter to keep fixed, such as friction.displacement")
          .rare(),
      Option("--starts", identification.starts, "COUNT", "with --from-log: number of starting points")
          .rare()
          .within(1, 1000),
      Option("--output", output, "FILE",
             "component file to write; contains the parameters found with --from-log, --from-table or --data-sheet")
          .writes(io::file_kind::component_file),
      log_options.acceptUnits(),
      log_options.table()};
  options.oneOf({"--config", "--data-sheet"});
  options.excludes({"--component", "--json", "--from-log", "--from-table"}, {"--data-sheet"});
  options.excludes({"--without-rig", "--csv", "--state-space", "--models", "--sensitivity"},
                   {"--data-sheet", "--from-log", "--from-table"});
  options.needs({"--hold", "--starts"}, {"--from-log"}).needs(LogOptions::names(), {"--from-log"});
  options.needs({"--accept-units"}, {"--from-log", "--from-table"});
  options.excludes({"--frequencies", "--amplitudes", "--frequency", "--amplitude", "--product", "--points"},
                   {"--data-sheet", "--from-log", "--from-table"});
  options.excludes({"--from-log", "--json", "--plot"}, {"--from-table"}).needs({"--series"}, {"--from-table"});
  return options.needs({"--output"}, {"--from-log", "--from-table", "--data-sheet"});
}

void readRange(const std::string& option, const std::vector<double>& ends, const std::string& unit,
               std::optional<double>& low, std::optional<double>& high) {
  if (!ends.empty()) {
    low = ends[0];
    high = ends[1];
    element::refuseIf<UsageError>(!(*low < *high), "{}: the first value, {:g} {}, is not below the second, {:g} {}",
                                  option, *low, unit, *high, unit);
  }
}

command::SweepOptions sweepOptions(const Options& options) {
  command::SweepOptions sweeps = options.sweeps;
  readRange("--frequencies", options.frequency_range, "Hz", sweeps.lowest_frequency, sweeps.highest_frequency);
  readRange("--amplitudes", options.amplitude_range, "m", sweeps.lowest_amplitude, sweeps.highest_amplitude);
  return sweeps;
}

command::EstimateReport reportOf(const io::ComponentDescription& component, const command::SweepOptions& sweeps,
                                 std::optional<double> sensitivity) {
  command::EstimateReport report = command::makeEstimateReport(component, sweeps);
  if (sensitivity) {
    command::addSensitivity(report, *sensitivity);
  }
  return report;
}

// Returns reports with enough points to draw smooth curves.
std::vector<command::EstimateReport> smoothReports(const std::vector<io::ComponentDescription>& components,
                                                   command::SweepOptions sweeps, std::optional<double> sensitivity) {
  constexpr int kSmooth = 61;
  sweeps.points = std::max(sweeps.points, kSmooth);
  return element::each(components, [&](const auto& component) { return reportOf(component, sweeps, sensitivity); });
}

int convertDataSheet(const Options& options) {
  const std::string text = command::componentFileFromDataSheet(options.data_sheet);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line) && line[0] == '#';) {
    printNote("estimate", line.substr(2));
  }
  drawPlot(options.plot, [&] {
    return command::toFigure(smoothReports(io::parseComponentFile(text, options.data_sheet), {}, std::nullopt));
  });
  if (options.output.empty()) {
    std::cout << text;
  } else {
    log::writeNewFile(options.output, text);
    std::cout << options.output << '\n';
  }
  return kSuccess;
}

int identifyComponent(const Options& options) {
  const auto components = io::loadComponentFile(options.config);
  const io::ComponentDescription& description = io::selectComponent(components, options.component, options.config);
  warnOf("estimate", description);
  std::vector<log::Log> logs;
  for (const std::string& path : options.logs) {
    for (log::Log& log : options.log_options.readAll(path, description.name)) {
      LogOptions::printNotes("estimate", path, log.notes);
      warnOf("estimate", path, gap::oddMotion(log, description));
      warnOfTemperature("estimate", path, !log.temperature.empty(), description);
      logs.push_back(std::move(log));
    }
  }
  const fit::Identification result = during(
      "finding parameters", [&] { return command::identifyFromLogs(description, logs, options.identification); });
  drawPlot(options.plot, [&] { return command::identificationFigure(description, result, logs); });
  if (!options.output.empty()) {
    log::writeNewFile(options.output, io::toYaml({command::identifiedComponent(description, result)}));
  }
  std::cout << (options.json ? command::toJson(description.name, result) : command::toText(description.name, result));
  return kSuccess;
}

int fitToTable(const Options& options) {
  const auto components = io::loadComponentFile(options.config);
  const io::ComponentDescription description = io::selectComponent(components, options.component);
  fit::MeasuredTable table = command::readTable(options.table_path);
  table.accept_units = options.log_options.acceptsUnits();
  command::requireNoShift(description, table, options.table_path);
  for (const std::string& note : command::checkBenchOfTable(description, table, options.table_path)) {
    printWarning("estimate", options.table_path + ": " + note);
  }
  std::optional<fit::Series> series;
  if (!options.series.empty()) {
    series = options.series == "prony" ? fit::Series::prony : fit::Series::springpot;
  }
  const fit::TableFit result =
      during("finding parameters", [&] { return fit::fitToTable(description, table.points, series); });
  if (!options.output.empty()) {
    log::writeNewFile(options.output, io::toYaml({result.component}));
  }
  std::cout << command::toText(result, table);
  return kSuccess;
}

// Warns of amplitudes that are probably not in metres, such as 5 m for "--amplitude 5".
void warnOfAmplitudes(const io::ComponentDescription& component, const command::SweepOptions& sweeps) {
  const gap::MotionScale scale = gap::motionScaleOf(component);
  for (const auto& [option, amplitude] :
       {std::pair("--amplitude", sweeps.amplitude), {"--amplitudes", sweeps.highest_amplitude}}) {
    if (const auto odd = amplitude ? gap::oddAmplitude(*amplitude, scale) : std::nullopt) {
      printWarning("estimate",
                   fmt::format("{}: {}: {}; a number without a unit is in metres", component.name, option, *odd));
    }
  }
}

void writeFiles(const Options& options, const std::vector<io::ComponentDescription>& components,
                const std::vector<command::EstimateReport>& reports) {
  if (!options.csv.empty()) {
    log::writeNewFile(options.csv, command::toCsv(reports));
  }
  if (!options.state_space.empty()) {
    std::vector<command::LinearPart> parts;
    for (const io::ComponentDescription& component : components) {
      parts.push_back(command::linearPartOf(component));
      const command::LinearPart& part = parts.back();
      for (const auto& [what, types] : {std::pair(": elements that are linearised with their slope: ", part.tangents),
                                        std::pair(": elements that the linear part omits: ", part.left_out)}) {
        if (!types.empty()) {
          printNote("estimate", part.component + what + log::join(types));
        }
      }
    }
    command::writeLinearParts(parts, options.state_space);
  }
}

// Checks the name of the state-space file before any file is written.
void checkStateSpace(const std::string& path, std::size_t components) {
  element::refuseIf<UsageError>(
      !path.empty() && !log::endsWith(path, ".json") && !(log::endsWith(path, ".mat") && components == 1),
      "--state-space: {} cannot hold {} component{}; accepted: FILE.json, or FILE.mat for a single component "
      "(--component NAME, and a single model of --models)",
      path, components, components == 1 ? "" : "s");
}

int estimateComponents(const Options& options) {
  const command::SweepOptions sweeps = sweepOptions(options);
  std::vector<io::ComponentDescription> components = io::loadComponentFile(options.config);
  if (!options.component.empty()) {
    components = {io::selectComponent(components, options.component, options.config)};
  }
  if (!options.models.empty()) {
    std::vector<std::string> notes;
    components =
        command::inModels(io::selectComponent(components, options.component, options.config), options.models, notes);
    printNotes("estimate", notes);
  }
  checkStateSpace(options.state_space, components.size());
  std::vector<command::EstimateReport> reports;
  for (io::ComponentDescription& component : components) {
    if (options.without_rig) {
      component = component.withoutRig();
    }
    warnOf("estimate", component);
    warnOfAmplitudes(component, sweeps);
    reports.push_back(reportOf(component, sweeps, options.sensitivity));
  }
  writeFiles(options, components, reports);
  drawPlot(options.plot, [&] {
    const auto legends = options.models.empty() ? command::Legends::in_all_axes : command::Legends::one;
    return command::toFigure(smoothReports(components, sweeps, options.sensitivity), legends);
  });
  if (options.json) {
    std::cout << command::toJson(reports);
    return kSuccess;
  }
  for (std::size_t i = 0; i < reports.size(); ++i) {
    std::cout << (i == 0 ? "" : "\n") << command::toText(reports[i]);
  }
  return kSuccess;
}

int run(const Options& options) {
  if (!options.logs.empty()) {
    options.log_options.requireUse(options.logs);
  }
  if (!options.data_sheet.empty()) {
    return convertDataSheet(options);
  }
  if (!options.table_path.empty()) {
    return fitToTable(options);
  }
  return options.logs.empty() ? estimateComponents(options) : identifyComponent(options);
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand<Options>(
      argc, argv,
      {"estimate",
       "Estimates the parameters of rubber components from their specifications, from measured logs or "
       "tables or from data sheets, and prints them with stiffness and loss angle over frequency and "
       "amplitude.",
       {{"Parameters from the specification", "--config component.yaml"},
        {"Parameters from a measured log", "--config component.yaml --from-log log.csv --output found.yaml"},
        {"A component file from a data sheet", "--data-sheet sheet.yaml --output bush.yaml"}}},
      run);
}
