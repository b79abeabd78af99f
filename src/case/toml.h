// TOML text to a table of toml++, whatever the text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <toml++/toml.h>

namespace flexslip {

// Domain:     keys, numbers and one-line texts, as case files have them: no dates, no multi-line texts.
// Fails:      InputError with file and line for anything else.
toml::table parse_toml(std::string_view text, const std::string& source);

// "90.65 N/m" and "0.3 %" of "90.65 N/m ± 0.3 %"; none of a text without an uncertainty.
std::optional<std::pair<std::string_view, std::string_view>> value_and_uncertainty(std::string_view text);

// The table of this name in another. What stands there and is none becomes its "value", as of a quantity that is to have an uncertainty.
toml::table& table_at(toml::table& parent, std::string_view name);

// A text in quotes, as such a file has it.
std::string toml_text(std::string_view text);

}  // namespace flexslip
