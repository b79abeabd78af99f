#include <string>

#include <doctest/doctest.h>

#include "campaign/campaign_plan.h"
#include "io/text_file.h"
#include "platform/child_process.h"
#include "report/page.h"
#include "report/report.h"
#include "tests/report/some_campaign.h"
#include "tests/temporary_folder.h"

using namespace flexslip;
namespace fs = std::filesystem;

TEST_CASE("outside: the report is well-formed, needs no other file, and links to what exists") {
  const TemporaryFolder folder;
  const std::string of_test = folder.path() / "tests" / folder_name(awkward_name);
  make_folder(of_test);
  write_text(of_test + "/report.html", "");
  const Drawing drawing = write_campaign_report(folder.path(), some_campaign());
  const std::string html = bytes_of(folder.path() / "report.html");
  CHECK(html.find("A &lt;b&gt; &amp; 50%_ü") != std::string::npos);
  CHECK(html.find("href=\"tests/A%20_b_%20%26%2050%25_%C3%BC%20_x_/report.html\"") != std::string::npos);
  CHECK(html.find("href=\"tests/SS4/") == std::string::npos);
  CHECK(html.find("<script") == std::string::npos);
  CHECK(html.find("<img") == std::string::npos);
  CHECK(html.find("SS8, not in the means") != std::string::npos);
  CHECK(html.find("99.csv: &lt;nothing&gt; &amp; &quot;nothing&quot; is not a number.") != std::string::npos);
  for (const std::string file : {"tests.csv", "categories.csv", "campaign.json", "campaign.xlsx"}) {
    INFO(file);
    CHECK(fs::file_size(folder.path() / file) > 100);
  }
  if (!drawing.is_done()) return;
  for (const std::string file : {"distributions.svg", "atlas-clear-1.pdf", "atlas-suspect-1.png", "atlas-none-1.gp"}) {
    INFO(file);
    CHECK(fs::exists(folder.path() / "figures" / file));
  }
  // A reader of HTML that knows which elements close.
  const auto result = run_child({"python3", "-c", R"(
import sys
from html.parser import HTMLParser
void = {'meta', 'br', 'link'}
class Reader(HTMLParser):
    open, ids = [], []
    def handle_starttag(self, tag, attributes):
        if tag not in void: self.open.append(tag)
        self.ids += [v for k, v in attributes if k == 'id']
    def handle_startendtag(self, tag, attributes):
        self.ids += [v for k, v in attributes if k == 'id']
    def handle_endtag(self, tag):
        if self.open.pop() != tag: sys.exit('closed: ' + tag + ' in ' + str(self.getpos()))
reader = Reader(); reader.feed(open(sys.argv[1], encoding='utf-8').read()); reader.close()
if reader.open: sys.exit('left open: ' + str(reader.open))
if len(set(reader.ids)) != len(reader.ids): sys.exit('an id twice')
)",
                                 folder.path() / "report.html"});
  INFO(result.output);
  CHECK((result.status == ChildStatus::not_found || result.exit_code == 0));
}

TEST_CASE("identity: the same campaign gives the same bytes, every file of it") {
  const TemporaryFolder first, second;
  write_campaign_report(first.path(), some_campaign());
  write_campaign_report(second.path(), some_campaign());
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(first.path())) {
    if (!entry.is_regular_file()) continue;
    const auto name = fs::relative(entry.path(), first.path());
    INFO(name.string());
    CHECK(bytes_of(entry.path()) == bytes_of(second.path() / name));
    ++files;
  }
  CHECK(files > 6);
}

TEST_CASE("limit: no tests, and none with an answer") {
  const TemporaryFolder folder;
  write_campaign_report(folder.path(), no_tests());
  CHECK(bytes_of(folder.path() / "report.html").find("No tests.") != std::string::npos);
  write_campaign_report(folder.path(), only_failures());
  const std::string html = bytes_of(folder.path() / "report.html");
  CHECK(html.find("Not evaluated") != std::string::npos);
  CHECK(html.find("b &amp; c.csv: &lt;no&gt; numbers_ in 100 %") != std::string::npos);
}
