// Specification, models and their tables.
#include "rubber_suspension/estimation/specification.h"
