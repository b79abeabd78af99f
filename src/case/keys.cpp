#include "case/keys.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "io/call_files.h"
#include "io/table.h"

namespace flexslip {

std::string kind_of_node(const toml::node& node) {
  if (const auto text = node.value_exact<std::string_view>()) return in_quotes(*text);
  if (const auto number = node.value_exact<double>()) return fmt::format("the number {}", *number);
  if (const auto number = node.value_exact<std::int64_t>()) return fmt::format("the number {}", *number);
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (node.is_boolean()) return "true or false";
  return "a date or time";
}

Keys::Keys(const toml::table& table, std::string path, const Case& input)
    : table_(table), path_(std::move(path)), input_(input) {}

std::string Keys::key(std::string_view name) const {
  return path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name);
}

void Keys::only(const std::vector<std::string>& known) const {
  for (auto&& [name, value] : table_) {
    if (std::find(known.begin(), known.end(), name.str()) != known.end()) continue;
    const std::string meant = nearest(name.str(), known);
    const CaseKey* described = case_key(path_, name.str());
    const bool is_elsewhere = described && described->name == name.str();  // of another model, in this section
    const std::string expected = (known.size() == 1 ? "no other key than " : "one of the keys ") + listed(known);
    InputFault fault =
        wrong_value(input_, key(name.str()), expected, is_elsewhere ? "a key without meaning here" : "an unknown key",
                    is_elsewhere    ? "leave it out"
                    : meant.empty() ? "expected " + expected
                                    : "did you mean " + in_quotes(meant) + "?")
            .fault;
    fault.kind = FaultKind::unknown;
    fault.problem = is_elsewhere ? "has no meaning here" : "is an unknown key";
    throw InputError(std::move(fault));
  }
}

void Keys::only_described() const {
  std::vector<std::string> known;
  for (const CaseKey& key : case_keys())
    if (case_key(path_, key.name) == &key) known.emplace_back(key.name);
  only(known);
}

const CaseKey& Keys::described(std::string_view name) const {
  const CaseKey* key = case_key(path_, name);
  if (!key) throw std::invalid_argument(fmt::format("no key {} is described", this->key(name)));
  return *key;
}

const toml::node& Keys::need(std::string_view name) const {
  if (const toml::node* node = find(name)) return *node;
  throw missing(input_, key(name));
}

double Keys::quantity(std::string_view name, const Kind& kind, Range range) const {
  return value(need(name), key(name), kind, range);
}

double Keys::quantity(std::string_view name) const {
  const CaseKey& key = described(name);
  return at_most(quantity(name, *key.kind, key.range), name);
}

double Keys::at_most(double value, std::string_view name) const {
  const CaseKey* key = case_key(path_, name);
  if (!key || !(value > key->most)) return value;
  InputError error = wrong_value(input_, this->key(name), fmt::format("at most {:g}", key->most),
                                 fmt::format("{}", value), std::string(key->why_most));
  error.fault.kind = FaultKind::too_much;
  error.fault.limit = key->most;
  throw error;
}

std::optional<double> Keys::optional_quantity(std::string_view name) const {
  return has(name) ? std::optional(quantity(name)) : std::nullopt;
}

std::uint64_t Keys::whole_number(std::string_view name) const { return whole_number(name, described(name).least); }

std::string Keys::word(std::string_view name) const {
  const auto known = words_of(described(name));
  for (const std::string_view each : known)
    if (is_word(name, each)) return std::string(each);
  refuse_word(name, known);
}

std::uint64_t Keys::whole_number(std::string_view name, std::int64_t least) const {
  const toml::node& node = need(name);
  const auto value = node.value<std::int64_t>();  // of 1e5, too
  if (!node.is_number() || !value || *value < least)
    refuse(name, fmt::format("a whole number, at least {}", least), kind_of_node(node));
  return static_cast<std::uint64_t>(*value);
}

std::string Keys::text(std::string_view name) const {
  const toml::node& node = need(name);
  const auto value = node.value_exact<std::string>();
  if (!value || value->empty()) refuse(name, "text in quotes", kind_of_node(node));
  return *value;
}

std::variant<std::string, std::size_t> Keys::name_or_number(std::string_view name) const {
  if (need(name).is_number()) return static_cast<std::size_t>(whole_number(name, 1));
  return text(name);
}

bool Keys::is_word(std::string_view name, std::string_view word) const {
  const toml::node* node = find(name);
  return node && node->value_exact<std::string_view>() == word;
}

std::string Keys::column(std::string_view name) const {
  const Kind& kind = *described(name).kind;
  std::string title = text(name);
  try {
    const ColumnTitle parts = parse_column_title(title);
    if (!parts.unit.empty()) parse_unit(parts.unit, kind_in(input_, kind));
  } catch (const InputError& error) {
    throw placed(error, key(name));
  }
  return title;
}

std::string Keys::path(std::string_view name) const {
  const std::string file = text(name);
  std::string path = file == "-" ? file : (std::filesystem::path(input_.source).parent_path() / file).string();
  announce_input(path);  // now, though it may be read only after others were written
  return path;
}

