// Makes a manifest from a jobs file: expands patterns and tolerances to jobs, and checks every input.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "campaign/manifest.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::campaign {

/// Reads a log of any format. If a log has several components, reads the given one. Several threads may call it.
using LogReader =
    std::function<log::Log(const std::string& path, const std::string& component, const log::LogFormat& format)>;

struct Expansion {
  Manifest manifest;
  std::vector<std::string> notes;     ///< about omitted or repeated inputs
  std::vector<std::string> problems;  ///< distinct errors of the inputs; if there are any, the manifest is empty
};

/// Expands a jobs file: loads component files, reads and hashes logs, and estimates drawn specifications. Patterns do
/// not match files in `output`, the folder of the campaign.
Expansion makeManifest(const std::string& jobs_file, const std::string& output, const std::string& version, int threads,
                       const LogReader& read_log);

log::LogFormat logFormat(const JobOptions& options);

}  // namespace rubber_suspension::campaign
