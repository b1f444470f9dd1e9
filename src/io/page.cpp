// The pages of reports, which scripts/render_report draws.
#include "io/page.h"

#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "io/script.h"
#include "log/text.h"

namespace rubber_suspension::io {

void removePage(const std::string& path) {
  std::error_code failure;
  std::filesystem::remove(path, failure);
  if (failure) {
    throw std::runtime_error(path + ": cannot be removed: " + failure.message());
  }
}

std::string renderPage(const std::string& json_path) {
  try {
    const ScriptResult drawing = runScript("render_report", {json_path}, "");
    // After success, a line that does not begin with the name of the script is a warning of a library.
    return drawing.succeeded && !log::startsWith(drawing.last_error, "render_report: ") ? "" : drawing.last_error;
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

}  // namespace rubber_suspension::io
