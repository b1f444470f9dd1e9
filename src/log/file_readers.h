// The readers of each format; log::readLog() and log::openLog() choose among them.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::log {

/// Reads the logs of a text file, as readCsvLog() describes: one, or each segment. A segment begins with a header that
/// repeats or differs, behind a blank line, or where the time restarts. Throws LogError.
std::vector<Log> readCsvLogs(const std::string& path, const LogFormat& format);

/// Reads the logs of a MATLAB file (level 4 to 7.3). Its columns are real vectors of numbers: variables, named as NAME,
/// and fields of structs, named as STRUCT.NAME; if the file contains one struct and nothing else, its name may be
/// omitted. A matrix has a column for each of its columns (rows if it is wider than long), named NAME(:,1), or 1 if the
/// file contains nothing else. Structs that each contain a log are segments. Throws LogError.
std::vector<Log> readMatLogs(const std::string& path, const LogFormat& format);

/// Reads the logs of an HDF5 file. Its columns are one-dimensional datasets of numbers and members of compound ones,
/// named by their path without the first slash, or by their own name if all lie in one group; those of a matrix are
/// named NAME[:,1] and so on. An attribute `unit`, `units`, `Unit` or `Units` states the unit. Groups that each contain
/// a log are segments. Throws LogError.
std::vector<Log> readHdf5Logs(const std::string& path, const LogFormat& format);

/// Reads the log of a file of RPC III: its channels, named by DESC with the unit of UNITS, at steps of DELTA_T.
/// Integers are multiplied by SCALE. Throws LogError.
std::vector<Log> readRpcLogs(const std::string& path, const LogFormat& format);

/// Reads one log of any length in blocks of kLogBlock; returns the notes. Throws LogError, and what `take` throws. For
/// HDF5, other threads wait to read such files meanwhile, and `take` must not read any.
std::vector<std::string> readCsvBlocks(const std::string& path, const LogFormat& format, const LogSource::Take& take);
std::vector<std::string> readHdf5Blocks(const std::string& path, const LogFormat& format, const LogSource::Take& take);
std::vector<std::string> readRpcBlocks(const std::string& path, const LogFormat& format, const LogSource::Take& take);

/// Returns the only log. Throws LogError if there are several.
Log onlyLog(const std::string& path, std::vector<Log>&& logs);

/// Returns the segment that a format selects, from 0; nullopt if it requests all. `segments`: their descriptions.
/// Throws std::runtime_error with these if it selects none of several, or one that does not exist.
std::optional<std::size_t> chosenSegment(const LogFormat& format, const std::vector<std::string>& segments);

/// Returns the name of a segment's log: that of the file and the number, from 1.
std::string segmentName(const std::string& file, std::size_t number);

}  // namespace rubber_suspension::log
