// Reports: of a fitted test, as one HTML file with its figures; and of a campaign, as a folder.
#pragma once

#include <optional>
#include <string>

#include "campaign/campaign.h"
#include "campaign/campaign_run.h"
#include "case/fitted.h"
#include "io/call_files.h"
#include "io/table.h"
#include "report/draw.h"

namespace flexslip {

// Announces the files of a report with its studio page, requested by an option. The folder of
// figures belongs to FlexSlip.
// Fails:      as CallFiles::writes.
void announce_report(CallFiles& files, const std::string& folder, const std::string& option);

// Writes <folder>/report.html, which is self-contained, and <folder>/figures/ with each figure as
// SVG, PDF, PNG, script and data. Creates the folder and replaces files of the same names. The
// report links to the page `studio`, if given, and bears the date of today, or of
// SOURCE_DATE_EPOCH. Figures are at most figure_width [mm] wide.
// Domain:     figure_width as in_width (report/plot.h), here and below.
// Fails:      as draw(); the report names missing pictures with the reason.
Drawing write_report(const std::string& folder, const FittedTest& test, double figure_width = two_columns,
                     const std::string& studio = "");

// The same, with a studio page that contains the test, if a built page exists
// (report/studio_page.h) and the record is a file.
// Fails:      as write_report and write_studio_page.
Drawing write_report_with_studio(const std::string& folder, const FittedTest& test, double figure_width = two_columns);

// Announces the files of the functions below, requested by an option. The folder belongs to
// FlexSlip: its files may be replaced or removed, and the next run does not read them as input.
// Fails:      as CallFiles::writes.
void announce_campaign_report(CallFiles& files, const std::string& folder, const std::string& option);

// Creates the folder and stores there each finished test: answer as JSON, curves, profile, and on
// request its report.
// Fails:      throws InputError if the folder cannot be created; during the run as draw(), and
//             InputError if a file cannot be written.
void keep_tests_in(const std::string& folder, bool with_reports, CampaignOptions& options,
                   double figure_width = two_columns, const CsvMarks& marks = {});

// Writes into the folder, replacing files of the same names:
//   report.html   self-contained; with links to existing tests/<name>/report.html
//   tests.csv, categories.csv, specimens.csv, campaign.json, campaign.xlsx
//   figures/      distributions and atlas pages as SVG, PDF and PNG, with scripts and data, at most
//                 figure_width [mm] wide
// Without a width, only the tables.
// Fails:      as draw(); throws InputError if a file cannot be written. The report names missing
//             pictures with the reason.
Drawing write_campaign_report(const std::string& folder, const Campaign& campaign,
                              std::optional<double> figure_width = two_columns, const CsvMarks& marks = {});

}  // namespace flexslip
