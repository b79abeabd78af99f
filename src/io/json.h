// Results as JSON, for machines. Keys keep their order; numbers read back to the same bits; what does not exist is null.
#pragma once

#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "bending_test/history.h"
#include "data/scales.h"

namespace flexslip {

using Json = nlohmann::ordered_json;

// The units of the numbers: {"length": "m", …}, or those of the scaled variables.
Json units_json(bool reduced);

// [{stage, deflection_before, deflection_after, force_before, force_after, length_before, length_after}], in SI.
Json snaps_json(std::span<const Snap> snaps, const Scales& scales);

// {stage_work, bending, load_train, friction, snaps, imbalance} in SI.
Json energy_json(const EnergyAccount& energy, const Scales& scales);

// Writes indented JSON to a file; "-" is standard output.
// Fails:      InputError if not all could be written.
void write_json(const std::string& path, const Json& json);

}  // namespace flexslip
