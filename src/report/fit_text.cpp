#include "report/fit_text.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "report/answer_words.h"
#include "report/cycles_words.h"
#include "report/fit_print.h"
#include "report/fit_words.h"
#include "report/implied_words.h"
#include "report/plain_text.h"
#include "report/preparation_words.h"
#include "report/small_deflection_words.h"
#include "report/teeth_words.h"

namespace flexslip {
namespace {

std::string variables(const FittedTest& test) {
  PrintedTable table{{"", "value", "95 % interval", "remark"}, {}};
  for (const auto& row : parameter_rows(test)) table.rows.push_back({row.name, row.value, row.interval, row.remark});
  std::vector<std::size_t> widths(3);
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < 3; ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  std::string out;
  for (const auto& row : table.rows) {
    std::string line = fmt::format("   {}  {}", padded_right(row[0], widths[0]), row[1]);
    if (!row[2].empty()) line += fmt::format("{}  [{}]", std::string(widths[1] - width_of(row[1]), ' '), row[2]);
    if (!row[3].empty()) line += fmt::format("{}  {}", std::string(widths[2] - width_of(row[2]), ' '), row[3]);
    out += line + '\n';
  }
  return out;
}

std::string preparation_text(const FittedTest& test) {
  std::string text = "\n[[From the file to the record]]\n";
  for (const auto& sentence : preparation_in_words(test.measurement.preparation))
    text += wrapped(sentence, "   ", " - ");
  return text;
}

}  // namespace

std::string fit_text(const FittedTest& test) {
  std::string text = wrapped(fmt::format("{}: {}", test.name, answer_of(test)), "");
  if (test.analysis.status != AnalysisStatus::ok) return text + preparation_text(test);
  const std::string indent(3, ' ');
  const auto paragraph = [&](const std::string& words) { text += wrapped(words, indent, indent); };
  text += fmt::format("\n[[Friction]] of the model {}\n{}", model_in_words(test.analysis.fit.model), variables(test));
  const std::string caution = caution_of(test);
  if (!caution.empty()) paragraph(caution);
  paragraph(friction_in_words(test));
  paragraph(wave_in_words(test));
  for (const std::string& words : {sides_in_words(test), smoothing_in_words(test)})
    if (!words.empty()) paragraph(words);
  for (const std::string& words : implied_in_words(test)) paragraph(words);
  if (test.analysis.fit.explanations.size() > 1) text += laid_out(explanation_table(test));
  text += "\n[[Checks]]\n";
  for (const auto& words : checks_in_words(test)) text += wrapped(words, indent, " - ");
  text += "\n[[Slips]]\n";
  paragraph(slips_in_words(test));
  if (!test.analysis.drops.drops.empty()) text += laid_out(drop_table(test));
  text += "\n[[Stick or slide]]\n";
  paragraph(teeth_in_words(test));
  if (const auto table = tooth_table(test); !table.rows.empty()) text += laid_out(table);
  if (test.cycles) {
    text += "\n[[Load and unload]]\n";
    for (const auto& words : cycles_in_words(test)) paragraph(words);
    if (const auto table = loop_table(test); !table.rows.empty())
      text += laid_out(table) + laid_out(loop_energy_table(test));
    paragraph(reloading_in_words(test));
    text += laid_out(loading_table(test));
  }
  text += fmt::format("\n[[Energy]]{}\n", test.cycles ? " of the first loading" : "");
  if (!caution.empty()) paragraph(caution);
  text += laid_out(energy_table(test));
  text += "\n[[Plausibility]]\n";
  if (const auto words = strain_in_words(test); !words.empty()) paragraph(words);
  paragraph(friction_in_literature(test));
  paragraph(suspicion_in_words(test));
  paragraph(replay_in_words(test));
  text += "\n[[Small deflection]]\n" + laid_out(small_deflection_table(standard_test(test)));
  for (const auto& words : small_deflection_in_words(standard_test(test))) paragraph(words);
  paragraph(small_deflection_and_fit(test));
  text += preparation_text(test);
  text += "\n[[Assumed]]\n";
  for (const auto& sentence : assumptions_of(test)) text += wrapped(sentence, indent, " - ");
  return text;
}

}  // namespace flexslip
