// The steps by which a file becomes a record, as they are taken.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case/case_file.h"
#include "case/preparation.h"

namespace flexslip {

// The steps of one preparation, and what they are said of.
class PreparationSteps {
 public:
  PreparationSteps(Preparation& preparation, const Case& input) : steps_(preparation.steps), input_(input) {}

  void add(std::string_view name, bool changed, std::string done, std::optional<KeyChange> otherwise,
           std::optional<PreparedValue> value = {}, std::optional<RowRange> rows = {}) {
    steps_.push_back({std::string(name), changed, std::move(done), value, rows, std::move(otherwise)});
  }

  PreparedValue value(double value, std::optional<double> error, const Kind& kind) const {
    return {value, error, kind_in(input_, kind)};
  }

 private:
  std::vector<PreparationStep>& steps_;
  const Case& input_;
};

}  // namespace flexslip
