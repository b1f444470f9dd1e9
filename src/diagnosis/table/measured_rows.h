// A table as a measurement for the search.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/hypotheses/measured.h"
#include "fit/table_fitter.h"
#include "rubber_suspension/fit/measured_table.h"

namespace rubber_suspension::diagnosis::table {

/// The noise of a row, RMS of |error of K*|/|K*|, and its source.
struct Scatter {
  double level = 0.0;
  std::string source;
};

/// Returns one level for all rows, from the first available source: the stated uncertainty; repeated rows; for a table
/// with temperatures, the residual of a master curve, shifted along both axes because the rows of one temperature share
/// its error; the residual of ln K* from a polynomial in the logarithms of frequency and amplitude; 1 %, as
/// laboratories reach. Residuals count at most 3 %, because a rougher table may show an unlisted effect. Estimates from
/// few rows may be too low by chance, so that the level is the upper end of a one-sided 84 % interval.
Scatter scatterOf(const std::vector<fit::TablePoint>& points, std::optional<double> stated);

/// Returns the effects that settled loops under single sines never show (Effect::in_settled_loops).
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
