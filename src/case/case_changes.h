// Changes of a case from the command line: `--set rig.stiffness="90 N/m"`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

namespace flexslip {

// The key of a change, "rig.stiffness".
// Fails:      InputError for a text that is no change, or an unknown key.
std::string changed_key(std::string_view change);

// The TOML text of a case with changes from the command line, made in order: "rig.stiffness=90 N/m"
// is the same as `stiffness = "90 N/m"` under [rig]. Text needs no quotes.
// Fails:      InputError for a text that is no change, an unknown key, or an empty value.
toml::table with_changes(toml::table table, const std::vector<std::string>& changes);

}  // namespace flexslip
