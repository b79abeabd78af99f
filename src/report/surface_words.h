// What a height trace says, sentence by sentence.
#pragma once

#include <string>
#include <vector>

#include "case/surface_study.h"

namespace flexslip {

// "0.112 ± 0.031 µm" with the ends of its interval, "[0.05, 0.17] µm"; plain numbers likewise.
std::string with_interval(const Estimate& estimate, const Kind& kind);

// Sentences, each complete in itself.
std::string surface_in_short(const SurfaceStudy& study);
std::vector<std::string> waves_in_words(const SurfaceStudy& study);
std::vector<std::string> resolution_in_words(const SurfaceStudy& study);

// All of it, laid out for a terminal.
std::string surface_text(const SurfaceStudy& study);

}  // namespace flexslip
