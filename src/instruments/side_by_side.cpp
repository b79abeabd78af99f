#include "instruments/side_by_side.h"

#include <algorithm>

#include "instruments/column_role.h"
#include "instruments/column_words.h"

namespace flexslip {
namespace {

// The groups of `size` columns each behind the first `shared` of those that have a title.
std::vector<ColumnGroup> groups_of(std::span<const std::string> titles, std::span<const std::size_t> titled,
                                   std::size_t shared, std::size_t size) {
  for (std::size_t i = shared + size; i < titled.size(); ++i)
    if (titles[titled[i]] != titles[titled[i - size]]) return {};
  std::vector<ColumnGroup> groups;
  for (std::size_t begin = shared; begin < titled.size(); begin += size) {
    groups.push_back({titled[begin], {titled.begin(), titled.begin() + static_cast<std::ptrdiff_t>(shared)}});
    for (std::size_t i = begin; i < begin + size; ++i) groups.back().columns.push_back(titled[i]);
  }
  return groups;
}

}  // namespace

std::vector<ColumnGroup> side_by_side(std::span<const std::string> titles) {
  std::vector<std::size_t> titled;
  for (std::size_t i = 0; i < titles.size(); ++i)
    if (!titles[i].empty()) titled.push_back(i);
  for (const std::size_t shared : {std::size_t{0}, std::size_t{1}})
    for (std::size_t size = 2; shared + 2 * size <= titled.size(); ++size) {
      if ((titled.size() - shared) % size != 0) continue;
      const auto own = std::span(titled).subspan(shared, size);
      const bool has_force = std::any_of(own.begin(), own.end(), [&](std::size_t column) {
        return role_of(title_parts(titles[column]).name) == ColumnRole::force;
      });
      if (!has_force) continue;
      const std::vector<ColumnGroup> groups = groups_of(titles, titled, shared, size);
      if (!groups.empty()) return groups;
    }
  return {};
}

}  // namespace flexslip
