#include "case/keys.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "case/toml.h"
#include "io/call_files.h"
#include "io/table.h"
#include "io/text.h"

namespace flexslip {

namespace {

// The error of a value, with the place of its key.
InputError placed(const Test& test, const InputError& error, const std::string& key) {
  const InputFault place = wrong_value(test, key, "").fault;
  InputFault fault = error.fault;
  fault.file = place.file;
  fault.line = place.line;
  fault.field = place.field;
  fault.key = place.key;
  return InputError(std::move(fault));
}

// Reads the value of a key into a member of a test, for each type of member.
struct Reader {
  const Keys& keys;
  const Test& test;
  const CaseKey& key;

  const toml::node& node() const { return keys.need(key.name); }
  std::string path() const { return keys.key(key.name); }
  [[noreturn]] void refuse(std::string expected, std::string remedy = "") const {
    keys.refuse(key.name, fmt::format("{} is not {}", kind_of_node(node()), expected), std::move(remedy));
  }
  bool is_word(std::string_view word) const { return node().value_exact<std::string_view>() == word; }
  std::string text() const {
    const auto value = node().value_exact<std::string>();
    if (!value || value->empty()) refuse("text in quotes");
    return *value;
  }
  double quantity() const { return keys.quantity(key.name, *key.kind, key.range); }

