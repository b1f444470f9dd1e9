// Jobs as JSON: one line each in a manifest.
#pragma once

#include <nlohmann/json.hpp>

#include "campaign/job.h"

namespace rubber_suspension::campaign {

/// What decides the result, without the inputs; only options that are not the default.
nlohmann::ordered_json optionsJson(const JobOptions& options);

nlohmann::ordered_json jobJson(const Job& job);

/// Throws std::invalid_argument, nlohmann::json::exception.
Job jobFromJson(const nlohmann::json& json);

}  // namespace rubber_suspension::campaign
