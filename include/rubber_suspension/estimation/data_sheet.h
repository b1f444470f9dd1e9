// From other numbers of a data sheet to a specification: stiffness ratio, hardness and shape, a second loss angle.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::estimation {

/// Returns Young's modulus [Pa] at small strain from Shore A hardness:
/// E = 0.0981 (56 + 7.62336 H)/(0.137505 (254 - 2.54 H)) MPa, for 20 <= H <= 80.
/// Source: A. N. Gent, IRI Transactions 34 (1958) 46-57. Hardness is specified to 5 degrees at best, which is about a
/// sixth of the modulus. Throws std::invalid_argument outside the range.
double modulusFromShoreA(double hardness);

/// Returns the apparent modulus of a bonded block in compression over Young's modulus: 1 + 2 S^2, S being loaded over
/// free area of one layer. For blocks that are about as long as wide, up to 10 % compression, 0.2 <= S <= 3: a
/// slenderer block bends, a flatter one loses more than 3 % of stiffness to the compressibility of the rubber. Source:
/// A. N. Gent and P. B. Lindley, Proc. IMechE 173 (1959) 111-122. Throws std::invalid_argument outside the range.
double compressionFactor(double shape_factor);

enum class LoadDirection { compression, shear };

/// Returns the table of the keys of `data_sheet:` besides those of a specification.
const std::vector<element::ParameterInfo>& dataSheetParameters();

struct DataSheetResult {
  Model model;
  Specification specification;
  std::vector<std::string> notes;  ///< derivations and their reliability
};

/// Turns a data sheet into a specification. The keys of `values` are the names in dataSheetParameters() and
/// specificationParameters().
///
/// - static_stiffness may be replaced by shore_a, loaded_area, layer_thickness, shape_factor (and layers): in
///   compression E (1 + 2 S^2) A/(n t), in shear G A/(n t) with G = E/3 and S >= 1, below which bending counts;
/// - dynamic_stiffness may be replaced by dynamic_to_static_ratio;
/// - second_loss_angle at second_frequency gives the break frequency of the model maxwell_dashpot, its only free
///   parameter once it meets K_st, K_n and the loss angle at f_n.
/// Without a given model, the simplest that accepts all inputs is chosen.
///
/// Throws std::invalid_argument that names key, value and what is accepted: for a dynamic stiffness or a loss angle
/// from hardness (they depend on the filler instead), for a second loss angle of any other model, and for inputs
/// without solution.
DataSheetResult specificationFromDataSheet(std::optional<Model> model, LoadDirection direction,
                                           const std::map<std::string, double>& values);

}  // namespace rubber_suspension::estimation
