// A campaign folder that tests fill with small inputs.
#pragma once

#include "campaign/make.h"
#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension {

class CampaignFolder : public ScratchFolder {
 public:
  /// Writes a file with the component `bush` and returns its path.
  std::string writeComponent(const std::string& name, double static_stiffness = 1e6) const {
    return write(name, fmt::format("components:\n  bush:\n    model: maxwell\n    specification:\n"
                                   "      static_stiffness: {}\n      dynamic_stiffness: {}\n"
                                   "      nominal_frequency: 4.0\n      break_frequency: 3.0\n",
                                   static_stiffness, 1.3 * static_stiffness));
  }

  /// Writes a log with 1 s of a sine. `variant` changes its content.
  std::string writeLog(const std::string& name, int variant = 0, bool with_force = true) const {
    std::string text = with_force ? "time_s,displacement_m,force_N\n" : "time_s,displacement_m\n";
    for (int i = 0; i < 200; ++i) {
      const double displacement = 1e-3 * std::sin(0.1 * i + variant);
      text += with_force ? fmt::format("{:.3f},{:.9g},{:.9g}\n", 0.005 * i, displacement, 1.1e6 * displacement)
                         : fmt::format("{:.3f},{:.9g}\n", 0.005 * i, displacement);
    }
    return write(name, text);
  }
};

inline log::Log readTestLog(const std::string& path, const std::string& /*component*/, const log::LogFormat& format) {
  return log::readLog(path, format);
}

}  // namespace rubber_suspension
