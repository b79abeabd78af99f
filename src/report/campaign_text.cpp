#include "report/campaign_text.h"

#include <string_view>

#include "report/campaign_words.h"
#include "report/plain_text.h"

namespace flexslip {
namespace {

std::string titled(std::string_view title, const PrintedTable& table) {
  return table.rows.empty() ? "" : "\n[[" + std::string(title) + "]]\n" + laid_out(table);
}

}  // namespace

std::string campaign_text(const Campaign& campaign) {
  std::string text = wrapped(answer_of(campaign), "");
  text += titled("Tests", test_rows(campaign));
  text += titled("Categories: mean (min to max)", category_rows(campaign));
  text += titled("Shared by the tests", shared_rows(campaign));
  text += titled("No answer", failure_rows(campaign));
  text += "\n" + wrapped(category_rule(), "");
  if (const std::string suspects = suspects_in_words(campaign); !suspects.empty()) text += "\n" + wrapped(suspects, "");
  return text;
}

}  // namespace flexslip
