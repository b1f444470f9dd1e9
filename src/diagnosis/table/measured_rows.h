// A measured table as the data that the search fits.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/hypotheses/measured.h"
#include "fit/table_fitter.h"
#include "rubber_suspension/fit/measured_table.h"

namespace rubber_suspension::diagnosis::table {

/// The noise of each row of a table, as the RMS of |error of K*|/|K*|, and the source of this number.
struct Scatter {
  double level = 0.0;
  std::string source;
};

/// Returns one noise level for all rows, from the first source that is available: the stated uncertainty, repeated
/// rows, the residual of a master curve (for tables with temperatures), the residual of a polynomial in the logarithms
/// of frequency and amplitude that is fitted to ln K*, or an assumed level of 1 %. The master curve is shifted along
/// both axes, because the rows of one temperature have a common error. A level from a residual is at most 3 %, because
/// the residual of a rougher table may be due to an unlisted effect. Estimates from few rows may be too low by chance,
/// so the level is the upper end of a one-sided 84 % interval.
Scatter scatterOf(const std::vector<fit::TablePoint>& points, std::optional<double> stated);

/// Returns the effects that the settled loops of a table never show (Effect::in_settled_loops).
std::vector<std::string> neverShownByTables();

class MeasuredRows final : public hypotheses::Measured {
 public:
  MeasuredRows(const io::ComponentDescription& component, const std::vector<fit::TablePoint>& points, Scatter scatter);

  const fit::ModelParameters& model() const { return model_; }
  const fit::TableLoops& loops() const { return *loops_; }

  const fit::TableFitter& fitter() const override { return fitter_; }
  const std::vector<gap::PreparedRecord>& records() const override { return *loops_->records(); }
  fit::Excitation excitation() const override;
  std::vector<fit::Candidate> candidates(const fit::Excitation& excitation,
                                         const hypotheses::FittedHypothesis& re_estimated, int threads) const override;
  double discretisationError(const hypotheses::FittedHypothesis& model) const override;
  hypotheses::Noise estimateNoise(const hypotheses::FittedHypothesis& best,
                                  const hypotheses::Search& search) const override;

 private:
  Scatter scatter_;
  std::shared_ptr<const fit::TableLoops> loops_;
  fit::ModelParameters model_;
  fit::TableFitter fitter_;
};

}  // namespace rubber_suspension::diagnosis::table
