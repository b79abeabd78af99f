// Everything that a campaign shows, in one folder.
#pragma once

#include <string>

#include "campaign/campaign.h"
#include "io/call_files.h"
#include "report/figure.h"

namespace flexslip {

// What the functions below write, named by an option. The folder is FlexSlip's own: what lies in it may be replaced or removed, and is no input of
// the next run.
// Fails:      as CallFiles::writes.
void announce_campaign_report(CallFiles& files, const std::string& folder, const std::string& option);

// Writes into <folder>, which is made if it is not there; files of the same names are replaced:
//   report.html                   needs no other file; links to tests/<name>/report.html where that exists
//   tests.csv, categories.csv, campaign.json, campaign.xlsx, tables.tex
//   figures/                      distributions and atlas pages as SVG, PDF and PNG, with their scripts and data
// Fails:      as draw(); InputError if a file cannot be written. Without gnuplot the report has no pictures and says so.
DrawStatus write_campaign_report(const std::string& folder, const Campaign& campaign);

// The files of one test into a folder that is there: its answer as JSON, curves and profile, and its report if that is wanted.
// Fails:      as draw(); InputError if a file cannot be written.
void write_campaign_test(const std::string& folder, const FittedTest& test, bool with_report);

// The tables alone, without report and figures.
void write_campaign_tables(const std::string& folder, const Campaign& campaign);

}  // namespace flexslip