  void operator()(double& value) const {
    value = key.holds == Holds::share ? keys.share(key.name, key.range) : quantity();
    if (!(value > key.max)) return;
    InputError error = wrong_value(test, path(), fmt::format("The value {} is above the limit of {:g}", value, key.max),
                                   std::string(key.why_max));
    error.fault.kind = FaultKind::too_much;
    error.fault.limit = key.max;
    throw error;
  }
  void operator()(std::string& value) const {
    value = text();
    if (key.holds == Holds::file) {  // relative to the case file; from here on to the working directory
      if (value != "-") value = (std::filesystem::path(test.source).parent_path() / value).string();
      announce_input(value);  // now, although it may be read after other files were written
    }
    const bool names_one_of_export = key.section == "record" && !keys.has("stage") && !keys.has("deflection");
    if (key.holds != Holds::title || names_one_of_export) return;
    try {
      const ColumnTitle parts = parse_column_title(value);
      if (!parts.unit.empty()) parse_unit(parts.unit, kind_in(test, *key.kind));
    } catch (const InputError& error) {
      throw placed(test, error, path());
    }
  }
  void operator()(std::uint64_t& value) const { value = keys.whole_number(key.name, key.min); }
  void operator()(char& value) const {
    const auto known = words_of(key);
    value = known[keys.word(key.name, known)].front();
  }
  // { value = "90.65 N/m", uncertainty = "0.3 %" }, or both in one text, "90.65 N/m ± 0.3 %".
  void operator()(Known& known) const {
    toml::table of_text;
    const std::string_view whole = node().value_exact<std::string_view>().value_or("");
    if (const auto stated = value_and_uncertainty(whole)) {
      of_text.insert_or_assign("value", stated->first);
      of_text.insert_or_assign("uncertainty", stated->second);
    }
    const toml::table* parts = of_text.empty() ? node().as_table() : &of_text;
    if (!parts) {
      known = quantity();
      return;
    }
    const Keys both(*parts, path(), test);
    both.only({"value", "uncertainty"});
    known.value = both.quantity("value", *key.kind, key.range);
    const bool is_place = key.range == Range::any;  // a share of a position means nothing
    known.uncertainty = both.is_percent("uncertainty") && !is_place
                            ? known.value * both.share("uncertainty", Range::non_negative)
                            : both.quantity("uncertainty", *key.kind, Range::non_negative);
    if (is_place || (std::isfinite(known.value) && *known.uncertainty <= max_uncertainty * known.value)) return;
    const bool may_be_fitted = key.words == "fit";
    throw wrong_value(test, both.key("uncertainty"),
                      std::isfinite(known.value)
                          ? fmt::format("The uncertainty is {:.0f} % of the value, more than {:.0f} %",
                                        100 * *known.uncertainty / known.value, 100 * max_uncertainty)
                          : "An infinite value has no uncertainty",
                      may_be_fitted ? "write \"fit\" to find it from the initial slope" : "check both and their units");
  }
  void operator()(StatedStiffness& value) const {
    if (is_word("fit"))
      value = ToFit{};
    else
      (*this)(value.emplace<Known>());
  }
  void operator()(std::vector<double>& values) const {
    const toml::array* array = node().as_array();
    if (!array) refuse("at least two stage positions, a start and an end");
    for (std::size_t i = 0; i < array->size(); ++i)
      values.push_back(keys.value((*array)[i], fmt::format("{}[{}]", path(), i + 1), *key.kind, key.range));
  }
  void operator()(PlaceInRecord& place) const {
    if (const toml::table* table = node().as_table()) {
      const Keys parts(*table, path(), test);
      parts.only({"stage", "deflection"});
      if (parts.size() != 1)
        keys.refuse(key.name, fmt::format("A place is either a stage or a deflection, and {} stated",
                                          table->empty() ? "neither is" : "both are"));
      if (parts.has("stage"))
        place = AtStage{parts.quantity("stage", kind::length, Range::any)};
      else
        place = AtDeflection{parts.quantity("deflection", kind::length, Range::any)};
    } else if (node().is_string()) {
      const std::string row = text();
      if (!row.empty() && row.find_first_not_of("0123456789") == std::string::npos)
        keys.refuse(
            key.name,
            fmt::format("{} is neither a row without quotes nor a stage position with its unit", in_quotes(row)),
            fmt::format("write {} for that row", row));
      place = AtStage{keys.quantity(key.name, kind::length, Range::any)};
    } else {
      place = AtRow{static_cast<std::size_t>(keys.whole_number(key.name, 1))};
    }
  }
  void operator()(SheetChoice& sheet) const {
    if (node().is_number())
      sheet = static_cast<std::size_t>(keys.whole_number(key.name, 1));
    else
      sheet = text();
  }
  // A word leaves the quantity empty.
  void operator()(std::optional<double>& value) const {
    for (const std::string_view word : words_of(key))
      if (is_word(word)) return;
    (*this)(value.emplace());
  }
  template <class Word>
  void operator()(Word& value) const {
    if (!key.gone.empty() && is_word(key.gone)) refuse(what_holds(key), std::string(key.why_gone));
    value = static_cast<Word>(keys.word(key.name, words_of(key)));
  }
  template <class Word, class Number>
  void operator()(std::variant<Word, Number>& value) const {
    const auto known = words_of(key);
    for (std::size_t i = 0; i < known.size(); ++i)
      if (is_word(known[i])) {
        value = static_cast<Word>(i);
        return;
      }
    (*this)(value.template emplace<Number>());
  }
  template <class Row>
  void operator()(std::vector<Row>& rows) const {
    const toml::array* several = node().as_array();
    if (!several || several->empty())
      keys.refuse(key.name, fmt::format("This needs an array of {}, not {}", key.name,
                                        several ? "an empty one" : kind_of_node(node())));
    for (std::size_t i = 0; i < several->size(); ++i) {
      const std::string place = fmt::format("{}[{}]", path(), i + 1);
      const toml::table* table = (*several)[i].as_table();
      if (!table)
        throw wrong_value(test, place,
                          fmt::format("This needs a table, as in {}, not {}", test.reduced ? key.reduced : key.example,
                                      kind_of_node((*several)[i])));
      Keys(*table, place, test).read(&rows.emplace_back());
    }
  }
  template <class Value>
  void operator()(std::optional<Value>& value) const {
    (*this)(value.emplace());
  }
};

}  // namespace

std::string kind_of_node(const toml::node& node) {
  if (const auto text = node.value_exact<std::string_view>()) return in_quotes(*text);
  if (const auto number = node.value_exact<double>()) return fmt::format("the number {}", *number);
  if (const auto number = node.value_exact<std::int64_t>()) return fmt::format("the number {}", *number);
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (node.is_boolean()) return "true or false";
  return "a date or time";
}

Keys::Keys(const toml::table& table, std::string path, const Test& test)
    : table_(table), path_(std::move(path)), test_(test) {}

std::string Keys::key(std::string_view name) const {
  return path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name);
}

void Keys::only(const std::vector<std::string>& known) const {
  Faults faults;
  for (auto&& [name, value] : table_) {
    if (std::find(known.begin(), known.end(), name.str()) != known.end()) continue;
    const CaseKey* described = case_key(path_, name.str());
    const bool is_elsewhere = described && described->name == name.str();  // of another model in this section
    const std::string keys = (known.size() == 1 ? "the only key is " : "the keys are ") + listed(known);
    InputFault fault =
        wrong_value(test_, key(name.str()), is_elsewhere ? "This key has no meaning here" : "There is no such key",
                    is_elsewhere ? "leave it out" : did_you_mean(name.str(), known, keys))
            .fault;
    fault.kind = FaultKind::unknown;
    faults.add(InputError(std::move(fault)));
  }
  faults.raise();
}

