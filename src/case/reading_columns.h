// The columns of readings before they are a record.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "case/readings.h"
#include "data/record.h"

namespace flexslip {

// The readings as three columns, each still as its machine counts.
class ReadingColumns {
 public:
  explicit ReadingColumns(const Readings& readings) : is_(readings.columns) {
    for (const Column& column : readings.table.columns) values_.push_back(column.values);
  }

  bool has(Reading reading) const { return std::find(is_.begin(), is_.end(), reading) != is_.end(); }

  const std::vector<double>& of(Reading reading) const {
    return values_[static_cast<std::size_t>(std::find(is_.begin(), is_.end(), reading) - is_.begin())];
  }

  // Of the displacement, the one that comes first.
  const std::vector<double>& displacement() const { return values_.front(); }

  // In any unit, the column or what is proportional to it.
  std::vector<double> force_or_difference() const {
    if (has(Reading::force)) return of(Reading::force);
    std::vector<double> difference = of(Reading::stage);
    const std::vector<double>& deflection = of(Reading::deflection);
    for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= deflection[i];
    return difference;
  }

  void apply(const Signs& signs) {
    for (std::size_t i = 0; i < is_.size(); ++i)
      if (is_[i] != Reading::length && (is_[i] == Reading::force ? signs.force : signs.displacement) < 0)
        for (double& value : values_[i]) value = -value;
  }

  Record record(double stiffness) const {
    if (!has(Reading::force))
      return record_from_stage_and_deflection(of(Reading::stage), of(Reading::deflection), stiffness);
    return has(Reading::stage)
               ? record_from_stage_and_force(of(Reading::stage), of(Reading::force), stiffness)
               : record_from_deflection_and_force(of(Reading::deflection), of(Reading::force), stiffness);
  }

 private:
  std::vector<Reading> is_;
  std::vector<std::vector<double>> values_;
};

}  // namespace flexslip
