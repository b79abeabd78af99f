#include "instruments/trace_words.h"

#include "instruments/export_words.h"
#include "io/input_error.h"
#include "io/quantity.h"

namespace flexslip {

TraceOptions options_of(const TraceWords& words) {
  TraceOptions options;
  ExportWords of_file;
  of_file.sheet = words.sheet;
  of_file.sheet_number = words.sheet_number;
  of_file.encoding = words.encoding;
  of_file.separator = words.separator;
  of_file.decimal = words.decimal;
  of_file.thousands = words.thousands;
  options.file = options_of(of_file);
  options.position = words.position;
  options.height = words.height;
  options.position_unit = words.position_unit;
  options.height_unit = words.height_unit;
  if (!words.step.empty()) try {
      options.step = parse_quantity(words.step, kind::length, Range::positive);
    } catch (const InputError& error) {
      throw located(error, "", 0, "--step");
    }
  return options;
}

}  // namespace flexslip
