// Reports: of a fitted test, one HTML file to read, print and hand on, with its figures beside it for journals; and of a campaign, in one folder.
#pragma once

#include <string>

#include "campaign/campaign.h"
#include "campaign/campaign_run.h"
#include "case/fitted.h"
#include "io/call_files.h"
#include "report/draw.h"

namespace flexslip {

// What a report with its studio writes, named by an option. The figures' folder is FlexSlip's own.
// Fails:      as CallFiles::writes.
void announce_report(CallFiles& files, const std::string& folder, const std::string& option);

// Writes <folder>/report.html, which needs no other file, and <folder>/figures/: every figure as SVG, PDF and PNG with its gnuplot
// script and data. The folder is made if it is not there; files of the same names are replaced.
// It links to a studio page beside it, where one is named, and says of what day it is (that of SOURCE_DATE_EPOCH, where it is set).
// Fails:      as draw(); the report says which pictures are missing, and why.
Drawing write_report(const std::string& folder, const FittedTest& test, const std::string& studio = "");

// The same with the studio beside it, the test inside: where there is a built page (report/studio_page.h) and the record is a file.
// Fails:      likewise, and as write_studio_page().
Drawing write_report_with_studio(const std::string& folder, const FittedTest& test);

// What the functions below write, named by an option. The folder is FlexSlip's own: what lies in it may be replaced or removed, and is no input of
// the next run.
// Fails:      as CallFiles::writes.
void announce_campaign_report(CallFiles& files, const std::string& folder, const std::string& option);

// Has each test of a run kept in the folder as soon as it is done, with its answer as JSON, its curves and its profile and, if that is wanted, its
// report. Makes the folder.
// Fails:      InputError if it cannot be made; in the run as draw(), and InputError if a file cannot be written.
void keep_tests_in(const std::string& folder, bool with_reports, CampaignOptions& options);

// Writes into the folder; files of the same names are replaced:
//   report.html                   needs no other file; links to tests/<name>/report.html where that exists
//   tests.csv, categories.csv, specimens.csv, campaign.json, campaign.xlsx
//   figures/                      distributions and atlas pages as SVG, PDF and PNG, with their scripts and data
// Without figures the tables alone.
// Fails:      as draw(); InputError if a file cannot be written. The report says which pictures are missing, and why.
Drawing write_campaign_report(const std::string& folder, const Campaign& campaign, bool with_figures = true);

}  // namespace flexslip
