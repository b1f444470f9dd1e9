// Logs that took no part in the fit, as further logs of the comparison.
#pragma once

#include "diagnosis/judge/evidence.h"

namespace rubber_suspension::diagnosis {

/// What each hypothesis errs by on the logs of the fit, by blocks that were left out, and on unseen logs taken
/// together: both count as they have logs, and parts of unseen logs are blocks of further logs. The floor is that of
/// all of them; of unseen logs, the least that a hypothesis leaves. Evidence without unseen logs is as it was.
Evidence withFurtherLogs(Evidence evidence);

}  // namespace rubber_suspension::diagnosis
