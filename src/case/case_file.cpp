#include "case/case_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <istream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "case/case_changes.h"
#include "case/case_words.h"
#include "case/friction_section.h"
#include "case/keys.h"
#include "case/toml.h"
#include "io/quantity.h"
#include "io/table.h"

namespace flexslip {
namespace {

constexpr std::size_t largest_file = 1 << 20;  // [bytes] a description of one test is a thousand times smaller
constexpr double most_steps = 1e7;             // of a stage programme: minutes of work; more is a slip of the pen
constexpr double most_turns = 1e5;             // of a stage programme with its cycles: likewise

// What to write for a section that is missing, or a key of which one alone would not do.
struct Example {
  std::string_view key;
  std::string_view physical;
  std::string_view reduced;
};

constexpr std::array examples{
    Example{"specimen", R"(diameter = "34.8 um" and modulus = "29.6 GPa")", ""},
    Example{"specimen.diameter", R"(diameter = "34.8 um", or width and height, or bending_stiffness = "2.1e-9 N m^2")",
            "diameter = 0.027"},
    Example{"rig",
            R"(the span of your supports, span = "… mm", and the stiffness of your load train, stiffness = "… N/m")",
            "the stiffness of your load train in EI/L^3, stiffness = …"},
    Example{"rig.stiffness",
            R"(the stiffness of your load train, stiffness = "… N/m", or "inf" for displacement control)",
            R"(the stiffness of your load train in EI/L^3, stiffness = …, or "inf" for displacement control)"},
    Example{"friction", R"(model = "sinusoid", mu0 = 0.5, amplitude = 0.15 and wavelength = "11 um")",
            R"(model = "sinusoid", mu0 = 0.5, amplitude = 0.15 and wavelength = 0.0086)"},
    Example{"stage", R"(program = ["0 um", "900 um"])", "program = [0, 0.7]"},
    Example{"stage.stage", R"(stage = "stage [um]", the title of its column)",
            R"(stage = "w_s", the title of its column)"},
    Example{"record", R"(file = "ss14.csv", stage = "w_s_m [m]" and force = "F_N [N]")",
            R"(file = "test.csv", stage = "w_s" and force = "F")"},
    Example{"sweep", R"([sweep] with method = "grid" and [sweep.axes] with mu0 = [0.3, 0.5])",
            R"([sweep] with method = "grid" and [sweep.axes] with mu0 = [0.3, 0.5])"},
    Example{"sweep.method", R"(method = "grid", or "latin hypercube")", R"(method = "grid", or "latin hypercube")"},
    Example{"sweep.samples", "samples = 1000", "samples = 1000"},
    Example{"sweep.seed", "seed = 1", "seed = 1"},
    Example{"sweep.axes", "[sweep.axes] with mu0 = [0.3, 0.5]", "[sweep.axes] with mu0 = [0.3, 0.5]"},
};

// "specimen.diameter" as the user finds it: "[specimen] diameter".
std::string field_name(std::string_view key) {
  constexpr std::string_view nested = "friction.other";
  const bool is_nested = key.starts_with(nested) && key.substr(nested.size()).starts_with('.');
  const std::size_t dot = is_nested ? nested.size() : key.find('.');
  if (key == nested) return fmt::format("[{}]", key);
  if (dot != std::string_view::npos) return fmt::format("[{}] {}", key.substr(0, dot), key.substr(dot + 1));
  for (const std::string_view section : {"specimen", "rig", "friction", "stage", "record", "sweep"})
    if (key == section) return fmt::format("[{}]", key);
  return std::string(key);
}

// The line of a key; one that the file does not have is looked for where it would stand, in its section.
std::size_t line_of(const Case& input, std::string_view key) {
  while (!key.empty()) {
    if (const auto at = input.lines.find(key); at != input.lines.end()) return at->second;
    const std::size_t end = key.find_last_of(".[");
    key = end == std::string_view::npos ? "" : key.substr(0, end);
  }
  return 0;
}

void note_lines(const toml::node& node, const std::string& key, Case& input) {
  if (!key.empty()) input.lines[key] = node.source().begin.line;
  if (const toml::table* table = node.as_table())
    for (auto&& [name, value] : *table)
      note_lines(value, key.empty() ? std::string(name.str()) : fmt::format("{}.{}", key, name.str()), input);
  if (const toml::array* array = node.as_array())
    for (std::size_t i = 0; i < array->size(); ++i) note_lines((*array)[i], fmt::format("{}[{}]", key, i + 1), input);
}

Section read_tube(const Keys& keys, double diameter) {
  const bool has_wall = keys.has("wall");
  if (has_wall && keys.has("inner_diameter"))
    keys.refuse("wall", "either the inner diameter or the wall of a tube", "both", "delete one");
  const double inner = has_wall ? diameter - 2 * keys.quantity("wall") : keys.quantity("inner_diameter");
  if (inner < diameter && inner > 0) return TubularSection{diameter, inner};
  keys.refuse(has_wall ? "wall" : "inner_diameter",
              has_wall ? "a wall thinner than half the diameter" : "an inner diameter below the outer one",
              kind_of_node(keys.need(has_wall ? "wall" : "inner_diameter")),
              has_wall ? "leave it out if the specimen is solid" : "check which of the two is which");
}

std::optional<Section> read_section(const Keys& keys) {
  const bool is_tube = keys.has("inner_diameter") || keys.has("wall");
  const bool is_round = keys.has("diameter") || is_tube;
  const bool is_rectangular = keys.has("width") || keys.has("height");
  if (is_round && is_rectangular)
    keys.refuse("diameter", "either a diameter or width and height", "both", "delete one");
  if (is_round) {
    const double diameter = keys.quantity("diameter");
    return is_tube ? read_tube(keys, diameter) : RoundSection{diameter};
  }
  if (!is_rectangular) return std::nullopt;
  return RectangularSection{keys.quantity("width"), keys.quantity("height")};
}

std::vector<CrackInput> read_cracks(const Keys& keys) {
  std::vector<CrackInput> cracks;
  for (const Keys& each : keys.tables("cracks", {"deflection", "loss"})) {
    cracks.push_back({each.quantity("deflection"), each.share("loss")});
    if (!(cracks.back().loss < 1))
      each.refuse("loss", "less than 100 % of the bending stiffness that is left",
                  fmt::format("{}", cracks.back().loss));
  }
  return cracks;
}

void read_what_it_bears(const Keys& keys, const Case& input, SpecimenInput& specimen) {
  if (!keys.has("strain_at_break") && !keys.has("strength")) return;
  const std::string_view name = keys.has("strength") ? "strength" : "strain_at_break";
  if (keys.has("strength") && keys.has("strain_at_break"))
    keys.refuse("strength", "either a strength or a strain_at_break", "both", "delete one");
  if (!specimen.section)
    keys.refuse(name, "a section of the specimen beside it", "none",
                "add diameter, or width and height: the strain depends on the depth");
  if (name == "strain_at_break") specimen.strain_at_break = keys.share("strain_at_break");
  if (name == "strength" && input.reduced)
    keys.refuse("strength", "no strength in a reduced case", "", "give strain_at_break instead");
  if (name == "strength") specimen.strength = keys.quantity("strength");
}

SpecimenInput read_specimen(const Keys& keys, const Case& input) {
  keys.only_described();
  SpecimenInput specimen{read_section(keys), BendingStiffness{Known{1, 0}}};
  if (keys.has("material")) specimen.material = keys.text("material");
  if (keys.has("cracks")) specimen.cracks = read_cracks(keys);
  read_what_it_bears(keys, input, specimen);
  const bool has_product = keys.has("bending_stiffness");
  if (keys.has("modulus") && (has_product || input.reduced))
    keys.refuse("modulus", input.reduced ? "no modulus in a reduced case" : "either a modulus or a bending_stiffness",
                input.reduced ? "" : "both",
                input.reduced ? "delete it: the bending stiffness is 1, or \"fit\"" : "delete one");
  if (has_product) {
    const StatedStiffness product = keys.estimate("bending_stiffness");
    const Known* known = std::get_if<Known>(&product);
    if (input.reduced && known && known->value != 1)
      keys.refuse("bending_stiffness", "1, the unit of reduced variables", fmt::format("{}", known->value));
    specimen.rigidity = BendingStiffness{product};
  } else if (!input.reduced) {
    specimen.rigidity = Modulus{keys.has("modulus") ? keys.estimate("modulus") : ToFit{}};
  }
  return specimen;
}

void read_rollers(const Keys& keys, const Case& input, RigInput& rig) {
  const auto written = [&](double length) {
    return input.reduced ? fmt::format("{:.4g}", length) : in_quotes(readable_length(input, length));
  };
  const std::string rollers = keys.has("rollers") ? keys.word("rollers") : "fixed";
  if (rollers != "fixed" && !(rig.roller_radius.value_or(0) > 0))
    keys.refuse("rollers", "rollers with a radius", "none",
                rig.span
                    ? fmt::format("add a radius, such as roller_radius = {}, or delete it", written(0.08 * *rig.span))
                    : "add roller_radius, or delete it");
  rig.rollers = rollers == "pinned" ? Rollers::pinned : rollers == "loose" ? Rollers::loose : Rollers::fixed;
  for (const std::string_view of_pins : {"pin_radius", "pin_friction"}) {
    if (rig.rollers == Rollers::pinned && !keys.has(of_pins))
      throw missing(input, fmt::format("rig.{}", of_pins), "beside rollers = \"pinned\"",
                    fmt::format("add that of your rig, such as {} = {}", of_pins,
                                of_pins == "pin_friction" ? "0.1" : written(0.2 * *rig.roller_radius)));
    if (rig.rollers != Rollers::pinned && keys.has(of_pins))
      keys.refuse(of_pins, "rollers on pins beside it", in_quotes(rollers), "write rollers = \"pinned\", or delete it");
  }
  if (rig.rollers != Rollers::pinned) return;
  rig.pin_radius = keys.quantity("pin_radius");
  rig.pin_friction = keys.quantity("pin_friction");
  if (!(rig.pin_radius <= *rig.roller_radius))
    keys.refuse("pin_radius", "at most the radius of the roller",
                fmt::format("{:g} times that", rig.pin_radius / *rig.roller_radius), "check the units of both");
  if (!rig.pins_turn())
    keys.refuse(
        "pin_friction", "less than the ratio of the radii of roller and pin", fmt::format("{:g}", rig.pin_friction),
        fmt::format("write a value below {:.3g}, or a smaller pin_radius", *rig.roller_radius / rig.pin_radius));
}

RigInput read_rig(const Keys& keys, const Case& input) {
  keys.only_described();
  RigInput rig{keys.optional_quantity("span"), std::nullopt};
  rig.in_inches = keys.is_in_unit("span", "in");
  if (input.reduced && rig.span.value_or(1) != 1)
    keys.refuse("span", "1, the unit of reduced variables", fmt::format("{}", *rig.span));
  if (input.reduced) rig.span = 1;
  rig.stiffness = keys.optional_quantity("stiffness");
  if (keys.has("support_material")) rig.support_material = keys.text("support_material");
  rig.nose_radius = keys.optional_quantity("nose_radius");
  rig.support_stiffness = keys.optional_quantity("support_stiffness");
  rig.roller_radius = keys.optional_quantity("roller_radius");
  read_rollers(keys, input, rig);
  if (keys.has("friction_at")) {
    const std::string at = keys.word("friction_at");
    const bool has_no_depth = input.specimen && !input.specimen->section &&
                              std::holds_alternative<BendingStiffness>(input.specimen->rigidity);
    if (at == "surface" && has_no_depth)
      keys.refuse("friction_at", "a section of the specimen, as friction acts at its surface", "none",
                  "add diameter, or width and height, to [specimen], or write \"axis\"");
    rig.friction_at = at == "surface" ? FrictionAt::surface : FrictionAt::axis;
  }
  return rig;
}

char read_decimal(const Keys& keys) { return keys.has("decimal") ? keys.word("decimal").front() : '.'; }

TurningPoints read_turning_points(const Keys& keys) {
  const toml::node& node = keys.need("program");
  const toml::array* turns = node.as_array();
  if (!turns || turns->size() < 2)
    keys.refuse("program", "at least two stage positions, a start and an end",
                turns ? std::to_string(turns->size()) : kind_of_node(node));
  TurningPoints stage{{}, keys.has("cycles") ? keys.whole_number("cycles") : 1, {}};
  for (std::size_t i = 0; i < turns->size(); ++i)
    stage.positions.push_back(keys.value((*turns)[i], fmt::format("{}[{}]", keys.key("program"), i + 1),
                                         *case_key("stage", "program")->kind, case_key("stage", "program")->range));
  const auto times = static_cast<double>(stage.cycles);
  if (!(times * static_cast<double>(turns->size() - 1) <= most_turns))
    keys.refuse(keys.has("cycles") ? "cycles" : "program", fmt::format("at most {:.0e} turning points", most_turns),
                fmt::format("{:.1e}", times * static_cast<double>(turns->size() - 1)));
  const toml::node* step = keys.find("step");
  if (!step || step->value_exact<std::string_view>() == "continuous") return stage;
  stage.step = keys.quantity("step");
  const auto& [positions, cycles, length] = stage;
  double travel = times * std::abs(positions[1] - positions.back());
  for (std::size_t i = 2; i < positions.size(); ++i) travel += times * std::abs(positions[i] - positions[i - 1]);
  travel += std::abs(positions[1] - positions[0]);
  if (!(travel / *length <= most_steps))
    keys.refuse("step", fmt::format("at most {:.0e} steps", most_steps), fmt::format("{:.1e}", travel / *length),
                "take a larger step, or \"continuous\"");
  return stage;
}

StageInput read_stage(const Keys& keys) {
  keys.only_described();
  StageInput stage;
  const bool is_measured = keys.has("file");
  for (const std::string_view other : {"program", "cycles", "step"})
    if (is_measured && keys.has(other))
      keys.refuse(other, "either a program or a file with stage positions", "both",
                  other == "step" ? "delete it: the rows of the file are the steps" : "delete one");
  for (const std::string_view other : {"stage", "time", "decimal"})
    if (!is_measured && keys.has(other))
      keys.refuse(other, "a file beside it, which it describes", "none", "add file = \"run.csv\", or delete it");
  if (is_measured)
    stage.programme =
        MeasuredProgramme{keys.path("file"), keys.column("stage"),
                          keys.has("time") ? std::optional(keys.column("time")) : std::nullopt, read_decimal(keys)};
  else
    stage.programme = read_turning_points(keys);
  stage.snaps = keys.optional_choice("snaps", snap_names).value_or(stage.snaps);
  return stage;
}

TableColumns read_table_columns(const Keys& keys) {
  std::string found;
  const auto column = [&](std::string_view name) -> std::optional<std::string> {
    if (!keys.has(name)) return std::nullopt;
    found += (found.empty() ? "" : " and ") + std::string(name);
    return keys.column(name);
  };
  TableColumns columns{column("stage"), column("deflection"), column("force"), read_decimal(keys)};
  if (keys.has("length")) columns.length = keys.column("length");
  if (columns.stage.has_value() + columns.deflection.has_value() + columns.force.has_value() != 2)
    keys.refuse("stage", "two of the columns stage, deflection and force", found.empty() ? "none" : found,
                "the third follows from the stiffness of the rig");
  return columns;
}

ExportColumns read_export_columns(const Keys& keys, const Case& input) {
  if (input.reduced)
    keys.refuse("stage", "two of the columns stage, deflection and force, as the case is reduced", "none",
                "delete reduced = true if the file is an export of a testing machine, in physical units");
  const auto text = [&](std::string_view name) {
    return keys.has(name) ? std::optional(keys.text(name)) : std::nullopt;
  };
  ExportColumns columns{.displacement = keys.optional_choice("displacement", displacement_names),
                        .displacement_column = text("displacement_column"),
                        .force = text("force"),
                        .specimen = {},
                        .calibration = text("calibration"),
                        .decimal = {}};
  if (keys.has("specimen")) columns.specimen = static_cast<std::size_t>(keys.whole_number("specimen"));
  if (keys.has("decimal")) columns.decimal = read_decimal(keys);
  return columns;
}

ForceZeroRule read_zero(const Keys& keys) {
  if (!keys.has("zero") || keys.is_word("zero", "find")) return ToFind{};
  if (keys.is_word("zero", "keep")) return ToKeep{};
  return keys.quantity("zero");
}

ContactRule read_contact(const Keys& keys) {
  if (!keys.has("contact")) return WhereFree{};
  if (keys.is_word("contact", "find")) return ToFind{};
  if (keys.is_word("contact", "first row")) return AtFirstRow{};
  return keys.quantity("contact");
}

PlaceInRecord read_place(const Keys& keys, std::string_view name, const Case& input) {
  const toml::node& node = keys.need(name);
  if (const toml::table* place = node.as_table()) {
    const Keys parts(*place, keys.key(name), input);
    parts.only({"stage", "deflection"});
    if (parts.size() != 1) keys.refuse(name, "either a stage or a deflection", place->empty() ? "neither" : "both");
    if (parts.has("stage")) return AtStage{parts.quantity("stage", kind::length, Range::any)};
    return AtDeflection{parts.quantity("deflection", kind::length, Range::any)};
  }
  if (node.is_string()) return AtStage{keys.quantity(name, kind::length, Range::any)};
  return AtRow{static_cast<std::size_t>(keys.whole_number(name, 1))};
}

RecordInput read_record(const Keys& keys, const Case& input) {
  const std::vector<std::string> of_tables{"stage", "deflection"};
  const std::vector<std::string> of_exports{"displacement", "displacement_column", "specimen", "calibration"};
  keys.only_described();
  const auto first_of = [&](const std::vector<std::string>& names) {
    return std::find_if(names.begin(), names.end(), [&](const std::string& name) { return keys.has(name); });
  };
  const auto of_table = first_of(of_tables);
  const auto of_export = first_of(of_exports);
  if (of_table != of_tables.end() && of_export != of_exports.end())
    keys.refuse(*of_export, "either column titles or a description of an export",
                fmt::format("both {} and {}", *of_table, *of_export), "delete one");
  const bool is_export = of_export != of_exports.end() || (of_table == of_tables.end() && !keys.has("force"));
  RecordInput record{.file = keys.path("file"), .columns = {}};
  if (keys.has("sheet")) record.sheet = keys.name_or_number("sheet");
  if (is_export && keys.has("length"))
    keys.refuse("length", "stage or deflection and force beside it, with the titles of their columns",
                "none, as for the export of a testing machine");
  if (is_export)
    record.columns = read_export_columns(keys, input);
  else
    record.columns = read_table_columns(keys);
  record.sign = keys.optional_choice("sign", sign_names).value_or(record.sign);
  record.zero = read_zero(keys);
  record.contact = read_contact(keys);
  record.find_failure = keys.optional_choice("failure", failure_names).value_or(true);
  if (keys.has("first")) record.first = read_place(keys, "first", input);
  if (keys.has("until")) record.until = read_place(keys, "until", input);
  return record;
}

// What one section alone cannot tell.
void check_together(const Case& input) {
  const auto* columns = input.record ? std::get_if<TableColumns>(&input.record->columns) : nullptr;
  const bool is_export = input.record && !columns;
  const bool needs_section = input.specimen && std::holds_alternative<Modulus>(input.specimen->rigidity);
  if (needs_section && !input.specimen->section && !is_export) throw missing(input, "specimen.diameter");
  if (input.rig && !input.rig->span && !is_export) throw missing(input, "rig.span");
  if (input.specimen && input.specimen->section && input.rig && input.rig->span) {
    const double thickness = depth(*input.specimen->section);
    if (thickness >= *input.rig->span)
      throw wrong_value(
          input, depth_key(*input.specimen->section),
          "a specimen thinner than the span of " + readable(*input.rig->span, kind_in(input, kind::length)),
          readable(thickness, kind_in(input, kind::length)), "check the units of both");
  }
  if (columns && !columns->force && input.rig && input.rig->stiffness && std::isinf(*input.rig->stiffness))
    throw wrong_value(input, "record", "a force column, as the rig is infinitely stiff", "stage and deflection",
                      "on such a rig the two are the same and do not give the force");
}

}  // namespace

Case read_case(std::string_view text, const std::string& source, const std::vector<std::string>& changes) {
  const toml::table table = with_changes(parse_toml(text, source), changes);
  Case input{.source = source,
             .reduced = false,
             .specimen = {},
             .rig = {},
             .friction = {},
             .stage = {},
             .record = {},
             .lines = {}};
  for (const std::string& change : changes) input.changed.push_back(changed_key(change));
  note_lines(table, "", input);
  const Keys top(table, "", input);
  top.only({"reduced", "specimen", "rig", "friction", "stage", "record", "sweep"});
  if (const toml::node* reduced = top.find("reduced")) {
    if (!reduced->is_boolean()) top.refuse("reduced", "true or false", kind_of_node(*reduced));
    input.reduced = reduced->value_or(false);
  }
  const auto section = [&](const char* name) -> const toml::table* {
    const toml::node* node = top.find(name);
    if (node && !node->is_table()) top.refuse(name, fmt::format("a section [{}]", name), kind_of_node(*node));
    return node ? node->as_table() : nullptr;
  };
  const toml::table* specimen = section("specimen");
  const toml::table* rig = section("rig");
  const toml::table* friction = section("friction");
  const toml::table* stage = section("stage");
  const toml::table* record = section("record");
  const toml::table nothing;
  if (specimen || input.reduced)
    input.specimen = read_specimen({specimen ? *specimen : nothing, "specimen", input}, input);
  if (rig || input.reduced) input.rig = read_rig({rig ? *rig : nothing, "rig", input}, input);
  if (friction) input.friction = read_friction({*friction, "friction", input}, input);
  if (stage) input.stage = read_stage({*stage, "stage", input});
  if (record) input.record = read_record({*record, "record", input}, input);
  check_together(input);
  return input;
}

Case read_case(const std::string& path, const std::vector<std::string>& changes) {
  return read_case(case_text(path), path == "-" ? "standard input" : path, changes);
}

std::string case_text(const std::string& path) {
  const std::string source = path == "-" ? "standard input" : path;
  const std::shared_ptr<std::istream> in = open_to_read(path);
  std::string text(largest_file + 1, '\0');
  in->read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in->bad()) throw InputError({.file = source, .expected = "a readable file", .found = "an error while reading"});
  text.resize(static_cast<std::size_t>(in->gcount()));
  if (text.size() > largest_file)
    throw InputError({.file = source, .expected = "a case file (TOML)", .found = "a file of more than 1 MiB"});
  return text;
}