StatedStiffness Keys::estimate(std::string_view name) const {
  const auto& [kind, range] = std::pair(*described(name).kind, described(name).range);
  const toml::node& node = need(name);
  if (const toml::table* parts = node.as_table()) {
    const Keys keys(*parts, key(name), input_);
    keys.only({"value", "uncertainty"});
    Known known{keys.quantity("value", kind, range), 0};
    known.uncertainty = keys.uncertainty(known.value, kind);
    return known;
  }
  if (node.value_exact<std::string_view>() == "fit") return ToFit{};
  return Known{value(node, key(name), kind, range), 0};
}

bool Keys::is_in_unit(std::string_view name, std::string_view symbol) const {
  const toml::node* node = find(name);
  const auto text = node ? node->value_exact<std::string_view>() : std::nullopt;
  if (!text || !text->ends_with(symbol)) return false;
  const std::string_view number = text->substr(0, text->size() - symbol.size());
  return !number.empty() && (number.back() == ' ' || (number.back() >= '0' && number.back() <= '9'));
}

double Keys::value(const toml::node& node, const std::string& key, const Kind& kind, Range range) const {
  const auto text = node.value_exact<std::string_view>();
  const bool is_number = node.is_number();
  if (!text && !is_number) throw wrong_value(input_, key, std::string(kind.name), kind_of_node(node));
  const bool is_plain = kind.dimension == Dimension{} || (input_.reduced && kind.dimension != kind::angle.dimension);
  try {
    if (is_number && is_plain) {
      const double plain = node.value<double>().value_or(0);
      return within(range, plain, fmt::format("{}", plain), kind);
    }
    if (is_number) return parse_quantity(fmt::format("{}", node.value<double>().value_or(0)), kind, range);
    if (is_plain && !(*text == "inf" && range == Range::positive_or_infinite))
      throw InputError({.expected = "a plain number",
                        .found = in_quotes(*text),
                        .remedy = kind.dimension == Dimension{} ? "write it without quotes and without a unit"
                                                                : "the case is reduced: write it in reduced variables, "
                                                                  "without quotes and unit, or delete reduced = true"});
    return parse_quantity(*text, kind, range);
  } catch (const InputError& error) {
    throw placed(error, key);
  }
}

void Keys::refuse(std::string_view name, std::string expected, std::string found, std::string remedy) const {
  throw wrong_value(input_, key(name), std::move(expected), std::move(found), std::move(remedy));
}

InputError Keys::placed(const InputError& error, const std::string& key) const {
  const InputFault place = wrong_value(input_, key, "", "", "").fault;
  InputFault fault = error.fault;
  fault.file = place.file;
  fault.line = place.line;
  fault.field = place.field;
  fault.key = place.key;
  return InputError(std::move(fault));
}

std::vector<Keys> Keys::tables(std::string_view name, const std::vector<std::string>& known) const {
  const toml::node& node = need(name);
  const toml::array* several = node.as_array();
  if (!several || several->empty())
    refuse(name, fmt::format("an array of {}", name), several ? "an empty one" : kind_of_node(node));
  std::vector<Keys> tables;
  for (std::size_t i = 0; i < several->size(); ++i) {
    const std::string path = fmt::format("{}[{}]", key(name), i + 1);
    const toml::table* table = (*several)[i].as_table();
    if (!table)
      throw wrong_value(input_, path, fmt::format("{{ {} = … }}", fmt::join(known, " = …, ")),
                        kind_of_node((*several)[i]));
    tables.emplace_back(*table, path, input_);
    tables.back().only(known);
  }
  return tables;
}

double Keys::share(std::string_view name) const {
  const auto text = need(name).value_exact<std::string_view>();
  if (!text || text->find('%') == std::string_view::npos)
    return at_most(quantity(name, kind::number, Range::positive), name);
  try {
    return at_most(parse_quantity(*text, kind::number, Range::positive), name);
  } catch (const InputError& error) {
    throw placed(error, key(name));
  }
}

double Keys::uncertainty(double value_of_it, const Kind& kind) const {
  const toml::node& node = need("uncertainty");
  const auto text = node.value_exact<std::string_view>();
  const bool is_share = text && text->find('%') != std::string_view::npos;
  return is_share ? value_of_it * share("uncertainty") : value(node, key("uncertainty"), kind, Range::positive);
}

void Keys::refuse_word(std::string_view name, const std::vector<std::string_view>& known) const {
  std::string expected;
  for (std::size_t i = 0; i < known.size(); ++i)
    expected += fmt::format("{}\"{}\"", i == 0 ? "" : i + 1 < known.size() ? ", " : " or ", known[i]);
  const auto word = need(name).value_exact<std::string>();
  const std::string meant = nearest(word.value_or(""), {known.begin(), known.end()});
  refuse(name, expected, kind_of_node(need(name)), meant.empty() ? "" : fmt::format("did you mean \"{}\"?", meant));
}

}  // namespace flexslip
