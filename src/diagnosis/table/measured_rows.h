// A table as a search takes it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/hypotheses/measured.h"
#include "fit/table_fitter.h"
#include "rubber_suspension/fit/measured_table.h"

namespace rubber_suspension::diagnosis::table {

/// The noise of a row, RMS of |error of K*|/|K*|, and how it is known.
struct Scatter {
  double level = 0.0;
  std::string source;
};

/// One floor, by the first of these that there is: what the laboratory states; repeated rows; of a table with
/// temperatures what one curve leaves of it, each temperature shifted along both axes, since the rows of one
/// temperature share its error; what a polynomial in the logarithms of frequency and amplitude leaves of ln K*; 3 % at
/// most, since what is rough may be what no law
/// has; 1 %, as laboratories reach. What is estimated from few rows may be too low by chance: the level is the upper
/// end of its one-sided interval of 84 %, a standard error of the normal distribution.
Scatter scatterOf(const std::vector<fit::TablePoint>& points, std::optional<double> stated);

/// Effects that the settled loops under single sines never show (Effect::in_settled_loops).
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
