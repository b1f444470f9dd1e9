// A target needs a source, that of the precompiled headers too.
#include "precompiled.h"
