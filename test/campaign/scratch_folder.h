// A folder for a campaign, and small inputs in it; it goes with the object.
#pragma once

#include <fmt/format.h>
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "campaign/make.h"

namespace rubber_suspension {

class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "rubber_suspension_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw std::runtime_error("no temporary folder can be made");
    }
    path_ = pattern;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  std::string path(const std::string& name) const { return path_ + "/" + name; }

  std::string write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  std::string read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  bool holds(const std::string& name) const { return std::filesystem::exists(path(name)); }

  /// The component `bush`, and `spring` where wanted.
  std::string writeComponent(const std::string& name, double static_stiffness = 1e6) const {
    return write(name, fmt::format("components:\n  bush:\n    model: maxwell\n    specification:\n"
                                   "      static_stiffness: {}\n      dynamic_stiffness: {}\n"
                                   "      nominal_frequency: 4.0\n      break_frequency: 3.0\n",
                                   static_stiffness, 1.3 * static_stiffness));
  }

  /// A log of 1 s of a sine; `variant` makes it another one.
  std::string writeLog(const std::string& name, int variant = 0, bool with_force = true) const {
    std::string text = with_force ? "time_s,displacement_m,force_N\n" : "time_s,displacement_m\n";
    for (int i = 0; i < 200; ++i) {
      const double displacement = 1e-3 * std::sin(0.1 * i + variant);
      text += with_force ? fmt::format("{:.3f},{:.9g},{:.9g}\n", 0.005 * i, displacement, 1.1e6 * displacement)
                         : fmt::format("{:.3f},{:.9g}\n", 0.005 * i, displacement);
    }
    return write(name, text);
  }

 private:
  std::string path_;
};

inline log::Log readTestLog(const std::string& path, const std::string& /*component*/, const log::LogFormat& format) {
  return log::readLog(path, format);
}

}  // namespace rubber_suspension
