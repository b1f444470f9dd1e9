// The pages of reports, which scripts/render_report draws from the files of the report.
#pragma once

#include <string>

namespace rubber_suspension::io {

/// Removes the page of an earlier report, if there is one, because a reader would mistake it for part of the new
/// report. Throws std::runtime_error if it cannot be removed.
void removePage(const std::string& path);

/// Draws the page that belongs to a JSON file into the same folder: report.html, with the pages of its directions,
/// plan.html or fleet.html. Returns the last line of the script's errors, for example that Jinja2 is missing and no
/// page was drawn, or an empty text after success.
std::string renderPage(const std::string& json_path);

}  // namespace rubber_suspension::io
