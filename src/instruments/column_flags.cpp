#include "instruments/column_flags.h"

namespace flexslip {

bool is_displacement(ColumnRole role) {
  return role == ColumnRole::displacement || role == ColumnRole::crosshead || role == ColumnRole::deflection;
}

std::string_view flag_of(ColumnRole role) {
  switch (role) {
    case ColumnRole::time:
      return "--time";
    case ColumnRole::crosshead:
      return "--crosshead";
    case ColumnRole::deflection:
      return "--deflection";
    case ColumnRole::force:
      return "--force";
    default:
      return "--displacement";
  }
}

std::string_view word_for(ColumnRole role) { return flag_of(role).substr(2); }

std::string_view unit_flag_of(ColumnRole role) {
  return role == ColumnRole::force ? "--force-unit" : role == ColumnRole::time ? "--time-unit" : "--displacement-unit";
}

std::string_view usual_unit(ColumnRole role) {
  return role == ColumnRole::force ? "N" : role == ColumnRole::time ? "s" : "mm";
}

std::optional<Dimension> dimension_of(ColumnRole role) {
  switch (role) {
    case ColumnRole::time:
      return kind::time.dimension;
    case ColumnRole::displacement:
    case ColumnRole::crosshead:
    case ColumnRole::deflection:
      return kind::length.dimension;
    case ColumnRole::force:
      return kind::force.dimension;
    case ColumnRole::other:
      break;
  }
  return std::nullopt;
}

}  // namespace flexslip
