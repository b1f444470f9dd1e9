// The diagnosis on one page: what `diagnose --plot` draws.
#pragma once

#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::diagnosis {

/// Loops and residual, the map of the gap, the gap over time: the report's figures, each for one log, which is the
/// first hold-out or, without hold-outs, that of the largest gap.
io::Figure overviewFigure(const Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis
