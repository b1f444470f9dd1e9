// The options --limits and --json.
#include "command_line/agreement_options.h"

#include <fmt/format.h>

#include <map>

#include "command_line/command.h"
#include "element/refuse.h"
#include "log/new_file.h"

namespace rubber_suspension::command_line {

OptionTable AgreementOptions::table() {
  return {
      Option("--limits", limits_, "NAME=VALUE",
             "limits of the agreement, exit status 1 beyond them: gap=0.1 rms='50 N' peak='0.2 kN' energy='5 %' at "
             "most, iso18571=0.8 at least; rms and peak are of forces, not of moments")
          .rare(),
      Option("--json", json_, "FILE",
             "agreement to write as JSON: iso18571 (corridor, phase, magnitude, slope, total), gap, RMS, peak error, "
             "energy per cycle")
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
                                  "--limits: '{}'; accepted: NAME=VALUE, of gap, rms, peak, energy, iso18571", text);
    auto& target = *std::get<std::optional<double>*>(quantity->second.value);
    element::refuseIf<UsageError>(target.has_value(), "--limits: {} twice; accepted: once", quantity->first);
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
