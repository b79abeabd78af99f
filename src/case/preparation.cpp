#include "case/preparation.h"

#include <algorithm>

#include <fmt/format.h>

namespace flexslip {

std::string KeyChange::in_case() const { return fmt::format("[{}] {} = {}", section, name, value); }

std::string KeyChange::flag() const {
  std::string flag(name);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return fmt::format("--{} {}", flag, value);
}

}  // namespace flexslip
