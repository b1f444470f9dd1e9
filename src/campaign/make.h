// From a jobs file to a manifest: patterns and tolerances expand to jobs, and every input is checked before any runs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "campaign/manifest.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::campaign {

/// Reads a log of any kind; of one with several components, that of the name given. Several threads may call it.
using LogReader =
    std::function<log::Log(const std::string& path, const std::string& component, const log::LogFormat& format)>;

struct Expansion {
  Manifest manifest;
  std::vector<std::string> notes;     ///< omitted or repeated inputs
  std::vector<std::string> problems;  ///< what is wrong with the inputs, a line each, none twice; then there is no job
};

/// Expands a jobs file. `output`, the campaign's own folder, is none of those that a pattern names. Component files are
/// loaded, logs read and hashed, draws estimated.
Expansion makeManifest(const std::string& jobs_file, const std::string& output, const std::string& version, int threads,
                       const LogReader& read_log);

/// Returns the format of the logs of a job.
log::LogFormat logFormat(const JobOptions& options);

}  // namespace rubber_suspension::campaign
