#include "answers/key_fields.h"

#include <optional>

namespace flexslip {

Fields<CaseKey> key_fields() {
  const auto text = [](std::string_view CaseKey::*part) {
    return [part](const CaseKey& key) { return (key.*part).empty() ? std::nullopt : std::optional(key.*part); };
  };
  return Fields<CaseKey>()
      .words("section", "section of the case file", &CaseKey::section)
      .words("name", "name of the key", &CaseKey::name)
      .words("holds", "values that the key takes", what_holds)
      .words("example", "example of a value", text(&CaseKey::example))
      .words("reduced", "example of a value in a reduced case", text(&CaseKey::reduced))
      .words("flag", "flag that says the same on the command line", text(&CaseKey::flag))
      .words("meaning", "meaning of the key", &CaseKey::meaning)
      .words("more", "text that follows the meaning on the page of case files", &CaseKey::more);
}

}  // namespace flexslip
