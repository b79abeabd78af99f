#include "report/campaign_text.h"

#include <algorithm>
#include <string_view>

#include "io/text.h"
#include "report/campaign_surface_words.h"
#include "report/campaign_words.h"
#include "report/plain_text.h"

namespace flexslip {
namespace {

std::string titled(std::string_view title, const PrintedTable& table) {
  return table.rows.empty() ? "" : "\n[[" + std::string(title) + "]]\n" + laid_out(table);
}

// One below the other: reasons are sentences.
std::string failures(const Campaign& campaign) {
  std::string text;
  for (const auto& test : campaign.tests)
    if (!test.summary) text += wrapped(printable(test.name + ": " + test.reason), "  ");
  return text.empty() ? "" : "\n[[No answer]]\n" + text;
}

// What fits on a line; all of it is on the page and in its files.
std::string tests(const Campaign& campaign) {
  const PrintedTable all = test_rows(campaign, with_error);
  if (all.rows.empty()) return "";
  // Doubts to the left of their column, as much of them as the line holds.
  std::string text = "\n";
  std::string_view rest;
  PrintedTable shown = picked(all, {"Test", "Verdict", "μ₀", "Spacing", "Friction"});
  shown.head[2] = "Friction";
  shown.head[4] = "Work (%)";
  const std::string numbers = laid_out(shown);
  std::size_t width = 0, row = 0;
  for (rest = numbers; !rest.empty(); rest.remove_prefix(rest.find('\n') + 1))
    width = std::max(width, width_of(rest.substr(0, rest.find('\n'))));
  for (rest = numbers; !rest.empty(); rest.remove_prefix(rest.find('\n') + 1), ++row) {
    const std::string& doubts = row == 0 ? all.head.back() : all.rows[row - 1].back();
    std::string line = padded_right(rest.substr(0, rest.find('\n')), width) + "   " + doubts;
    if (width_of(line) > line_length) line = wrapped(line, "", "", line_length - 2);
    line = line.substr(0, line.find('\n'));
    if (!line.ends_with(doubts)) line += " …";
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

}  // namespace

std::string campaign_text(const Campaign& campaign) {
  std::string text = wrapped(answer_of(campaign), "");
  text += tests(campaign);
  text += titled("Categories: mean (min to max)",
                 picked(category_rows(campaign), {"Sawtooth", "Suspects", "Tests", "μ₀", "λ"}));
  text += titled("Between specimens", specimen_rows(campaign));
  text += titled("Shared by the tests", shared_rows(campaign));
  if (!campaign.shared.empty()) text += "\n" + wrapped(sharing_rule(), "");
  text += failures(campaign);
  text += "\n" + wrapped(category_rule() +
                             " ± are standard errors. A test that tells no friction, or only a limit, has no share.",
                         "");
  if (const std::string surfaces = surfaces_in_words(campaign); !surfaces.empty()) text += "\n" + wrapped(surfaces, "");
  if (!specimen_rows(campaign).rows.empty()) text += "\n" + wrapped(specimen_rule(), "");
  if (const std::string suspects = suspects_in_words(campaign); !suspects.empty()) text += "\n" + wrapped(suspects, "");
  return text;
}

}  // namespace flexslip
