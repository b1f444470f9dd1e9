// The jobs file, in which a user lists which commands run on which components and logs.
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
  double width = 0.0;  ///< share of the nominal value [-], or in the unit of the number [SI]
  bool is_share = true;
};

/// A tolerance study: jobs that differ in the drawn numbers of the specification.
struct MonteCarlo {
  std::size_t runs = 0;
  std::uint64_t seed = 0;
  std::map<std::string, Tolerance> tolerances;  ///< by the name of the number
  bool leave_out_unsolvable = false;  ///< omit draws whose specification has no solution instead of refusing them
};

/// One entry of `jobs:`. Patterns are those of the shell (*, ?, [...]), relative to each folder.
struct JobGroup {
  std::string name;
  int line = 0;  ///< line of the jobs file, for errors
  Command command = Command::diagnose;
  std::string folders;  ///< pattern relative to the jobs file; empty: the folder of the jobs file
  std::string config;
  std::vector<std::string> components;  ///< empty: the only one of each file
  std::string type;                     ///< empty: the name of the component
  std::string test_rig;                 ///< empty: one rig for all entries without a name
  std::vector<std::string> logs;
  std::vector<std::string> hold_out;
  bool one_job_per_log = false;
  std::optional<MonteCarlo> monte_carlo;
  JobOptions options;
};

constexpr std::size_t kMaximumJobs = 1000000;  ///< largest number of jobs of a campaign

/// Reads and checks a jobs file. Appends one line per error to `problems`: file:line, key, value, what is accepted. The
/// groups must not be used if there are errors.
std::vector<JobGroup> readJobsFile(const std::string& path, std::vector<std::string>& problems);

/// Reads the groups from text; `path` stands for the file's name.
std::vector<JobGroup> parseJobsFile(const std::string& text, const std::string& path,
                                    std::vector<std::string>& problems);

/// Returns the drawn numbers of each run, by name [SI]. The same seed gives the same draws on every machine, and a
/// longer study begins with the draws of a shorter one. Each number uses 53 bits of a Mersenne Twister, in the order of
/// the names. Throws std::invalid_argument for a tolerance of a number that is not specified.
std::vector<std::map<std::string, double>> drawSpecifications(const estimation::Specification& nominal,
                                                              const MonteCarlo& study);

}  // namespace rubber_suspension::campaign
