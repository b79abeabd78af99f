// A measured test together with its answers and where they come from: what JSON, text, figures and the report present.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/case_file.h"
#include "case/mechanics.h"
#include "case/standards.h"
#include "data/literature_friction.h"
#include "data/section.h"
#include "inference/analysis.h"
#include "inference/judgement.h"
#include "inference/passes.h"
#include "inference/profile.h"
#include "result/fields.h"

namespace flexslip {

// Which analysis a measured test is given: as a call says, or else its case.
struct AnalysisChoice {
  std::string model;  // its name; empty: as the case says, or roughness
  AnalysisOptions options{};
};

// Of the models that can be fitted.
std::vector<std::string> model_names();

// The options of a test: what the call says, and the friction that the supports of its case let act; where it names no model, that which its case names without parameters, for with
// parameters it says how to simulate.
// Fails:      InputError if the case names a model that cannot be fitted.
AnalysisOptions options_for(const Test& input, const AnalysisChoice& choice);

// What a report tells of them, and what an answer that is kept depends on.
Fields<AnalysisOptions> analysis_fields();

struct InputFile {
  std::string name;    // as the user named it
  std::string sha256;  // empty for standard input, which can be read only once
};

// What to give to the same version of the program to get the same bytes again.
struct Provenance {
  std::string version;
  std::vector<InputFile> inputs;
  std::string test;  // the case as TOML, also where it was given by flags
  AnalysisOptions options;
};

// Drops of the force in all loadings but that evaluated.
struct DropsElsewhere {
  std::size_t drops = 0;
  RowRange rows_of_most{};  // of the file: the loading that has most of them
};

struct FittedTest {
  std::string name;  // of the case or data file
  bool reduced;      // all numbers are in the model's scaled variables
  Measurement measurement;
  StiffnessSource stiffness;
  std::optional<double> section_moment;  // [m^4] I, if the case says what section the specimen has
  std::optional<Materials> materials;    // in contact, if the case states both
  BeamGeometry geometry;                 // span, and section if the case says what it is
  SmallDeflection small_deflection;      // of the loading evaluated, as the bending standards have it
  TestAnalysis analysis;                 // of the loading evaluated
  std::optional<PassesFit> passes;       // if it was unloaded; in the scales of the analysis
  DropsElsewhere drops_elsewhere;
  std::optional<ImagedLength> imaged;  // if the record has lengths that were imaged, and the analysis an answer
  Judgement judgement;                 // whatever the status of the analysis
  std::optional<SurfaceStrain>
      surface;  // of a specimen as stiff as fitted; if the analysis has an answer, and the case a section
  std::optional<double> strain_at_break;  // [1] as the case states it, or its strength
  double nose_curvature;                  // [1/L] from which it wraps the nose; infinite for a sharp one
  Provenance provenance;
  // The same readings on rollers of the usual radius, where the case states no supports and there is one (data/small_deflection.h), and the
  // analysis has an answer.
  std::shared_ptr<const FittedTest> on_rollers{};
};

// A measured test as an analysis takes it.
struct DescribedTest {
  BendingStiffnessUsed stiffness;
  TestDescription description;  // with the fit of all passes, where it was unloaded
  AnalysisOptions options;      // with the halts of its stage
};

// Fails:      InputError as scales_of.
DescribedTest describe(const Measurement& measurement, const AnalysisOptions& options = {});

// The name of the test that a file describes: its own, without folder and ending; that of its folder, which says more, for case.toml.
std::string name_of_test(const std::string& file);

// Reads the record of a case and analyses it.
// Fails:      InputError as read_measurement and scales_of; for friction models that cannot be fitted.
FittedTest fit_test(const Test& asked, const AnalysisOptions& options);

// All passes of a record together, and nothing else of its analysis; none of a record of one pass.
// Fails:      InputError as scales_of.
std::optional<PassesFit> fit_passes_of(const Measurement& measurement);

// The data row, counted from 1, at which a point of the record begins in its file.
std::size_t file_row(const FittedTest& test, std::size_t point);

// That of the last reading that is evaluated.
std::size_t last_row(const FittedTest& test);

// Friction as it was read off the curve: at the bending stiffness of the fit, past the deflection at which friction shows; where there is no
// fit, at that stated.
const FrictionProfile& profile_of(const FittedTest& test);

// Stage, deflection and force of the points of a pass, from the turn before it on.
// Domain:     a pass of test.passes.
Record record_of(const FittedTest& test, const PassFriction& pass);

// Has the analysis an answer?
inline bool is_fitted(const FittedTest& test) { return test.analysis.status == AnalysisStatus::ok; }

// "ok", or why not: "too_few_points", "not_explained".
std::string_view status_of(const FittedTest& test);

std::string_view name_of(SawtoothCategory category);

}  // namespace flexslip
