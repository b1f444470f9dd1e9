// The manifest: every job of a campaign with the files that it reads, and the folder that it lies in.
#pragma once

#include <string>
#include <vector>

#include "campaign/job.h"

namespace rubber_suspension::campaign {

struct Manifest {
  std::string version;  ///< of the program that made it
  std::vector<InputFile> inputs;
  std::vector<Job> jobs;

  /// Places of the jobs of different ids, each once, in the order of the manifest: jobs of the same inputs and options
  /// are worked off once and share their result.
  std::vector<std::size_t> distinctJobs() const;
};

/// Where things lie in the folder of a campaign.
std::string manifestPath(const std::string& folder);
std::string recordPath(const std::string& folder, const std::string& id);

/// The folder of a job's reports, relative to that of the campaign.
std::string reportFolder(const std::string& id);

/// JSON lines: a header with the numbers of lines, the inputs, the jobs. Throws std::runtime_error.
void writeManifest(const Manifest& manifest, const std::string& folder);

/// Throws std::runtime_error that names the file, the line and what is accepted.
Manifest readManifest(const std::string& folder);

}  // namespace rubber_suspension::campaign
