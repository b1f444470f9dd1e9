// The readers of all formats; log::readLog() and log::openLog() choose one of them.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::log {

/// Reads the log of a text file, or each of its segments, as readCsvLog() describes. A segment begins at a header that
/// repeats or differs from the first one, after a blank line, or where the time restarts. Throws LogError.
std::vector<Log> readCsvLogs(const std::string& path, const LogFormat& format);

/// Reads the logs of a MATLAB file of level 4 to 7.3. The columns are vectors of real numbers: variables, named NAME,
/// and fields of structs, named STRUCT.NAME. STRUCT may be omitted if the file contains a single struct and nothing
/// else. A matrix contributes its columns, or its rows if it is wider than long. They are named NAME(:,1), or 1 if the
/// file contains nothing else. If several structs contain a log, each is a segment. Throws LogError.
std::vector<Log> readMatLogs(const std::string& path, const LogFormat& format);

/// Reads the logs of an HDF5 file. The columns are one-dimensional datasets of numbers, members of compound datasets,
/// and the columns of matrices (NAME[:,1]). They are named by their path without the first slash, or without the group
/// if all lie in the same group. The attribute unit, units, Unit or Units states the unit. If several groups contain a
/// log, each is a segment. Throws LogError.
std::vector<Log> readHdf5Logs(const std::string& path, const LogFormat& format);

/// Reads the log of an RPC III file. Its channels have the names of DESC and the units of UNITS, and their time step is
/// DELTA_T. Integers are multiplied by SCALE. Throws LogError.
std::vector<Log> readRpcLogs(const std::string& path, const LogFormat& format);

/// These functions read one log of any length in blocks of kLogBlock samples and return the notes. They throw LogError
/// and whatever `take` throws. While HDF5 is read, other threads that read HDF5 wait, and `take` must not read HDF5.
std::vector<std::string> readCsvBlocks(const std::string& path, const LogFormat& format, const LogSource::Take& take);
std::vector<std::string> readHdf5Blocks(const std::string& path, const LogFormat& format, const LogSource::Take& take);
std::vector<std::string> readRpcBlocks(const std::string& path, const LogFormat& format, const LogSource::Take& take);

/// Returns the only log in `logs`. Throws LogError if there are several.
Log onlyLog(const std::string& path, std::vector<Log>&& logs);

/// Returns the index of the segment that a format selects; nullopt if it requests all segments. `segments` are
/// descriptions. Throws std::runtime_error, which lists them, if the format selects none of several or one that does
/// not exist.
std::optional<std::size_t> chosenSegment(const LogFormat& format, const std::vector<std::string>& segments);

/// Returns the name of a segment's log, which consists of the name of the file and `number`, counted from 1.
std::string segmentName(const std::string& file, std::size_t number);

}  // namespace rubber_suspension::log
