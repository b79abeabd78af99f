// Planned tests: whether a test will show a sawtooth, and what would change that.
#pragma once

#include <cstddef>
#include <string>

#include "flexslip/test.h"

namespace flexslip::v1 {

struct Design {
  std::string status;         // ok; slipped_through or breaks: the numbers hold up to there
  std::string sentence;       // the answer in words
  std::size_t snaps;          // all, however small
  std::size_t drops;          // recorded with this step
  double largest_drop;        // [N] of the recorded force; 0 without drops
  double maximum_force;       // [N]
  double critical_stiffness;  // [N/m] of the load train, at and above which no snap occurs; infinite if on every rig
  double work_of_fracture;    // [J]
  double friction_share;      // [1] part of the work that goes into friction and snaps
  std::string json;           // the whole answer, as `flexslip design --json` writes it (docs/results.md)
};

// One loading from 0 to a stage position, `travel` [m], with readings every `step` [m].
// Domain:     as simulate.
// Max error:  1e-7 for force and work; 1e-5 of the work for its parts; 1e-6 of the maximum force for drops.
// Fails:      Error for an input outside the domain, and for a test that cannot exist.
// Cost:       about 0.2 s.
Design design(const Setup& setup, const Friction& friction, double travel, double step);

}  // namespace flexslip::v1
