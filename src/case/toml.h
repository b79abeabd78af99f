// Safe conversion of any text to a TOML table of toml++.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <toml++/toml.h>

namespace flexslip {

// Domain:     keys, numbers and one-line texts; no dates, no multi-line texts.
// Fails:      InputError with file and line for other content.
toml::table parse_toml(std::string_view text, const std::string& source);

// "90.65 N/m" and "0.3 %" of "90.65 N/m ± 0.3 %"; empty for a text without an uncertainty. A unit that
// one number has also counts for the other: "1 ± 0.05 mm".
std::optional<std::pair<std::string, std::string>> value_and_uncertainty(std::string_view text);

// The subtable with a name. Another value there becomes its "value", as for a quantity that gets an
// uncertainty.
toml::table& table_at(toml::table& parent, std::string_view name);

// A text in quotes, in the notation of TOML.
std::string toml_text(std::string_view text);

}  // namespace flexslip
