#include "report/workbook.h"

#include <string>

#include <doctest/doctest.h>

#include "answers/campaign_fields.h"
#include "io/input_error.h"
#include "io/text_file.h"
#include "platform/child_process.h"
#include "result/table.h"
#include "tests/report/some_campaign.h"
#include "tests/temporary_folder.h"

using namespace flexslip;
namespace fs = std::filesystem;

namespace {

// Reads a workbook as the standard has it (ECMA-376), without any of our code: {sheets: {NAME: rows}, dates, frozen}.
constexpr const char* reader = R"(
import json, re, sys, zipfile
import xml.etree.ElementTree as E
n = {'m': 'http://schemas.openxmlformats.org/spreadsheetml/2006/main'}
book = zipfile.ZipFile(sys.argv[1])
tree = lambda path: E.fromstring(book.read(path))
strings = [''.join(t.text or '' for t in s.iter('{%s}t' % n['m'])) for s in tree('xl/sharedStrings.xml').findall('m:si', n)]
def column(cell):
    number = 0
    for letter in re.match('[A-Z]+', cell).group():
        number = 26 * number + ord(letter) - 64
    return number - 1
def rows(path):
    out = []
    for row in tree(path).iter('{%s}row' % n['m']):
        cells = {}
        for cell in row.findall('m:c', n):
            value = cell.find('m:v', n)
            if value is not None:
                cells[column(cell.get('r'))] = strings[int(value.text)] if cell.get('t') == 's' else float(value.text)
        out.append([cells.get(i) for i in range(max(cells, default=-1) + 1)])
    return out
names = [s.get('name') for s in tree('xl/workbook.xml').iter('{%s}sheet' % n['m'])]
paths = ['xl/worksheets/sheet%d.xml' % (i + 1) for i in range(len(names))]
print(json.dumps({'sheets': {name: rows(path) for name, path in zip(names, paths)},
                  'dates': sorted({list(i.date_time)[0] for i in book.infolist()}),
                  'broken': book.testzip(),
                  'frozen': all(tree(p).find('.//m:pane', n).get('state', '').startswith('frozen') for p in paths)}))
)";

std::optional<Json> read_back(const std::string& path) {
  const auto result = run_child({"python3", "-c", reader, path});
  if (result.status == ChildStatus::not_found) return std::nullopt;
  INFO(result.output);
  REQUIRE(result.exit_code == 0);
  return Json::parse(result.output);
}

void write_campaign_xlsx(const std::string& path, const Campaign& campaign) {
  write_workbook(path, "Friction in bending tests", sheets_of(campaign));
}

}  // namespace

TEST_CASE("outside: a name that looks like a formula is text with a ' before it") {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "campaign.xlsx";
  Campaign campaign;
  for (const char* name : {"=1+1", "-1", "SS14"})
    campaign.tests.push_back(some_test(name, SawtoothCategory::clear, 0.5, 10.9e-6));
  write_campaign_xlsx(path, campaign);
  if (const auto read = read_back(path)) {
    const auto& tests = (*read)["sheets"]["Tests"];
    CHECK(tests[1][0] == "'=1+1");
    CHECK(tests[2][0] == "'-1");
    CHECK(tests[3][0] == "SS14");
  }
}

TEST_CASE("outside: another reader finds numbers as numbers, unchanged names, and frozen titles") {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "campaign.xlsx";
  write_campaign_xlsx(path, some_campaign());
  const auto read = read_back(path);
  if (!read) {
    MESSAGE("skipped: no python3");
    return;
  }
  CHECK((*read)["broken"].is_null());
  CHECK((*read)["frozen"] == true);
  CHECK((*read)["dates"] == Json({1980}));
  const auto& tests = (*read)["sheets"]["Tests"];
  REQUIRE(tests.size() == 7);
  CHECK(tests[0][0] == "test");
  CHECK(tests[1][0] == awkward_name);
  std::size_t wavelength = 0;
  while (tests[0].at(wavelength) != "wavelength (µm)") ++wavelength;
  CHECK(tests[1][wavelength].get<double>() == doctest::Approx(10.9).epsilon(1e-15));  // one rounding, to micrometres
  CHECK(tests[4].at(wavelength).is_null());
  CHECK((*read)["sheets"]["Categories"][1][3] == 0.5);
  CHECK((*read)["sheets"]["Failures"][1][3] == "99.csv: <nothing> & \"nothing\" is not a number.");
  CHECK((*read)["sheets"]["Specimens"][1][1] == "mu0");
}

TEST_CASE("outside: each sheet has the columns and rows of the CSV of its name") {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "campaign.xlsx";
  const Campaign campaign = some_campaign();
  write_campaign_xlsx(path, campaign);
  const auto read = read_back(path);
  if (!read) {
    MESSAGE("skipped: no python3");
    return;
  }
  const auto check = [&](const char* sheet, const ResultTable& table) {
    CAPTURE(sheet);
    const auto& rows = (*read)["sheets"][sheet];
    REQUIRE(rows.size() == 1 + table.rows.size());
    REQUIRE(rows[0].size() == table.columns.size());
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      CHECK(rows[0][i].get<std::string>().starts_with(table.columns[i].name));
  };
  check("Tests", test_table(campaign));
  check("Categories", category_table(campaign));
  check("Failures", failure_table(campaign));
  check("Specimens", specimen_table(campaign));
}

TEST_CASE("identity: the same campaign gives the same bytes") {
  const TemporaryFolder folder;
  write_campaign_xlsx(folder.path() / "a.xlsx", some_campaign());
  write_campaign_xlsx(folder.path() / "b.xlsx", some_campaign());
  CHECK(bytes_of(folder.path() / "a.xlsx") == bytes_of(folder.path() / "b.xlsx"));
}

TEST_CASE("limit: no tests, none with an answer, text that XML refuses") {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "campaign.xlsx";
  for (const auto& campaign :
       {no_tests(), only_failures(), campaign_of({failed_test("a\x01\xff", "b\x02.csv", "\x1b[31m")})}) {
    write_campaign_xlsx(path, campaign);
    const auto read = read_back(path);
    if (!read) return;
    CHECK((*read)["sheets"]["Tests"].size() == campaign.tests.size() + 1);
    CHECK((*read)["sheets"]["Failures"].size() == campaign.tests.size() + 1);
  }
  CHECK_THROWS_AS(write_campaign_xlsx(folder.path() / "none/campaign.xlsx", no_tests()), InputError);
}
