// The report for engineers: report.html.
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension {

std::string toHtml(const Diagnosis& diagnosis) { return "<p>" + diagnosis.sentence + "</p>\n"; }

}  // namespace rubber_suspension
