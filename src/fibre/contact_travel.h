// Where along the specimen the contacts are, as it is drawn in over rollers.
//
// The fibre is drawn in and rolls on at once: at first the contacts roll outwards faster than it is drawn in, so that the axis between them
// becomes shorter, and later longer. How far they have travelled along the specimen only grows (theory.md, "Rollers and thickness").
#pragma once

#include <vector>

#include "fibre/fibre.h"

namespace flexslip {

class ContactTravel {
 public:
  // On edges: a length drawn in is the length between the contacts.
  ContactTravel() = default;

  // At a constant friction, for lengths Σ of about [S_least, S_most], linear beyond.
  // Domain:     1 < S_least < S_most, where the fibre has states; on edges that of edges.
  // Max error:  1e-6 of the length, for the friction stated.
  ContactTravel(const Fibre& fibre, double q, double S_least, double S_most);

  // [L] Rising: the length between the contacts once it grows, and mirrored at the least length before.
  double at(double S) const;
  double slope(double S) const;  // dξ/dΣ >= 0

  // [L] Σ at which it has come so far.
  double drawn_in_at(double travel) const;

  // Do the contacts roll outwards faster than the fibre is drawn in?
  bool rolls_back_at(double travel) const { return travel < turn_; }
  // [L] The length between the contacts.
  double length_at(double travel) const { return rolls_back_at(travel) ? 2 * turn_ - travel : travel; }

 private:
  struct Value {
    double length, slope;  // [L], dℓ/dσ
  };
  Value value(double sigma) const;

  Fibre fibre_;                             // for its coordinate σ
  double first_ = 0, last_ = 0, step_ = 0;  // of σ
  std::vector<Value> knots_;                // none on edges
  double turn_at_ = 0;                      // σ of the least length
  double turn_ = -INFINITY;                 // [L] of it
};

}  // namespace flexslip
