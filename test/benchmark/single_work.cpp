// One piece of work of the library alone.
#include <fmt/format.h>

#include "benchmark/cases.h"
#include "rubber_suspension/fit/identification.h"
#include "rubber_suspension/gap/replay.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::benchmark {
namespace {

double medianSeconds(const std::function<void()>& work) {
  constexpr int kRuns = 5;
  std::vector<double> seconds;
  for (int i = 0; i < kRuns; ++i) {
    seconds.push_back(secondsOf(work, Clock::thread));
  }
  return spreadOf(seconds).median;
}

}  // namespace

std::string singleWork(const std::string& work, const std::string& component_file, const std::string& log_file) {
  const io::ComponentDescription description = io::selectComponent(io::loadComponentFile(component_file), "");
  const std::vector<log::Log> logs = {log::readLog(log_file)};
  if (work == "simulate") {
    const component::Component component = description.makeComponent();
    return fmt::format("{{\"seconds\": {:.9g}}}", medianSeconds([&] { gap::simulateLog(component, logs.front()); }));
  }
  fit::IdentificationOptions options;
  options.starts = 1;
  fit::Identification fit;
  const double seconds = medianSeconds([&] { fit = fit::identify(description.allElements(), logs, options); });
  const double cost = fit.residual * fit.residual * static_cast<double>(logs.front().size());
  return fmt::format("{{\"seconds\": {:.9g}, \"cost\": {:.12g}}}", seconds, cost);
}

}  // namespace rubber_suspension::benchmark
