// Logs.
#include "rubber_suspension/io/log.h"
