// The exports that the tests read: fixtures of this repository, and published ones where they are at hand.
#pragma once

#include <filesystem>
#include <string>

namespace flexslip {

inline const std::filesystem::path fixtures = std::filesystem::path(FLEXSLIP_SOURCE_DIR) / "tests/instruments/fixtures";
inline const std::filesystem::path campaign_exports =
    std::filesystem::path(FLEXSLIP_SOURCE_DIR) / "../shared/data/instruments";

}  // namespace flexslip
