// Span and section as an export states them, compared with what the user states.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/preparation.h"
#include "case/test.h"
#include "instruments/export.h"

namespace flexslip {

// Adds to a test what its file states and the user does not, with a step for each: the span, the
// dimensions of the section, and the stiffness of the load train [N/m]. A stated width is completed
// by the thickness of the file, and a stated height by its width. No section is taken from a file
// that states a diameter and also width or thickness, as forms of a machine do that list them all.
// Fails:      InputError for a width without a height, or a height without a width, of either.
void complete_from_file(Test& test, const ExportedTest& found, const std::optional<double>& load_train,
                        std::vector<PreparationStep>& steps);

// Sentences on contradictions between the user and the file: a dimension that differs by more than
// 1 %, and a column of flexural stress (3FL/2bh², 8FL/πd³) that does not follow from the stated span
// and section. Such a column, or one of strain (6wh/L²), also shows who is right.
// Domain:     `asked` is the test as the user states it; `completed`, the same with the file's span
//             and section; force and displacement are columns of the specimen.
std::vector<std::string> contradictions(const Test& asked, const Test& completed, const Export& file,
                                        const ExportedSpecimen& specimen, const ExportColumn& force,
                                        const ExportColumn& displacement);

// True for a column of force that holds a stress, in a unit of pressure.
bool holds_stress(const ExportColumn& force);

// [N] The forces of flexural stresses [Pa], by F = 8 I σ/(L h).
// Fails:      InputError without span or section.
std::vector<double> forces_of_stresses(const Test& completed, const Export& file, const ExportColumn& column,
                                       std::vector<double> stresses);

}  // namespace flexslip
