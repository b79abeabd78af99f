// What a column of an export holds.
#pragma once

namespace flexslip {

// As far as its words say.
enum class ColumnRole {
  time,
  displacement,  // of the crosshead, or of the specimen's midpoint: the words do not say which
  crosshead,     // the words say that of the crosshead, stage or actuator
  deflection,    // the words say that of the specimen's midpoint
  force,
  other,
};

}  // namespace flexslip
