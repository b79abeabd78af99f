// What a height trace says.
#pragma once

#include <string>
#include <vector>

#include "case/surface_study.h"
#include "report/document.h"

namespace flexslip {

// The answer in a sentence; all of it.
std::string surface_in_short(const SurfaceStudy& study);
std::vector<Chapter> document_of(const SurfaceStudy& study);

}  // namespace flexslip
