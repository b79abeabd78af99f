#include "case/case_changes.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "case/case_keys.h"
#include "case/toml.h"
#include "io/input_error.h"
#include "io/text.h"

namespace flexslip {
namespace {

InputError no_change(std::string problem, std::string remedy) {
  return InputError({.field = "--set", .problem = std::move(problem), .remedy = std::move(remedy)});
}

std::string full_name(const CaseKey& key) {
  return key.section.empty() ? std::string(key.name) : fmt::format("{}.{}", key.section, key.name);
}

constexpr std::string_view of_uncertainty = ".uncertainty";

// The key "rig.stiffness", also from "rig.stiffness.uncertainty". nullptr for other names.
const CaseKey* named_key(std::string_view name) {
  if (name.ends_with(of_uncertainty)) {
    const CaseKey* key = named_key(name.substr(0, name.size() - of_uncertainty.size()));
    return key && key->holds == Holds::estimate ? key : nullptr;
  }
  const std::size_t dot = name.rfind('.');
  return case_key(name.substr(0, dot == name.npos ? 0 : dot), name.substr(dot + 1));  // npos + 1 is 0
}

}  // namespace

std::string changed_key(std::string_view change) {
  const std::size_t equals = change.find('=');
  if (equals == std::string_view::npos)
    throw no_change(fmt::format("{} has no =", in_quotes(change)),
                    "write SECTION.KEY=VALUE, as in rig.stiffness=\"90 N/m\"");
  const std::string_view name = trimmed(change.substr(0, equals));
  const std::size_t dot = name.rfind('.');
  const std::string_view section = name.substr(0, dot == std::string_view::npos ? 0 : dot);
  const bool is_whole = dot != 0 && !name.ends_with('.');
  const bool has_keys = section == "friction.other" || section == "sweep.axes" || section.find('.') == section.npos ||
                        name.ends_with(of_uncertainty);
  if (is_whole && has_keys && named_key(name)) return std::string(name);
  std::vector<std::string> known;
  for (const CaseKey& key : case_keys())
    if (key.section.find('.') == key.section.npos) known.push_back(full_name(key));  // arrays change as a whole
  const auto same =
      std::find_if(case_keys().begin(), case_keys().end(), [&](const CaseKey& key) { return key.name == name; });
  throw no_change(
      fmt::format("No key is called {}", in_quotes(name)),
      did_you_mean(same != case_keys().end() ? full_name(*same) : name, known, "see flexslip keys for the list"));
}

namespace {

bool is_text(const CaseKey& key, std::string_view value) {
  if (value.starts_with('"') || value.starts_with('\'')) return false;  // as in a file
  switch (key.holds) {
    case Holds::word:
    case Holds::text:
    case Holds::name_or_number:
    case Holds::title:
    case Holds::file:
      return true;
    default:
      return value == "inf";  // a number in TOML, and a word of the rig
  }
}

// As TOML reads it, otherwise text.
void insert(toml::table& section, const std::string& name, const CaseKey& key, const std::string& value) {
  if (!is_text(key, value)) try {
      toml::table parsed = parse_toml(fmt::format("value = {}\n", value), "--set");
      section.insert_or_assign(name, std::move(*parsed.get("value")));
      return;
    } catch (const InputError&) {
    }
  section.insert_or_assign(name, value);
}

// Stated rollers replace the edges of the case, and vice versa.
void make_room_for(const std::vector<std::string>& changed, toml::table& table) {
  toml::table* rig = table["rig"].as_table();
  const auto is_changed = [&](std::string_view key) {
    return std::find(changed.begin(), changed.end(), fmt::format("rig.{}", key)) != changed.end();
  };
  if (!rig || is_changed("supports") == is_changed("roller_radius")) return;
  const auto supports = (*rig)["supports"].value<std::string_view>();
  if (is_changed("roller_radius") && supports == "edges") rig->erase("supports");
  if (!is_changed("supports") || supports != "edges") return;
  for (const std::string_view key : {"roller_radius", "rollers", "pin_radius", "pin_friction"})
    if (!is_changed(key)) rig->erase(key);
}

}  // namespace

toml::table with_changes(toml::table table, const std::vector<std::string>& changes) {
  std::vector<std::string> changed;
  for (const std::string& change : changes) {
    const std::string name = changed_key(change);
    const std::string value(trimmed(std::string_view(change).substr(change.find('=') + 1)));
    if (value.empty()) throw no_change(fmt::format("{} has no value", in_quotes(change)), "write a value after the =");
    const std::size_t dot = std::min(name.rfind('.'), name.size());
    toml::table* section = &table;
    for (std::size_t at = 0; at < dot && dot < name.size();) {
      const std::size_t end = std::min(name.find('.', at), dot);
      const std::string part = name.substr(at, end - at);
      section = &table_at(*section, part);
      at = end + 1;
    }
    const bool is_top = dot == name.size();
    const std::string last = is_top ? name : name.substr(dot + 1);
    insert(*section, last, *named_key(name), value);
    changed.push_back(name);
  }
  make_room_for(changed, table);
  return table;
}

}  // namespace flexslip
