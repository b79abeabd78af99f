// Measured tests: whether the force drops are slips over the supports or cracks, and the friction. The answers are
// the same as from the command `flexslip fit`.
#pragma once

#include <string>
#include <vector>

#include "flexslip/estimate.h"
#include "flexslip/test.h"

namespace flexslip::v1 {

// A detected periodic variation of friction.
struct FittedWave {
  Estimate amplitude;   // [1] relative to mu0
  Estimate wavelength;  // [m] along the specimen
};

// A warning, a condition or a check of the answer, which can be quoted alone.
struct Finding {
  std::string code;      // does not change within 1.x
  std::string severity;  // refusal, suspicion, doubt, condition, note, passed or unjudged
  std::string sentence;
  std::string remedy;  // what to do; may be empty
};

// The answer. Numbers that the record does not determine are not_known.
struct Fit {
  std::string verdict;   // slip, slip_and_damage, undecided, crack, settled, no_drops, check_input or no_answer
  std::string sentence;  // the verdict, its meaning and its evidence
  // [1] Probabilities of the causes of the drops, for equal prior probabilities. Without a reload, `both` is not known
  // and `slips` is reliable below 0.5.
  double slips, cracks, both;
  Estimate mu0;                     // [1] mean friction over the observed length
  bool mu0_is_limit;                // friction cannot be distinguished from 0: mu0.high is an upper limit
  std::vector<FittedWave> waves;    // one or two if the evidence supports them; otherwise empty
  Estimate bending_stiffness;       // [N m^2] EI
  double work_of_fracture;          // [J] area under force over deflection
  double bending, friction, snaps;  // [J] the parts of it
  double friction_share;            // [1] the part of the work that went into friction and snaps
  std::vector<Finding> findings;    // most serious first
  std::string next;                 // the recommended next step; may be empty
  std::string json;                 // the whole answer, as `flexslip fit --json` writes it (docs/results.md)
};

// Fits a record in memory.
// Domain:     a setup with a span and a load train. The bending stiffness may be unknown.
// Max error:  the 95 % interval of mu0 contains the friction of 93 % of simulated elastic tests with all
//             errors of a rig, and of fewer if the specimen cracks or yields (docs/validation.md).
// Fails:      Error for an input outside the domain. A record that does not determine friction is no error: the
//             verdict and the findings say so.
// Cost:       0.1 s to 0.5 s; three times as much if no roller radius is stated.
Fit fit(const Setup& setup, const Record& record);

// The same for a file: an export of a testing machine, CSV or XLSX, whose titles name its columns. A span and a section
// in the file need not be stated.
// Fails:      Error also for a file that cannot be read, or whose columns are ambiguous: see read_export.
Fit fit_file(const Setup& setup, const std::string& path);

// The same for a case file (docs/case-files.md), which can state all that FlexSlip knows of a test. `changes` are those
// of --set: "rig.stiffness=90 N/m".
// Fails:      Error with file, line and key.
Fit fit_case(const std::string& path, const std::vector<std::string>& changes = {});

}  // namespace flexslip::v1
