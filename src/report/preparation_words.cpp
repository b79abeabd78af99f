#include "report/preparation_words.h"

#include <string_view>

#include <fmt/format.h>

namespace flexslip {
namespace {

std::string shown(const PreparedValue& value) {
  return value.error ? readable(value.value, *value.error, value.kind) : readable(value.value, value.kind);
}

}  // namespace

std::vector<PreparationRow> preparation_rows(const Preparation& preparation) {
  std::vector<PreparationRow> rows;
  rows.reserve(preparation.steps.size());
  for (const PreparationStep& step : preparation.steps)
    rows.push_back({step.name, step.done, step.value ? shown(*step.value) : "",
                    step.rows ? fmt::format("{} to {}", step.rows->first, step.rows->last) : "",
                    step.otherwise ? step.otherwise->in_case() : ""});
  return rows;
}

std::string step_in_words(const PreparationRow& row) {
  std::string sentence = fmt::format("{}: {}", row.name, row.done);
  const std::string rows = row.rows.empty() ? "" : "rows " + row.rows;
  if (!row.value.empty() || !rows.empty())
    sentence += fmt::format(" ({}{}{})", row.value, row.value.empty() || rows.empty() ? "" : "; ", rows);
  if (!row.otherwise.empty()) sentence += fmt::format("; to change this: {}", row.otherwise);
  return sentence;
}

std::vector<std::string> preparation_in_words(const Preparation& preparation) {
  std::vector<std::string> sentences;
  for (const PreparationRow& row : preparation_rows(preparation)) sentences.push_back(step_in_words(row));
  return sentences;
}

}  // namespace flexslip
