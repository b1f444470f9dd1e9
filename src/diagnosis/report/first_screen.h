// The part of the report that a reader sees first: where, which, how far, how sure, what next, beside the loop.
#pragma once

#include <string>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// HTML. `loop`: the figure of the log with the largest gap, empty where there is none.
std::string firstScreen(const Diagnosis& diagnosis, const std::string& loop);

/// How the experiment that is proposed can be played, HTML; empty where none is.
std::string howToPlay(const Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis
