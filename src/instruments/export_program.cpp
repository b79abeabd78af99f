#include "instruments/export_program.h"

#include <string_view>

#include "io/text.h"

namespace flexslip {
namespace {

bool has_word(std::string_view text, std::string_view word) { return text.find(word) != std::string_view::npos; }

}  // namespace

std::string program_of(const Export& file, bool has_bracketed_units) {
  std::string titles;
  for (const ExportColumn& column : file.specimens.front().columns) titles += folded(column.name) + "|";
  std::string preamble;
  for (const Metadatum& datum : file.metadata) preamble += folded(datum.name) + "|";
  if (has_word(preamble, "mts793")) return "MTS 793";
  if (has_word(preamble, "file path") && has_word(preamble, "test run")) return "MTS TestSuite";
  for (const std::string_view word :
       {"standardkraft", "standardweg", "force standard", "course standard", "standard force", "standard travel"})
    if (has_word(titles, word)) return "Zwick testXpert";
  if (file.encoding == Encoding::shift_jis || has_word(titles, "試験力") || has_word(titles, "ストローク"))
    return "Shimadzu Trapezium";
  if (has_word(titles, "setname|cycle")) return "CellScale";
  if (has_word(titles, "run #")) return "PASCO Capstone";
  const bool bluehill_names = has_word(titles, "time|") &&
                              (has_word(titles, "extension|") || has_word(titles, "displacement|")) &&
                              (has_word(titles, "load|") || has_word(titles, "force|"));
  if (bluehill_names && (has_bracketed_units || has_word(preamble, "raw data") || has_word(preamble, "results table")))
    return "Instron Bluehill";
  return "table";
}

}  // namespace flexslip
