// In which rounding is counted.
#pragma once

namespace flexslip {

constexpr double unit = 0x1p-52;

}  // namespace flexslip
