#include "report/report.h"

#include <filesystem>

#include <fmt/format.h>

#include "case/case_file.h"
#include "io/text.h"
#include "io/text_file.h"
#include "report/answer_words.h"
#include "report/fit_document.h"
#include "report/page.h"
#include "report/studio_page.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

constexpr const char* studio_name = "studio.html";

}  // namespace

DrawStatus write_report(const std::string& folder, const FittedTest& test, const std::string& studio) {
  const fs::path base(folder);
  make_folder((base / "figures").string());
  const std::string link =
      studio.empty() ? ""
                     : fmt::format(
                           "<p class=\"files\"><a href=\"{}\">Open this test in the studio</a>: see it move, change "
                           "it, fit it again, in this browser.</p>\n",
                           html_escaped(studio));
  DrawStatus drawn = DrawStatus::drawn;
  const std::string body = in_html(document_of(test), [&, number = 0](const Plot& plot) mutable {
    drawn = draw(plot, (base / "figures").string(), {"svg", "pdf", "png"});
    return html_figure(folder, plot, drawn, ++number);
  });
  write_text((base / "report.html").string(),
             page(test.name + ": friction in a bending test", answer_of(test), link + body));
  return drawn;
}

void announce_report(CallFiles& files, const std::string& folder, const std::string& option) {
  files.writes(fs::path(folder) / "report.html", option);
  files.writes_below(fs::path(folder) / "figures", option);
  if (built_studio_page()) files.writes(fs::path(folder) / studio_name, option);
}

DrawStatus write_report_with_studio(const std::string& folder, const FittedTest& test) {
  const auto built = built_studio_page();
  if (!built || test.measurement.file == "-") return write_report(folder, test);
  make_folder(folder);
  write_studio_page((fs::path(folder) / studio_name).string(), *built,
                    {taken_along(read_case(std::string_view(test.provenance.test), ""), test.name)});
  return write_report(folder, test, studio_name);
}

}  // namespace flexslip