void Keys::read(const TestPart& part) const {
  const auto is_there = [&](const CaseKey& key) { return !std::holds_alternative<std::monostate>(key.of(part)); };
  std::vector<std::string> known;
  for (const CaseKey& key : case_keys())
    if (is_there(key) || (key.section == path_ && !key.slot)) known.emplace_back(key.name);
  Faults faults;
  faults.note([&] { only(known); });
  for (const CaseKey& key : case_keys())
    faults.note([&] {
      if (has(key.name))
        std::visit(
            [&](auto member) {
              if constexpr (!std::is_same_v<decltype(member), std::monostate>) Reader{*this, test_, key}(*member);
            },
            key.of(part));
    });
  faults.raise();
  for (const CaseKey& key : case_keys())
    if (is_required(key.of(part))) faults.note([&] { need(key.name); });
  faults.raise();
}

const toml::node& Keys::need(std::string_view name) const {
  if (const toml::node* node = find(name)) return *node;
  throw missing(test_, key(name));
}

double Keys::quantity(std::string_view name, const Kind& kind, Range range) const {
  return value(need(name), key(name), kind, range);
}

std::uint64_t Keys::whole_number(std::string_view name, std::int64_t min) const {
  const toml::node& node = need(name);
  const auto value = node.value<std::int64_t>();  // also from 1e5
  if (!node.is_number() || !value || *value < min)
    refuse(name, fmt::format("{} is not a whole number of at least {}", kind_of_node(node), min));
  return static_cast<std::uint64_t>(*value);
}

std::size_t Keys::word(std::string_view name, const std::vector<std::string_view>& known) const {
  std::vector<std::string> expected;
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (need(name).value_exact<std::string_view>() == known[i]) return i;
    expected.push_back(fmt::format("\"{}\"", known[i]));
  }
  const auto word = need(name).value_exact<std::string>();
  const std::string meant = nearest(word.value_or(""), {known.begin(), known.end()});
  refuse(name, fmt::format("{} is not {}", kind_of_node(need(name)), in_words(expected)),
         meant.empty() ? "" : fmt::format("did you mean \"{}\"?", meant));
}

bool Keys::is_percent(std::string_view name) const {
  return need(name).value_exact<std::string_view>().value_or("").find('%') != std::string_view::npos;
}

double Keys::share(std::string_view name, Range range) const {
  if (!is_percent(name)) return quantity(name, kind::number, range);
  try {
    return parse_quantity(*need(name).value_exact<std::string_view>(), kind::number, range);
  } catch (const InputError& error) {
    throw placed(test_, error, key(name));
  }
}

double Keys::value(const toml::node& node, const std::string& key, const Kind& kind, Range range) const {
  const auto text = node.value_exact<std::string_view>();
  const bool is_number = node.is_number();
  if (!text && !is_number)
    throw wrong_value(test_, key, fmt::format("{} is not {}", kind_of_node(node), kind.name),
                      node.is_table() && node.as_table()->contains("uncertainty")
                          ? "it is taken as exact: leave the uncertainty out"
                          : "");
  const bool is_plain = kind.dimension == Dimension{} || (test_.reduced && kind.dimension != kind::angle.dimension);
  try {
    if (is_number && is_plain) {
      const double plain = node.value<double>().value_or(0);
      return within(range, plain, fmt::format("{}", plain), kind);
    }
    if (is_number) return parse_quantity(fmt::format("{}", node.value<double>().value_or(0)), kind, range);
    if (is_plain && !(*text == "inf" && range == Range::positive_or_infinite))
      throw InputError({.problem = fmt::format("{} is not a plain number", in_quotes(*text)),
                        .remedy = kind.dimension == Dimension{} ? "write it without quotes and without a unit"
                                                                : "the case is reduced: write it in reduced variables, "
                                                                  "without quotes and unit, or delete reduced = true"});
    return parse_quantity(*text, kind, range);
  } catch (const InputError& error) {
    throw placed(test_, error, key);
  }
}

void Keys::refuse(std::string_view name, std::string problem, std::string remedy) const {
  throw wrong_value(test_, key(name), std::move(problem), std::move(remedy));
}

}  // namespace flexslip
