#include "answers/all_answers.h"

#include <array>
#include <optional>

#include <fmt/format.h>

#include "answers/campaign_fields.h"
#include "answers/design_fields.h"
#include "answers/fit_fields.h"
#include "answers/mechanics_fields.h"
#include "answers/profile_fields.h"
#include "answers/standard_fields.h"
#include "answers/state_fields.h"
#include "data/names.h"
#include "instruments/export_fields.h"

namespace flexslip {
namespace {

std::string_view name_of(Shape shape) {
  return name_in_order<Shape::any>(shape, {"number", "count", "yes or no", "words", "quantity", "numbers", "estimate",
                                           "group", "list", "group by name", "words by name", "number or words"});
}

bool has_unit(Shape shape) {
  return shape == Shape::number || shape == Shape::quantity || shape == Shape::numbers || shape == Shape::estimate;
}

void append(std::vector<ResultLine>& lines, const std::vector<Description>& entries, const std::string& above,
            bool is_table) {
  for (const Description& entry : entries) {
    const std::string_view name = is_table && !entry.title.empty() ? entry.title : entry.name;
    const std::string key = fmt::format("{}{}", above, name);
    lines.push_back({key, name_of(entry.shape), has_unit(entry.shape) ? unit_of(entry.kind, false) : "",
                     has_unit(entry.shape) ? unit_of(entry.kind, true) : "", entry.meaning});
    const std::string_view below = is_table                        ? "_"
                                   : entry.shape == Shape::list    ? "[]."
                                   : entry.shape == Shape::by_name ? ".*."
                                                                   : ".";
    if (!is_table || entry.shape == Shape::group)
      append(lines, entry.entries, fmt::format("{}{}", key, below), is_table);
  }
}

// The parameters and the outcome of a design.
std::vector<Description> sweep_columns() {
  std::vector<Description> columns;
  for (const DesignParameter& known : design_parameters())
    columns.push_back({known.name, Shape::number, known.kind(), known.description});
  for (Description& outcome : point_fields({}).descriptions()) columns.push_back(std::move(outcome));
  return columns;
}

}  // namespace

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
      .words("flag", "the command-line option for the key",
             [](const CaseKey& key) { return key.has_flag ? std::optional(flag_of(key.name)) : std::nullopt; })
      .words("meaning", "meaning of the key", &CaseKey::meaning)
      .words("more", "additional text on the page of case files", &CaseKey::more);
}

std::vector<AnswerDescription> all_answers() {
  static const std::array<std::string, 1> draws{"draw_1, draw_2, …"};
  return {
      {"fit --json", "results of a measured test", false, fit_fields().descriptions()},
      {"fit --profile", "friction along the specimen, inverted at the fitted bending stiffness", true,
       profile_fields().descriptions()},
      {"fit --curves", "the record with pointwise friction and the fit", true, curve_fields().descriptions()},
      {"fit --draws", "posterior samples of the friction profile", true, draw_fields(draws).descriptions()},
      {"campaign --json", "results of many tests", false, campaign_fields().descriptions()},
      {"campaign: tests.csv", "one row per test", true, test_columns().descriptions()},
      {"campaign: categories.csv", "one row per category, without and with suspect tests", true,
       category_columns().descriptions()},
      {"campaign: specimens.csv", "typical values and spread between specimens, one row per parameter", true,
       specimen_columns().descriptions()},
      {"invert --json", "friction of a case, point by point", false, inverted_test_fields().descriptions()},
      {"invert --json of w,F", "friction of single states", false,
       states_fields(no_friction, inverted_fields()).descriptions()},
      {"invert", "friction of a case, inverted point by point at the stated bending stiffness", true,
       profile_fields().descriptions()},
      {"invert of w,F", "friction of single states", true, inverted_fields().descriptions()},
      {"modulus --json", "the numbers of the bending standards", false, modulus_fields().descriptions()},
      {"read --json", "contents of an export", false, export_fields().descriptions()},
      {"simulate --json", "a simulated test", false, simulation_fields(all_columns).descriptions()},
      {"simulate", "path of a test; some columns only for some tests", true, path_fields(all_columns).descriptions()},
      {"equilibrium --json", "the loading curve", false, equilibria_fields({false, true}).descriptions()},
      {"equilibrium --region --json", "all equilibria", false, equilibria_fields({true, true}).descriptions()},
      {"equilibrium", "the loading curve", true, equilibrium_fields({false, true}).descriptions()},
      {"equilibrium --region", "all equilibria", true, equilibrium_fields({true, true}).descriptions()},
      {"design --json", "prediction for a planned test", false, design_fields().descriptions()},
      {"design --over --json", "planned tests; the varied parameters come first", false,
       design_map_fields({}).descriptions()},
      {"design --over", "planned tests; the varied parameters come first", true, map_fields({}).descriptions()},
      {"sweep", "designs of a sweep; of the parameters, only the varied ones", true, sweep_columns()},
      {"state --json", "states on knife edges", false, states_fields(no_state, edge_state_fields(true)).descriptions()},
      {"state --json on rollers", "states on rollers or with a thickness", false,
       states_fields(no_state, roller_state_fields()).descriptions()},
      {"state", "states on knife edges", true, edge_state_fields(true).descriptions()},
      {"state on rollers", "states on rollers or with a thickness", true, roller_state_fields().descriptions()},
      {"keys --json", "list of the keys of case files", false, key_fields().descriptions()},
      {"results --json", "list of all keys and columns", false, line_fields().descriptions()},
  };
}

std::vector<ResultLine> lines_of(const AnswerDescription& answer) {
  std::vector<ResultLine> lines;
  append(lines, answer.entries, "", answer.is_table);
  return lines;
}

Fields<ResultLine> line_fields() {
  using L = const ResultLine&;
  return Fields<ResultLine>()
      .words("key", "key, or title of a column; [] is each item of a list, * any name", &ResultLine::key)
      .words("holds", "kind of value: number, count, estimate, words, …", &ResultLine::shape)
      .words("unit", "unit of numbers and estimates; null for others",
             [](L line) { return line.unit.empty() ? std::nullopt : std::optional(line.unit); })
      .words("reduced_unit", "unit for reduced tests",
             [](L line) { return line.reduced_unit.empty() ? std::nullopt : std::optional(line.reduced_unit); })
      .words("meaning", "meaning of the key", &ResultLine::meaning);
}

}  // namespace flexslip
