// Changes of a case from the command line: `--set rig.stiffness="90 N/m"`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

namespace flexslip {

// The key that a change names, "rig.stiffness".
// Fails:      InputError for a text that is no change, or whose key no case file has.
std::string changed_key(std::string_view change);

// A case with changes from the command line, each made in turn: "rig.stiffness=90 N/m" says what `stiffness = "90 N/m"` under [rig] would. A value is what
// it would be in a file; text needs no quotes, so that those of a shell will do.
// Fails:      InputError for a text that is no change, a key that no case file has, and a value that is nothing.
toml::table with_changes(toml::table table, const std::vector<std::string>& changes);

}  // namespace flexslip
