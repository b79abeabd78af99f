#include "report/campaign_text.h"

#include <string_view>

#include "io/text_table.h"
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

}  // namespace

std::string campaign_text(const Campaign& campaign) {
  std::string text = wrapped(answer_of(campaign), "");
  text += titled("Tests", test_rows(campaign));
  text += titled("Categories: mean (min to max)", category_rows(campaign));
  text += titled("Between specimens", specimen_rows(campaign));
  text += titled("Shared by the tests", shared_rows(campaign));
  if (!campaign.shared.empty()) text += "\n" + wrapped(sharing_rule(), "");
  text += failures(campaign);
  text += "\n" + wrapped(category_rule(), "");
  if (!specimen_rows(campaign).rows.empty()) text += "\n" + wrapped(specimen_rule(), "");
  if (const std::string suspects = suspects_in_words(campaign); !suspects.empty()) text += "\n" + wrapped(suspects, "");
  return text;
}

}  // namespace flexslip
