// Can the drops of a sawtooth be cracks alone?
//
// A drop by slip and a drop by a loss of stiffness both run along the load line, and both move the deflection. What differs is how the force
// rises between drops: a cracked fibre goes on as the same fibre, less stiff; one that slips goes on where friction lets it. So the rows of
// each rise are explained both ways, with errors of the force that are AR(1), and bending stiffness known to 5 %:
//   cracks   F = e_j Ψ_F(w; μ + d (S - S̄)), e_j never rising from rise to rise; or with d = 0; or with e falling within a rise as well
//   slip     F = e Ψ_F(w; a_j + b_j (S - S̄_j)), b_j about one b; or with e less at each drop
// judged by BIC. What no single loading tells is slip alone from slip with some loss of stiffness: for that, unload and load again.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "bending_test/rig.h"
#include "data/drops.h"
#include "data/record.h"

namespace flexslip {

enum class CrackVerdict {
  not_by_cracks_alone,  // margin > 12, and more than half of the rises are stiffer towards their end
  cracks,               // margin < -6
  cannot_be_told,       // neither, or too few drops to judge
};

std::string_view name_of(CrackVerdict verdict);

// A way to explain the rows of all rises.
struct RiseExplanation {
  double bic;   // Bayes' information criterion
  double left;  // [1] of the bending stiffness after the last drop, over that before the first
};

inline constexpr double cracks_ruled_out = 12;  // of D*, where most rises grow stiffer

struct SlipOrCrack {
  bool judged;  // three drops and three rises of three rows or more: nothing below is valid otherwise
  CrackVerdict verdict;
  double margin;           // D*: BIC of the best of the cracks less that of the best of the slips
  double margin_arrested;  // D: likewise, without cracks that run on within a rise
  RiseExplanation cracks, cracks_constant, cracks_running;  // F, F0, G
  RiseExplanation slip, slip_and_cracks;                    // S, B
  std::size_t rises;                                        // that are judged
  std::size_t
      stiffer_rises;  // of these, in which the apparent stiffness F/Ψ_F(w; μ) rises: cracks alone cannot do that
};

// Domain:     a faultless record of one loading; drops = those found in it, in order; rig.stiffness > 0.
// Method:     Nelder and Mead (NLopt) over two to five numbers; levels in closed form, those of the cracks by pooling adjacent violators.
//             Rows with a deflection between 0.06 and 0.43, of the first and the last rise at most 15.
// Cost:       20 ms for 200 rows.
SlipOrCrack slip_or_crack(const ReducedRecord& record, const Rig& rig, std::span<const Drop> drops);

}  // namespace flexslip
