// The diagnosis of a component of six directions: each selected one by itself, with the others as given motion, and a
// map of which displacement predicts the residual of which force.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/component/six_directions.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/pose_log.h"

namespace rubber_suspension::diagnosis {

/// A row's residual and a column's displacement of the cross map. The residual is that of the augmented component in
/// the generalised force of `of`. Its `share` is predicted by a cubic function of the displacements of `of` and `by`
/// together and of the rate of `of` times that of `by`, beyond cubics of the displacement and the rate of `of` alone;
/// on parts of the logs that took no part in the fit of these functions.
struct CrossShare {
  component::Direction of = component::kX;
  component::Direction by = component::kY;
  double share = 0.0;  ///< of the squared residual [-]; NaN if `by` does not move, or moves as `of` does
  double force = 0.0;  ///< RMS of what is predicted [N, N m]; likewise
};

struct DirectionDiagnosis {
  component::Direction direction = component::kX;
  Diagnosis diagnosis;  ///< of a rotation in rad and N m, where it says m and N
};

struct SixDirectionsDiagnosis {
  std::string component;
  std::vector<DirectionDiagnosis> directions;
  std::vector<CrossShare> cross_map;   ///< of each direction diagnosed, by each other
  io::ComponentDescription augmented;  ///< the whole component, other directions as configured but for radial_stiffness
  RunRecord run;
};

/// Throws std::invalid_argument that names the direction, where one of them is free, or is coupled with others by its
/// radius: of coupled directions no force belongs to one alone.
void requireDirections(const io::ComponentDescription& component, const std::vector<component::Direction>& directions);

/// Diagnoses directions of a component of six, each as diagnose() does it, with its own generalised force divided by
/// its factor of stiffness_by_preload. Throws as diagnose() and requireDirections() do, LogError also for a log without
/// wrenches.
SixDirectionsDiagnosis diagnoseDirections(const io::ComponentDescription& component,
                                          const std::vector<component::Direction>& directions,
                                          const std::vector<log::PoseLog>& logs,
                                          const std::vector<log::PoseLog>& hold_out,
                                          const DiagnosisOptions& options = {});

/// Returns the coupled pairs of the map as a sentence, and the map as a table for a terminal.
std::string crossMapSentence(const SixDirectionsDiagnosis& diagnosis);
std::string crossMapText(const SixDirectionsDiagnosis& diagnosis);

/// Schema rubber_suspension/gap_report/six_directions/1.
std::string toJson(const SixDirectionsDiagnosis& diagnosis);

/// Names of the files beside the folders of the directions.
std::vector<std::string> sixDirectionsFiles();

/// Writes report.json, augmented.yaml and report.html into a folder, and the report of each direction into a folder of
/// its name in it. Returns the reason in one line where no page is drawn; empty where all are. Throws
/// std::runtime_error.
std::string writeReports(const SixDirectionsDiagnosis& diagnosis, const std::string& folder);

}  // namespace rubber_suspension::diagnosis
