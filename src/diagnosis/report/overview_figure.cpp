// The diagnosis on one page: the report's figures, each for one log.
#include "diagnosis/report/overview_figure.h"

#include "diagnosis/report/report_figures.h"

namespace rubber_suspension::diagnosis {

io::Figure overviewFigure(const Diagnosis& diagnosis) {
  io::Figure overview;
  overview.title = diagnosis.component + ": " + toString(diagnosis.verdict);
  for (std::size_t i = 0; i < diagnosis.effects.size(); ++i) {
    overview.title += (i == 0 ? ": " : ", ") + diagnosis.effects[i];
  }
  for (const ReportFigure& part : reportFigures(diagnosis)) {
    if (!part.figure.axes.empty()) {
      overview.axes.push_back(part.figure.axes.front());
      io::Axes& axes = overview.axes.back();
      axes.title = part.figure.title + (axes.title.empty() ? "" : "\n" + axes.title);
    }
  }
  return overview;
}

}  // namespace rubber_suspension::diagnosis
