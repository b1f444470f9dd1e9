// The pages of reports, drawn by scripts/render_report from the files of the report.
#pragma once

#include <string>

namespace rubber_suspension::io {

/// Remove the page of an earlier report, which would be taken for part of the one that is about to be written. Nothing
/// where there is none. Throws std::runtime_error where it cannot be removed.
void removePage(const std::string& path);

/// Draw the page beside a report's JSON file: report.html beside report.json, with the pages of its directions,
/// plan.html or fleet.html. Returns in one line what the script has to say, as where Jinja2 is missing and there is no
/// page; empty where there is nothing to say.
std::string renderPage(const std::string& json_path);

}  // namespace rubber_suspension::io
