#include "case/case_changes.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "case/case_keys.h"
#include "case/toml.h"
#include "io/input_error.h"
#include "io/text.h"

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
    case Holds::name_or_number:
    case Holds::title:
    case Holds::file:
      return true;
    default:
      return value == "inf";  // a number of TOML, and the word of a rig
  }
}

std::string full_name(const CaseKey& key) {
  return key.section.empty() ? std::string(key.name) : fmt::format("{}.{}", key.section, key.name);
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
  const bool is_whole = dot != 0 && !name.ends_with('.');
  const bool has_keys = section == "friction.other" || section == "sweep.axes" || section.find('.') == section.npos;
  if (is_whole && has_keys && case_key(section, name.substr(dot + 1))) return std::string(name);  // npos + 1 is 0
  std::vector<std::string> known;
  for (const CaseKey& key : case_keys())
    if (key.section.find('.') == key.section.npos)
      known.push_back(full_name(key));  // those of arrays change as a whole
  const auto same =
      std::find_if(case_keys().begin(), case_keys().end(), [&](const CaseKey& key) { return key.name == name; });
  const std::string meant = same != case_keys().end() ? full_name(*same) : nearest(name, known);
  throw no_change(in_quotes(name),
                  meant.empty() ? "flexslip keys lists the keys" : fmt::format("did you mean {}?", in_quotes(meant)));
}

toml::table with_changes(toml::table table, const std::vector<std::string>& changes) {
  for (const std::string& change : changes) {
    const std::string name = changed_key(change);
    const std::string value(trimmed(std::string_view(change).substr(change.find('=') + 1)));
    if (value.empty()) throw no_change(in_quotes(change), "write a value after the =");
    const std::size_t dot = std::min(name.rfind('.'), name.size());
    toml::table* section = &table;
    for (std::size_t at = 0; at < dot && dot < name.size();) {
      const std::size_t end = std::min(name.find('.', at), dot);
      const std::string part = name.substr(at, end - at);
      if (!(*section)[part].is_table()) section->insert_or_assign(part, toml::table{});
      section = (*section)[part].as_table();
      at = end + 1;
    }
    const bool is_top = dot == name.size();
    const std::string last = is_top ? name : name.substr(dot + 1);
    insert(*section, last, *case_key(is_top ? "" : name.substr(0, dot), last), value);
  }
  return table;
}

}  // namespace flexslip
