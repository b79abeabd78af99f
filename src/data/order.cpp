#include "data/order.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace flexslip {

double median_of(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

std::vector<double> non_falling(std::span<const double> values) {
  struct Block {
    double mean;
    std::size_t size;
  };
  std::vector<Block> blocks;
  for (const double value : values) {
    blocks.push_back({value, 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean > blocks.back().mean) {
      const Block last = blocks.back();
      blocks.pop_back();
      Block& before = blocks.back();
      const auto a = static_cast<double>(before.size), b = static_cast<double>(last.size);
      before = {(before.mean * a + last.mean * b) / (a + b), before.size + last.size};
    }
  }
  std::vector<double> result;
  result.reserve(values.size());
  for (const auto& block : blocks) result.insert(result.end(), block.size, block.mean);
  return result;
}

std::vector<double> advancing(std::span<const double> values) {
  std::vector<double> result;
  for (const double value : values) result.push_back(std::max(value, result.empty() ? 0.0 : result.back()));
  return result;
}

}  // namespace flexslip
