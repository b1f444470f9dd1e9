// Reads the jobs file, in which a user states which commands run on which components and logs.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "campaign/manifest.h"
#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::campaign {

/// Scatter of a number of a specification.
struct Tolerance {
  enum class Shape {
    uniform,  ///< from the nominal value minus `width` to the nominal value plus `width`
    normal,   ///< with the standard deviation `width` about the nominal value
  };
  Shape shape = Shape::uniform;
  double width = 0.0;  ///< a share of the nominal value [-] if `is_share`, otherwise in the SI unit of the number
  bool is_share = true;
};

/// A tolerance study. Its jobs differ in the numbers that are drawn for the specification.
struct MonteCarlo {
  std::size_t runs = 0;
  std::uint64_t seed = 0;
  std::map<std::string, Tolerance> tolerances;  ///< tolerances by the name of the number
  bool leave_out_unsolvable = false;  ///< omits draws whose specification has no solution instead of refusing them
};

/// One entry of `jobs:`. Patterns are those of the shell (*, ?, [...]), relative to each folder.
struct JobGroup {
  std::string name;
  int line = 0;  ///< line in the jobs file, for error messages
  Command command = Command::diagnose;
  std::string folders;  ///< pattern relative to the jobs file; if empty, the folder of the jobs file
  std::string config;
  std::vector<std::string> components;  ///< names of components; if empty, the only component of each file
  std::string type;                     ///< if empty, the name of the component
  std::string test_rig;                 ///< if empty, one rig for all entries without a name
  std::vector<std::string> logs;
  std::vector<std::string> hold_out;
  bool one_job_per_log = false;
  std::optional<MonteCarlo> monte_carlo;
  JobOptions options;
};

constexpr std::size_t kMaximumJobs = 1000000;  ///< largest number of jobs of a campaign

/// Reads and checks a jobs file. Appends one line per error to `problems` with file:line, key, value and what is
/// accepted. If there are errors, the groups must not be used.
std::vector<JobGroup> readJobsFile(const std::string& path, std::vector<std::string>& problems);

/// Reads the groups from text. `path` is the name of the file in error messages.
std::vector<JobGroup> parseJobsFile(const std::string& text, const std::string& path,
                                    std::vector<std::string>& problems);

/// Returns the drawn numbers of each run by name [SI]. The same seed gives the same draws on every computer, and a
/// longer study begins with the draws of a shorter one. Each number uses 53 bits of a Mersenne Twister, in the order of
/// the names. Throws std::invalid_argument for a tolerance of a number that is not specified.
std::vector<std::map<std::string, double>> drawSpecifications(const estimation::Specification& nominal,
                                                              const MonteCarlo& study);

}  // namespace rubber_suspension::campaign
