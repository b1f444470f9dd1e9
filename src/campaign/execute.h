// Works off one job in this process, by the same calls as the command that it stands for.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "campaign/make.h"
#include "campaign/manifest.h"
#include "campaign/record.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::campaign {

/// Keeps the logs and component files that it read last, because many jobs share them.
class Executor {
 public:
  /// The manifest has to live as long.
  Executor(std::string folder, const Manifest& manifest, LogReader read_log)
      : folder_(std::move(folder)), manifest_(manifest), read_log_(std::move(read_log)) {}

  /// Works the job off and writes its report and its record; what fails is the record's error. Throws
  /// std::runtime_error where no record can be written.
  Record execute(const Job& job);

 private:
  void work(const Job& job, Record& record);
  void diagnose(const Job& job, Record& record);
  void estimate(const Job& job, Record& record);
  void replay(const Job& job, Record& record);

  io::ComponentDescription componentOf(const Job& job);
  std::vector<log::Log> logs(const Job& job, const std::vector<std::size_t>& files);
  const log::Log& keptLog(const Job& job, std::size_t file);
  std::string unchangedPath(std::size_t input) const;
  std::string makeReportFolder(const Job& job) const;

  std::string folder_;
  const Manifest& manifest_;
  LogReader read_log_;
  std::map<std::string, log::Log> kept_logs_;
  std::size_t kept_samples_ = 0;
  std::map<std::size_t, std::vector<io::ComponentDescription>> kept_configs_;
};

}  // namespace rubber_suspension::campaign
