// A table as a search takes it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "diagnosis/hypotheses/measured.h"
#include "diagnosis/table/scatter.h"
#include "fit/table_fitter.h"

namespace rubber_suspension::diagnosis::table {

/// Effects that the settled loops under single sines never show.
const std::vector<std::string>& neverShownByTables();

class MeasuredRows final : public hypotheses::Measured {
 public:
  MeasuredRows(const io::ComponentDescription& component, const std::vector<fit::TablePoint>& points, Scatter scatter);

  const fit::ModelParameters& model() const { return model_; }
  const fit::TableLoops& loops() const { return *loops_; }

  const fit::TableFitter& fitter() const override { return fitter_; }
  const std::vector<log::Record>& records() const override { return *loops_->records(); }
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
