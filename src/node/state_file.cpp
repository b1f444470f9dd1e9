// The file in which the node keeps the states of its components.
#include "node/state_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace rubber_suspension::node {
namespace {

using nlohmann::json;

constexpr const char* kSchema = "rubber_suspension/state/1";
constexpr std::streamoff kLargestFile = 256 * 1024 * 1024;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw StateFileError(fmt::format("{}: {}", path, reason));
}

// JSON keeps a finite double to the last bit: it is written with as many digits as that takes.
json toJson(const SavedState& state) {
  json elements = json::array();
  for (const element::ElementDescription& element : state.elements) {
    elements.push_back({{"type", element.type}, {"values", element.values}});
  }
  return {{"component", state.component},
          {"elements", elements},
          {"started", state.started},
          {"stamp_ns", state.stamp},
          {"displacement_m", state.displacement},
          {"memory", state.memory}};
}

SavedState fromJson(const json& entry) {
  SavedState state;
  state.component = entry.at("component").get<std::string>();
  for (const json& element : entry.at("elements")) {
    state.elements.push_back(
        {element.at("type").get<std::string>(), element.at("values").get<element::ParameterValues>()});
  }
  state.started = entry.at("started").get<bool>();
  state.stamp = entry.at("stamp_ns").get<std::int64_t>();
  state.displacement = entry.at("displacement_m").get<double>();
  state.memory = entry.at("memory").get<std::vector<double>>();
  return state;
}

// Write to a file descriptor in full and make it reach the disk.
bool writeAll(int file, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t written = write(file, text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) {
      return false;
    }
    done += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
  }
  return fsync(file) == 0;
}

std::string readAll(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) {
    fail(path, std::strerror(errno));
  }
  if (file.tellg() > kLargestFile) {
    fail(path, fmt::format("larger than {} bytes", kLargestFile));
  }
  file.seekg(0);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

void writeStateFile(const std::string& path, const std::vector<SavedState>& states) {
  json document = {{"schema", kSchema}, {"states", json::array()}};
  for (const SavedState& state : states) {
    document["states"].push_back(toJson(state));
  }
  const std::string next = path + ".next";
  const int file = open(next.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) {
    fail(next, std::strerror(errno));
  }
  const bool written = writeAll(file, document.dump(1) + "\n");
  const int error = errno;
  if (close(file) != 0 || !written) {
    unlink(next.c_str());
    fail(next, std::strerror(written ? errno : error));
  }
  if (std::rename(next.c_str(), path.c_str()) != 0) {
    fail(path, std::strerror(errno));
  }
}

std::vector<SavedState> readStateFile(const std::string& path) {
  const std::string text = readAll(path);
  try {
    const json document = json::parse(text);
    if (document.at("schema") != kSchema) {
      fail(path, fmt::format("schema {}; accepted: {}", document.at("schema").dump(), kSchema));
    }
    std::vector<SavedState> states;
    for (const json& entry : document.at("states")) {
      states.push_back(fromJson(entry));
    }
    return states;
  } catch (const json::exception& error) {
    fail(path, fmt::format("no state file: {}", error.what()));
  }
}

}  // namespace rubber_suspension::node
