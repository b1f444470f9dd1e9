// Prints the parameters of components, estimated from a specification or found from measured logs, and their stiffness
// and loss angle over frequency and amplitude; turns data sheets into component files.
#include "command/estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "apps/command.h"
#include "apps/log_options.h"
#include "apps/output_options.h"
#include "apps/plot_option.h"
#include "apps/warnings.h"
#include "command/data_sheet.h"
#include "command/identify.h"
#include "command/measured_table.h"
#include "log/new_file.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::apps {
namespace {

struct Options {
  std::string config;
  std::string data_sheet;
  std::string component;
  bool json = false;
  std::string plot;
  std::vector<std::string> frequency_range;
  std::vector<std::string> amplitude_range;
  std::string frequency;
  std::string amplitude;
  std::string product;
  int points = command::SweepOptions().points;
  std::vector<std::string> logs;
  std::string table;
  LogOptions log_options;
  fit::IdentificationOptions identification;
  std::string output;
  OutputOptions outputs;
};

double quantity(const std::string& option, const std::string& text, const std::string& unit) {
  try {
    const double value = log::parseQuantity(text, unit);
    if (!element::Range::positive().contains(value)) {
      const std::string written = log::unitOfQuantity(text);
      throw std::invalid_argument("'" + text + "' is out of range; accepted: greater than 0 " +
                                  (written.empty() ? unit : written));
    }
    return value;
  } catch (const std::invalid_argument& error) {
    throw UsageError(option + ": " + error.what());
  }
}

void readRange(const std::string& option, const std::vector<std::string>& texts, const std::string& unit,
               std::optional<double>& low, std::optional<double>& high) {
  if (!texts.empty()) {
    low = quantity(option, texts[0], unit);
    high = quantity(option, texts[1], unit);
    if (!(*low < *high)) {
      throw UsageError(option + ": the first, " + texts[0] + ", is not below the second, " + texts[1]);
    }
  }
}

void readQuantity(const std::string& option, const std::string& text, const std::string& unit,
                  std::optional<double>& value) {
  if (!text.empty()) {
    value = quantity(option, text, unit);
  }
}

command::SweepOptions sweepOptions(const Options& options) {
  command::SweepOptions sweeps;
  readRange("--frequencies", options.frequency_range, "Hz", sweeps.lowest_frequency, sweeps.highest_frequency);
  readRange("--amplitudes", options.amplitude_range, "m", sweeps.lowest_amplitude, sweeps.highest_amplitude);
  readQuantity("--frequency", options.frequency, "Hz", sweeps.frequency);
  readQuantity("--amplitude", options.amplitude, "m", sweeps.amplitude);
  readQuantity("--product", options.product, "m Hz", sweeps.product);
  sweeps.points = options.points;
  return sweeps;
}

const std::vector<std::string> kSweepOptions = {"--frequencies", "--amplitudes", "--frequency",
                                                "--amplitude",   "--product",    "--points"};
const std::vector<std::string> kLogOptions = {"--hold", "--starts", "--columns", "--unit", "--sampling-rate"};

// Each way to estimate takes some of the options; none is passed over.
void checkOptions(const CLI::App& app, const Options& options) {
  if (options.config.empty() == options.data_sheet.empty()) {
    throw UsageError("accepted: one of --config and --data-sheet (see --help)");
  }
  if (!options.data_sheet.empty()) {
    refuseUnused(app, {"--component", "--json", "--plot", "--from-log", "--from-table"}, "with --data-sheet");
    refuseUnused(app, kSweepOptions, "with --data-sheet");
  }
  if (options.logs.empty()) {
    refuseUnused(app, kLogOptions, "without --from-log");
  } else {
    refuseUnused(app, kSweepOptions, "with --from-log");
    options.log_options.requireUse(options.logs);
  }
  if (!options.table.empty()) {
    refuseUnused(app, {"--from-log", "--json", "--plot"}, "with --from-table");
    refuseUnused(app, kSweepOptions, "with --from-table");
  }
  if (options.logs.empty() && options.data_sheet.empty() && options.table.empty()) {
    refuseUnused(app, {"--output"}, "without --from-log, --from-table or --data-sheet");
  }
}

void checkFiles(const Options& options) {
  std::vector<io::InputFile> inputs = {
      {"--config", options.config}, {"--data-sheet", options.data_sheet}, {"--from-table", options.table}};
  addInputs(inputs, "--from-log", options.logs);
  options.outputs.check(inputs, {{"--output", options.output, io::FileKind::component_file},
                                 {"--plot", options.plot, io::FileKind::figure}});
}

int convertDataSheet(const Options& options) {
  const std::string text = command::componentFileFromDataSheet(options.data_sheet);
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
    logs.push_back(options.log_options.read("estimate", path, description.name));
    warnOf("estimate", path, gap::oddMotion(logs.back(), description));
    warnOfTemperature("estimate", path, !logs.back().temperature.empty(), description);
  }
  const fit::Identification result = command::identifyFromLogs(description, logs, options.identification);
  if (!options.plot.empty()) {
    io::drawFigure(command::identificationFigure(description, result, logs), options.plot);
  }
  if (!options.output.empty()) {
    log::writeNewFile(options.output, io::toYaml({command::identifiedComponent(description, result)}));
  }
  std::cout << (options.json ? command::toJson(description.name, result) : command::toText(description.name, result));
  return kSuccess;
}