InputError wrong_value(const Case& input, std::string_view key, std::string expected, std::string found,
                       std::string remedy) {
  const bool is_changed = std::any_of(input.changed.begin(), input.changed.end(), [&](const std::string& each) {
    return key == each || (key.starts_with(each) && (key[each.size()] == '[' || key[each.size()] == '.'));
  });
  return InputError({.file = is_changed ? "--set" : input.source,
                     .line = is_changed ? 0 : line_of(input, key),
                     .field = is_changed ? std::string(key) : field_name(key),
                     .expected = std::move(expected),
                     .found = std::move(found),
                     .remedy = std::move(remedy),
                     .key = std::string(key)});
}

Kind kind_in(const Case& input, const Kind& kind) {
  if (input.reduced) return kind::number;
  return is_in_inches(input) ? in_inches(kind) : kind;
}

bool is_in_inches(const Case& input) { return input.rig && input.rig->in_inches; }

std::string readable_length(const Case& input, double length) { return readable(length, kind_in(input, kind::length)); }

std::string depth_key(const Section& section) {
  return std::holds_alternative<RectangularSection>(section) ? "specimen.height" : "specimen.diameter";
}

InputError missing(const Case& input, std::string_view key, std::string why, std::string remedy) {
  InputFault fault = wrong_value(input, key, "", "", std::move(remedy)).fault;
  fault.kind = FaultKind::missing;
  fault.problem = why.empty() ? "is missing" : fmt::format("is missing {}", why);
  return InputError(std::move(fault));
}

InputError missing(const Case& input, std::string_view key) {
  const auto fault = [&](std::string remedy) { return missing(input, key, "", std::move(remedy)); };
  for (const Example& example : examples) {
    const std::string_view text = input.reduced ? example.reduced : example.physical;
    if (example.key == key && !text.empty()) return fault(fmt::format("add {}", text));
  }
  const std::size_t dot = key.rfind('.');
  if (dot != std::string_view::npos)
    if (const CaseKey* described = case_key(key.substr(0, dot), key.substr(dot + 1))) {
      const std::string_view text = input.reduced ? described->reduced : described->example;
      if (!text.empty()) return fault(fmt::format("add {} = {}", described->name, text));
    }
  return fault("");
}

}  // namespace flexslip
