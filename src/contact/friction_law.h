// What a support does to the fibre: it holds it while at rest, and rubs while it slides.
//
// Coulomb's law with one coefficient, |q| <= μ(S), is the paper's; there a sawtooth needs a friction that varies along the
// fibre. With a static friction above the kinetic one the fibre sticks and slips on supports as smooth as one likes: the
// alternative that the paper leaves open. A fibre at rest stays so while |q| <= μ_s(S). Once it slides, q = ±μ_k(S) until
// the sliding stops: when the stage turns back or halts, or a snap comes to rest.
#pragma once

#include <utility>

#include "contact/friction.h"

namespace flexslip {

struct FrictionLaw {
  Friction kinetic;        // μ_k
  Friction static_excess;  // μ_s - μ_k; zero: Coulomb's law

  FrictionLaw(Friction coulomb)  // NOLINT(google-explicit-constructor): a friction is a law by itself
      : FrictionLaw(std::move(coulomb), Friction::constant(0)) {}
  FrictionLaw(Friction sliding, Friction excess) : kinetic(std::move(sliding)), static_excess(std::move(excess)) {}
};

// μ_s. Domain: S >= 1.
inline double static_friction(const FrictionLaw& law, double S) {
  return law.kinetic.at(S).mu + law.static_excess.at(S).mu;
}

}  // namespace flexslip
