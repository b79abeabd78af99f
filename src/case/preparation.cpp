#include "case/preparation.h"

#include <fmt/format.h>

namespace flexslip {

std::string flag_of(const PreparationStep& step) {
  const std::size_t begin = step.key.find("] ");
  const std::size_t equals = step.key.find(" = ");
  if (begin == std::string::npos || equals == std::string::npos) return "";
  std::string name = step.key.substr(begin + 2, equals - begin - 2);
  for (char& c : name)
    if (c == '_') c = '-';
  return fmt::format("--{} {}", name, step.key.substr(equals + 3));
}

}  // namespace flexslip