// For a figure: as many points as a curve without kinks takes.
std::vector<command::EstimateReport> smoothReports(const std::vector<io::ComponentDescription>& components,
                                                   command::SweepOptions sweeps) {
  constexpr int kSmooth = 61;
  sweeps.points = std::max(sweeps.points, kSmooth);
  std::vector<command::EstimateReport> reports;
  reports.reserve(components.size());
  for (const io::ComponentDescription& component : components) {
    reports.push_back(command::makeEstimateReport(component, sweeps));
  }
  return reports;
}

int fitToTable(const Options& options) {
  const auto components = io::loadComponentFile(options.config);
  const io::ComponentDescription& description = io::selectComponent(components, options.component);
  const fit::MeasuredTable table = command::readTable(options.table);
  command::requireNoShift(description, table, options.table);
  const fit::TableFit result = fit::fitToTable(description, table.points);
  if (!options.output.empty()) {
    log::writeNewFile(options.output, io::toYaml({result.component}));
  }
  std::cout << command::toText(result, table);
  return kSuccess;
}

// "--amplitude 5" is 5 m.
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

int estimateComponents(const Options& options) {
  const command::SweepOptions sweeps = sweepOptions(options);
  std::vector<io::ComponentDescription> components = io::loadComponentFile(options.config);
  if (!options.component.empty()) {
    components = {io::selectComponent(components, options.component, options.config)};
  }
  std::vector<command::EstimateReport> reports;
  for (const io::ComponentDescription& component : components) {
    warnOf("estimate", component);
    warnOfAmplitudes(component, sweeps);
    reports.push_back(command::makeEstimateReport(component, sweeps));
  }
  if (!options.plot.empty()) {
    io::drawFigure(command::toFigure(smoothReports(components, sweeps)), options.plot);
  }
  if (options.json) {
    std::cout << command::toJson(reports);
    return kSuccess;
  }
  for (std::size_t i = 0; i < reports.size(); ++i) {
    std::cout << (i == 0 ? "" : "\n") << command::toText(reports[i]);
  }
  return kSuccess;
}

CommandBody define(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("--config", options->config, "component file")->type_name("FILE");
  app.add_option("--data-sheet", options->data_sheet,
                 "data sheet instead of --config: prints the component file that follows from it, from hardness "
                 "and shape, a dynamic-to-static ratio, or loss angles at two frequencies")
      ->type_name("FILE");
  app.add_option("--component", options->component, "name of one component; all if absent")->type_name("NAME");
  app.add_flag("--json", options->json, "print JSON, in SI units");
  addPlotOption(app, options->plot, "stiffness and loss angle");
  app.add_option("--frequencies", options->frequency_range, "ends of the range of frequencies, such as 0.5 20")
      ->expected(2)
      ->type_name("HZ");
  app.add_option("--amplitudes", options->amplitude_range, "ends of the range of amplitudes, such as '0.1 mm' '5 mm'")
      ->expected(2)
      ->type_name("METRES");
  app.add_option("--frequency", options->frequency, "frequency at which the amplitude varies")->type_name("HZ");
  app.add_option("--amplitude", options->amplitude, "amplitude at which the frequency varies, such as '2 mm'")
      ->type_name("METRES");
  app.add_option("--product", options->product, "constant product of amplitude and frequency, such as '8 mm Hz'")
      ->type_name("PRODUCT");
  app.add_option("--points", options->points, "points of each range")
      ->type_name("COUNT")
      ->check(CLI::Range(2, 10000))
      ->capture_default_str();
  app.add_option(
         "--from-log", options->logs,
         "measured log with force (text, .mat, HDF5 or .bag): find the parameters from it; may be given several times")
      ->type_name("FILE");
  app.add_option("--from-table", options->table,
                 "measured table of stiffness and loss angle over frequency and amplitude: find the parameters from it")
      ->type_name("FILE");
  app.add_option("--hold", options->identification.held,
                 "parameter to keep fixed with --from-log, such as friction.displacement")
      ->type_name("ELEMENT.PARAMETER");
  app.add_option("--starts", options->identification.starts, "starts of the search with --from-log")
      ->type_name("COUNT")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--output", options->output,
                 "component file to write, with the parameters found by --from-log, --from-table or from --data-sheet")
      ->type_name("FILE");
  options->log_options.addTo(app);
  options->outputs.addTo(app);
  return [&app, options] {
    checkOptions(app, *options);
    checkFiles(*options);
    if (!options->data_sheet.empty()) {
      return convertDataSheet(*options);
    }
    if (!options->table.empty()) {
      return fitToTable(*options);
    }
    return options->logs.empty() ? estimateComponents(*options) : identifyComponent(*options);
  };
}

}  // namespace
}  // namespace rubber_suspension::apps

int main(int argc, char** argv) {
  return rubber_suspension::apps::runCommand(
      argc, argv, "estimate",
      "Estimates the parameters of rubber components from their specifications, from measured logs or tables or from "
      "data sheets, and prints them with stiffness and loss angle over frequency and amplitude.",
      rubber_suspension::apps::define);
}
