// What a diagnosis works with: the prepared logs, the models to be fitted, the search and the judgement.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "diagnosis/hypotheses/odds.h"
#include "diagnosis/hypotheses/search.h"
#include "diagnosis/judge/answer.h"
#include "fit/fitter.h"
#include "fit/model_parameters.h"
#include "gap/simulate.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// A component and its logs, ready for the fits.
struct PreparedCase {
  PreparedCase(const io::ComponentDescription& configured, std::vector<gap::PreparedRecord> logs,
               std::vector<gap::PreparedRecord> hold_out)
      : component(configured),
        records(std::make_shared<const std::vector<gap::PreparedRecord>>(std::move(logs))),
        training(*records),
        held_out(std::move(hold_out)),
        model(component, fit::Level::specification),
        fitter(records, model, errorScale().oneOfSheet()) {}
  PreparedCase(const PreparedCase&) = delete;  // the fitters refer to the models
  PreparedCase& operator=(const PreparedCase&) = delete;

  io::ComponentDescription component;
  std::shared_ptr<const std::vector<gap::PreparedRecord>> records;  ///< logs of the fit
  const std::vector<gap::PreparedRecord>& training;                 ///< refers to *records
  std::vector<gap::PreparedRecord> held_out;
  fit::ModelParameters model;
  fit::Fitter fitter;
};

}  // namespace rubber_suspension::diagnosis::hypotheses

namespace rubber_suspension::diagnosis {

/// The logs, and the forces of three components on them [N].
struct Simulated {
  std::vector<gap::PreparedRecord> records;  ///< the logs of the fit, followed by the held-out logs
  std::size_t training = 0;                  ///< number of records that took part in the fit
  gap::Forces configured;                    ///< forces on each record; likewise in the next two members
  gap::Forces re_estimated;
  gap::Forces augmented;
};

/// Data for figures and lists of the report in addition to the result. A public header declares this type.
struct Workings {
  hypotheses::Search search;
  judge::Evidence evidence;
  judge::ScoreTable table;  ///< derived from `evidence`
  judge::Answer answer;
  bool write_evidence = false;  ///< the report includes the evidence
  Simulated simulated;          ///< empty for a table

  Workings() = default;
  Workings(hypotheses::Search found, judge::Evidence of_search, bool write)
      : search(std::move(found)), evidence(std::move(of_search)), write_evidence(write) {
    judgeAgain();
  }

  void judgeAgain() {
    table = judge::scoreTable(evidence);
    answer = judge::answer(table);
  }

  /// Returns true if the values of a hypothesis lie nearer to the data sheet than those re-estimated without effects.
  bool isNearerToTheSheet(int hypothesis) const {
    return evidence.at(hypothesis).chi_squared < evidence.at(judge::Evidence::kReEstimated).chi_squared;
  }
};

}  // namespace rubber_suspension::diagnosis
