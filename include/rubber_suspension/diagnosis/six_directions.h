// The diagnosis of a component of six directions. Each selected direction is diagnosed by itself, and a map shows which
// displacement predicts the residual of which force.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/component/six_directions.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/pose_log.h"

namespace rubber_suspension::diagnosis {

/// A cell of the cross map: how well the displacement in the direction `by` predicts the residual of the augmented
/// component in the generalised force of the direction `of`. The prediction is a cubic polynomial of both displacements
/// plus the product of the rate of `of` and the displacement of `by`. The share is what it predicts beyond cubic
/// polynomials of the displacement and the rate of `of`, on parts of the logs that took no part in the fits.
struct CrossShare {
  component::Direction of = component::kX;
  component::Direction by = component::kY;
  /// fraction of the squared residual [-]; NaN if `by` does not move, or if its motion follows from that of `of`
  double share = 0.0;
  double force = 0.0;  ///< RMS of the predicted force [N] or moment [N m]; NaN if `share` is NaN
};

struct DirectionDiagnosis {
  component::Direction direction = component::kX;
  Diagnosis diagnosis;  ///< for a rotation, [m] and [N] stand for [rad] and [N m]
};

struct SixDirectionsDiagnosis {
  std::string component;
  std::vector<DirectionDiagnosis> directions;
  std::vector<CrossShare> cross_map;  ///< each pair of a diagnosed direction and another direction
  /// directions that were not diagnosed are as configured, except for radial_stiffness
  io::ComponentDescription augmented;
  RunRecord run;
};

/// Throws std::invalid_argument if the component has one direction only or no direction is given. Also throws it, with
/// the name of the direction, if a direction is free or is coupled with others by a common radius, because the force of
/// coupled directions belongs to none of them alone.
void requireDirections(const io::ComponentDescription& component, const std::vector<component::Direction>& directions);

/// Diagnoses the given directions of a component of six directions. Each of them is diagnosed by diagnose(), with its
/// generalised force divided by its factor of stiffness_by_preload. Throws like diagnose() and requireDirections(), and
/// throws LogError for a log without wrenches.
SixDirectionsDiagnosis diagnoseDirections(const io::ComponentDescription& component,
                                          const std::vector<component::Direction>& directions,
                                          const std::vector<log::PoseLog>& logs,
                                          const std::vector<log::PoseLog>& hold_out,
                                          const DiagnosisOptions& options = {});

/// Returns a sentence that names the coupled pairs of directions in the cross map.
std::string crossMapSentence(const SixDirectionsDiagnosis& diagnosis);

/// Returns the cross map as a table for a terminal.
std::string crossMapText(const SixDirectionsDiagnosis& diagnosis);

/// Returns the diagnosis as JSON text, schema rubber_suspension/gap_report/six_directions/1.
std::string toJson(const SixDirectionsDiagnosis& diagnosis);

/// Returns the names of the files that writeReports() writes beside the folders of the directions.
std::vector<std::string> sixDirectionsFiles();

/// Writes report.json, augmented.yaml and report.html into a folder, and the report of each direction into a subfolder.
/// Returns an empty string, or the reason in one line if a page could not be drawn. Throws std::runtime_error.
std::string writeReports(const SixDirectionsDiagnosis& diagnosis, const std::string& folder);

}  // namespace rubber_suspension::diagnosis
