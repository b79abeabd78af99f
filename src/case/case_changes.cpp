#include "case/case_changes.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "case/case_keys.h"
#include "case/toml.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

InputError no_change(std::string found, std::string remedy) {
  return InputError({.field = "--set",
                     .expected = "SECTION.KEY=VALUE, as in rig.stiffness=\"90 N/m\"",
                     .found = std::move(found),
                     .remedy = std::move(remedy)});
}

bool is_text(const CaseKey& key, std::string_view value) {
  if (value.starts_with('"') || value.starts_with('\'')) return false;  // as a file has it
  switch (key.holds) {
    case Holds::word:
    case Holds::text:
    case Holds::title:
    case Holds::file:
      return true;
    default:
      return value == "inf";  // a number of TOML, and the word of a rig
  }
}

// As TOML reads it, or else text.
void insert(toml::table& section, const std::string& name, const CaseKey& key, const std::string& value) {
  if (!is_text(key, value)) try {
      toml::table parsed = parse_toml(fmt::format("value = {}\n", value), "--set");
      section.insert_or_assign(name, std::move(*parsed.get("value")));
      return;
    } catch (const InputError&) {
    }
  section.insert_or_assign(name, value);
}

}  // namespace

std::string changed_key(std::string_view change) {
  const std::size_t equals = change.find('=');
  if (equals == std::string_view::npos) throw no_change(in_quotes(change), "");
  const std::string_view name = trimmed(change.substr(0, equals));
  const std::size_t dot = name.rfind('.');
  const std::string_view section = name.substr(0, dot == std::string_view::npos ? 0 : dot);
  const bool is_known = dot != std::string_view::npos &&
                        (section == "friction.other" || section.find('.') == section.npos) &&
                        case_key(section, name.substr(dot + 1));
  if (is_known) return std::string(name);
  std::vector<std::string> known;
  for (const CaseKey& key : case_keys()) known.push_back(fmt::format("{}.{}", key.section, key.name));
  const auto same =
      std::find_if(case_keys().begin(), case_keys().end(), [&](const CaseKey& key) { return key.name == name; });
  const std::string meant =
      same != case_keys().end() ? fmt::format("{}.{}", same->section, name) : nearest(name, known);
  throw no_change(in_quotes(name),
                  meant.empty() ? "flexslip keys lists the keys" : fmt::format("did you mean {}?", in_quotes(meant)));
}

toml::table with_changes(toml::table table, const std::vector<std::string>& changes) {
  for (const std::string& change : changes) {
    const std::string name = changed_key(change);
    const std::string value(trimmed(std::string_view(change).substr(change.find('=') + 1)));
    if (value.empty()) throw no_change(in_quotes(change), "write a value after the =");
    const std::size_t dot = name.rfind('.');
    toml::table* section = &table;
    for (std::size_t at = 0; at < dot;) {
      const std::size_t end = std::min(name.find('.', at), dot);
      const std::string part = name.substr(at, end - at);
      if (!(*section)[part].is_table()) section->insert_or_assign(part, toml::table{});
      section = (*section)[part].as_table();
      at = end + 1;
    }
    insert(*section, name.substr(dot + 1), *case_key(name.substr(0, dot), name.substr(dot + 1)), value);
  }
  return table;
}

}  // namespace flexslip
