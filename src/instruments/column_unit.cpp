#include "instruments/column_unit.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "io/input_error.h"
#include "io/text.h"

namespace flexslip {
namespace {

struct Spelling {
  std::string_view text;  // in lower case
  std::string_view unit;  // as parse_unit wants it
};

constexpr std::array spellings{Spelling{"secs", "s"},      Spelling{"second", "s"},      Spelling{"seconds", "s"},
                               Spelling{"sekunden", "s"},  Spelling{"sek", "s"},         Spelling{"sec.", "s"},
                               Spelling{"sec", "s"},       Spelling{"秒", "s"},          Spelling{"mins", "min"},
                               Spelling{"minutes", "min"}, Spelling{"millimeter", "mm"}, Spelling{"millimetre", "mm"},
                               Spelling{"meter", "m"},     Spelling{"metre", "m"},       Spelling{"inch", "in"},
                               Spelling{"inches", "in"},   Spelling{"micrometer", "um"}, Spelling{"micrometre", "um"},
                               Spelling{"newton", "N"},    Spelling{"newtons", "N"},     Spelling{"lb", "lbf"},
                               Spelling{"lbs", "lbf"},     Spelling{"in.", "in"}};

constexpr double gravity = 9.80665;  // [m/s^2] standard, exact by definition
constexpr Unit kilogram_force{kind::force.dimension, 0, gravity};
constexpr Unit gram_force{kind::force.dimension, -3, gravity};

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

}  // namespace

std::optional<Unit> machine_unit(std::string_view text) {
  std::string_view body = trimmed(text);
  const std::string small = lower(body);
  if (small == "kgf" || small == "kp") return kilogram_force;
  if (small == "gf" || small == "p") return gram_force;
  for (const Spelling& each : spellings)
    if (each.text == small) body = each.unit;
  if (body.empty() || body.size() > 24) return std::nullopt;  // longer ones are prose
  try {
    return parse_unit(body);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

bool is_voltage(std::string_view text) {
  const std::string_view body = trimmed(text);
  const std::string small = lower(body);
  return body == "V" || body == "mV" || body == "uV" || body == "\u00b5V" || small == "volt" || small == "volts";
}

double volts_in(std::string_view text) {
  const std::string_view body = trimmed(text);
  return body == "mV" ? 1e-3 : body == "uV" || body == "\u00b5V" ? 1e-6 : 1;
}

bool names_a_unit(std::string_view text) {
  const std::string_view body = without_brackets(trimmed(text));
  return body == "-" || body == "1" || is_voltage(body) || machine_unit(body);
}

}  // namespace flexslip
