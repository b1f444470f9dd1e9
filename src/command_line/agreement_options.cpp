// The options --limits and --json.
#include "command_line/agreement_options.h"

#include <fmt/format.h>

#include <map>

#include "command_line/command.h"
#include "element/refuse.h"
#include "log/new_file.h"

namespace rubber_suspension::command_line {

OptionTable AgreementOptions::table() {
  return {Option("--limits", limits_, "NAME=VALUE",
                 "limits of the agreement: at most gap=0.1 rms='50 N' peak='0.2 kN' energy='5 %', at least "
                 "iso18571=0.8; beyond a limit the exit status is 1; rms and peak apply to forces, not to moments")
              .rare(),
          Option("--json", json_, "FILE",
                 "JSON file to write with the agreement: iso18571 (corridor, phase, magnitude, slope, total), gap, RMS "
                 "error, peak error, energy per cycle")
              .writes(io::file_kind::agreement_json)
              .rare()};
}

gap::AgreementLimits AgreementOptions::limits() const {
  gap::AgreementLimits limits;
  const std::map<std::string, Quantity> quantities = {
      {"gap", {&limits.gap, "1", element::Range::nonNegative()}},
      {"rms", {&limits.rms, "N", element::Range::nonNegative()}},
      {"peak", {&limits.peak, "N", element::Range::nonNegative()}},
      {"energy", {&limits.energy, "1", element::Range::nonNegative()}},
      {"iso18571", {&limits.iso18571, "1", element::Range::closed(0.0, 1.0)}}};
  for (const std::string& text : limits_) {
    const std::size_t sign = text.find('=');
    const auto quantity = quantities.find(text.substr(0, sign));
    element::refuseIf<UsageError>(sign == std::string::npos || quantity == quantities.end(),
                                  "--limits: '{}'; accepted: NAME=VALUE with gap, rms, peak, energy or iso18571", text);
    auto& target = *std::get<std::optional<double>*>(quantity->second.value);
    element::refuseIf<UsageError>(target.has_value(), "--limits: {} is given twice; accepted: once", quantity->first);
    target = quantityOf("--limits " + quantity->first, text.substr(sign + 1), quantity->second);
  }
  return limits;
}

void AgreementOptions::write(const std::string& component, const std::string& log,
                             const std::vector<gap::ComparedForce>& compared) const {
  if (!json_.empty() && !compared.empty()) {
    log::writeNewFile(json_, gap::agreementJson(component, log, compared));
  }
}

}  // namespace rubber_suspension::command_line
