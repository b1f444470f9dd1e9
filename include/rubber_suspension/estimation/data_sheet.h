// Converts other numbers of a data sheet (stiffness ratio, hardness and shape, second loss angle) to a specification.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::estimation {

/// Returns Young's modulus [Pa] at small strain from Shore A hardness:
/// E = 0.0981 (56 + 7.62336 H)/(0.137505 (254 - 2.54 H)) MPa, for 20 <= H <= 80.
/// Source: A. N. Gent, IRI Transactions 34 (1958) 46-57. Hardness is specified to 5 degrees at best, which changes the
/// modulus by about a sixth. Throws std::invalid_argument outside the range.
double modulusFromShoreA(double hardness);

/// Returns the apparent modulus of a bonded block in compression relative to Young's modulus: 1 + 2 S^2, where S is the
/// loaded area over the free area of one layer. Valid for blocks about as long as wide, up to 10 % compression, and 0.2
/// <= S <= 3: a slenderer block bends, a flatter one loses more than 3 % of stiffness by compressibility. Source: A. N.
/// Gent and P. B. Lindley, Proc. IMechE 173 (1959) 111-122. Throws std::invalid_argument outside the range.
double compressionFactor(double shape_factor);

enum class LoadDirection { compression, shear };

/// Returns the table of the keys of `data_sheet:` that a specification does not have.
const std::vector<element::ParameterInfo>& dataSheetParameters();

struct DataSheetResult {
  Model model;
  Specification specification;
  std::vector<std::string> notes;  ///< statements on how numbers were derived, and how reliable they are
};

/// Converts a data sheet to a specification. The keys of `values` are the names in dataSheetParameters() and
/// specificationParameters().
///
/// - static_stiffness may be replaced by shore_a, loaded_area A, layer_thickness t, shape_factor S (and layers n). It
/// is E (1 + 2 S^2) A/(n t) in compression, and G A/(n t) in shear with G = E/3, for S >= 1 without bending;
/// - dynamic_stiffness may be replaced by dynamic_to_static_ratio;
/// - second_loss_angle at second_frequency determines the break frequency of the model maxwell_dashpot, whose other
/// parameters follow from static_stiffness, dynamic_stiffness and loss_angle.
/// If no model is given, the simplest model that accepts all inputs is chosen.
///
/// Throws std::invalid_argument that states key, value and what is accepted: for a dynamic stiffness or a loss angle
/// from hardness (which depend on the filler instead), for a second loss angle of another model, and for inputs without
/// a solution.
DataSheetResult specificationFromDataSheet(std::optional<Model> model, LoadDirection direction,
                                           const std::map<std::string, double>& values);

}  // namespace rubber_suspension::estimation
