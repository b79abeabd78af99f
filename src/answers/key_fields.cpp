#include "answers/key_fields.h"

#include <optional>

namespace flexslip {

Fields<CaseKey> key_fields() {
  const auto text = [](std::string_view CaseKey::*part) {
    return [part](const CaseKey& key) { return (key.*part).empty() ? std::nullopt : std::optional(key.*part); };
  };
  return Fields<CaseKey>()
      .words("section", "of the case file", &CaseKey::section)
      .words("name", "of the key", &CaseKey::name)
      .words("holds", "what it takes", what_holds)
      .words("example", "of its value", text(&CaseKey::example))
      .words("reduced", "example of its value in a reduced case", text(&CaseKey::reduced))
      .words("flag", "that says the same on the command line", text(&CaseKey::flag))
      .words("meaning", "in a few words", &CaseKey::meaning)
      .words("more", "that follows the meaning on the page of case files", &CaseKey::more);
}

}  // namespace flexslip
