// A measured test with its results and provenance, as presented by JSON, text, figures and reports.
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

// The choice of an analysis: by the call, otherwise by the case.
struct AnalysisChoice {
  std::string model;  // name; empty: the model of the case, or roughness
  AnalysisOptions options{};
};

// The names of models that can be fitted.
std::vector<std::string> model_names();

// The analysis options of a test: from the call, with the friction that its supports allow. The
// default model is the model of the case if it has no parameters; with parameters, it is a model
// for simulation.
// Fails:      InputError if the model of the case cannot be fitted.
AnalysisOptions options_for(const Test& input, const AnalysisChoice& choice);

// A summary of the options for reports and for stored results.
Fields<AnalysisOptions> analysis_fields();

struct InputFile {
  std::string name;    // the name that the user gave
  std::string sha256;  // empty for standard input, which can be read only once
};

// The inputs that reproduce the same output with the same version of the program.
struct Provenance {
  std::string version;
  std::vector<InputFile> inputs;
  std::string test;  // the case as TOML, also if flags stated it
  AnalysisOptions options;
};

// Drops of the force in all loadings except the evaluated one.
struct DropsElsewhere {
  std::size_t drops = 0;
  RowRange rows_of_most{};  // of the file: the loading with the maximum of drops
};

struct FittedTest {
  std::string name;  // of the case or data file
  bool reduced;      // true if all numbers are in the model's scaled variables
  Measurement measurement;
  StiffnessSource stiffness;
  std::optional<double> section_moment;  // [m^4] I, if the section is known
  std::optional<Materials> materials;    // in contact, if the case states both
  BeamGeometry geometry;                 // span, and section if known
  SmallDeflection small_deflection;      // of the first curve, by the bending standards
  TestAnalysis analysis;                 // of the evaluated loading
  std::optional<PassesFit> passes;       // if the record has an unloading; in the scales of the analysis
  DropsElsewhere drops_elsewhere;
  std::optional<ImagedLength> imaged;  // if the record has imaged lengths and the analysis succeeded
  Judgement judgement;                 // for any status of the analysis
  std::optional<SurfaceStrain>
      surface;  // with the fitted stiffness; if the analysis succeeded and the section is known
  std::optional<double> strain_at_break;  // [1] from the case, or from its strength
  double nose_curvature;                  // [1/L] at which the specimen wraps the nose; infinite for a sharp nose
  Provenance provenance;
  // The same readings on rollers of the usual radius, if the case states no supports, a usual
  // radius exists (data/small_deflection.h) and the analysis succeeded.
  std::shared_ptr<const FittedTest> on_rollers{};
};

// A measured test as the input of an analysis.
struct DescribedTest {
  BendingStiffnessUsed stiffness;
  TestDescription description;  // with the fit of all passes, if the record has an unloading
  AnalysisOptions options;      // with the rests of its stage
};

// Fails:      InputError as scales_of.
DescribedTest describe(const Measurement& measurement, const AnalysisOptions& options = {});

// The name of the test in a file: the file name without folder and ending; for case.toml, the name
// of its folder.
std::string name_of_test(const std::string& file);

// Reads and analyses the record of a case.
// Fails:      InputError as read_measurement and scales_of; for friction models that cannot be
//             fitted.
FittedTest fit_test(const Test& asked, const AnalysisOptions& options);

// The joint fit of all passes of a record; empty for a record of one pass.
// Fails:      InputError as scales_of.
std::optional<PassesFit> fit_passes_of(const Measurement& measurement);

// The row of the file, from 1, at which a point of the record begins.
std::size_t file_row(const FittedTest& test, std::size_t point);

// The row of the last evaluated reading.
std::size_t last_row(const FittedTest& test);

// Pointwise friction of the curve above the minimum deflection for friction, at the fitted bending
// stiffness, or at the stated one without a fit.
const FrictionProfile& profile_of(const FittedTest& test);

// Stage, deflection and force of the points of a pass, starting at the turn before it.
// Domain:     a pass of test.passes.
Record record_of(const FittedTest& test, const PassFriction& pass);

// True if the analysis succeeded.
inline bool is_fitted(const FittedTest& test) { return test.analysis.status == AnalysisStatus::ok; }

// "ok", or the reason for failure: "too_few_points", "not_explained".
std::string_view status_of(const FittedTest& test);

std::string_view name_of(SawtoothCategory category);

}  // namespace flexslip
