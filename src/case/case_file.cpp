#include "case/case_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <istream>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "case/case_changes.h"
#include "case/keys.h"
#include "case/toml.h"
#include "contact/height_trace.h"
#include "io/text.h"
#include "io/text_file.h"

namespace flexslip {
namespace {

constexpr std::size_t max_bytes = 1 << 20;  // [bytes] a thousand times the description of a test
constexpr double max_steps = 1e7;           // of a stage programme: minutes of work; more is a typing error
constexpr double max_turns = 1e5;           // of a stage programme with its cycles; more is a typing error

// Examples for missing sections, and for keys whose own example does not fit.
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
    Example{"record", R"(file = "ss14.csv", stage = "w_s_m [m]" and force = "F_N [N]")",
            R"(file = "test.csv", stage = "w_s" and force = "F")"},
    Example{"sweep", R"([sweep] with method = "grid" and [sweep.axes] with mu0 = [0.3, 0.5])",
            R"([sweep] with method = "grid" and [sweep.axes] with mu0 = [0.3, 0.5])"},
    Example{"sweep.axes", "[sweep.axes] with mu0 = [0.3, 0.5]", "[sweep.axes] with mu0 = [0.3, 0.5]"},
};

// Keys of a section that exclude each other. The first is refused together with any of the others.
struct Clash {
  std::string_view section, key, others, problem, remedy;
};

constexpr std::string_view one_section = "A section has either a diameter or width and height, not both";
constexpr std::string_view one_programme = "The stage has either a program or a file with stage positions, not both";
constexpr std::array clashes{
    Clash{"specimen", "wall", "inner_diameter", "A tube has either an inner_diameter or a wall, not both",
          "delete one"},
    Clash{"specimen", "width", "diameter|inner_diameter|wall", one_section, "delete one"},
    Clash{"specimen", "height", "diameter|inner_diameter|wall", one_section, "delete one"},
    Clash{"specimen", "modulus", "bending_stiffness",
          "A specimen has either a modulus or a bending_stiffness, not both", "delete one"},
    Clash{"specimen", "strength", "strain_at_break", "A specimen has either a strength or a strain_at_break, not both",
          "delete one"},
    Clash{"friction", "trace_step", "position", "A trace has either a trace_step or a position, not both",
          "delete one"},
    Clash{"stage", "program", "file", one_programme, "delete one"},
    Clash{"stage", "cycles", "file", one_programme, "delete one"},
    Clash{"stage", "step", "file", one_programme, "delete it: the rows of the file are the steps"},
};

// Keys that need another key.
constexpr std::string_view a_section = "add diameter, or width and height: the strain depends on the depth";
constexpr std::array needs{
    Clash{"specimen", "strength", "diameter|width", "This needs a section of the specimen", a_section},
    Clash{"specimen", "strain_at_break", "diameter|width", "This needs a section of the specimen", a_section},
    Clash{"friction", "reference", "drift", "A reference length needs a drift",
          "add drift, or delete reference: without a drift mu0 holds at every length"},
    Clash{"stage", "stage", "file", "This describes a file, and no file is stated",
          "add file = \"run.csv\", or delete it"},
    Clash{"stage", "time", "file", "This describes a file, and no file is stated",
          "add file = \"run.csv\", or delete it"},
    Clash{"stage", "decimal", "file", "This describes a file, and no file is stated",
          "add file = \"run.csv\", or delete it"},
};

// The keys of each friction model, in the order of FrictionModel; ? marks optional keys.
constexpr std::array<std::string_view, 8> keys_of_models{
    "mu0|drift?|reference?",
    "mu0|drift?|reference?",
    "mu0|amplitude|wavelength|phase?|drift?|reference?",
    "mu0|waves|drift?|reference?",
    "file|length|mu?",
    "mu0|rms|correlation_length|seed",
    "mu0|trace|position?|height?|trace_step?|trace_begin?|direction?|level?|cutoff?|edge_radius?",
    "",
};

bool says(const Test& test, std::string_view section, std::string_view name) {
  return test.lines.contains(fmt::format("{}.{}", section, name));
}

bool says_one(const Test& test, std::string_view section, std::string_view names) {
  const auto parts = words_of(names);
  return std::any_of(parts.begin(), parts.end(), [&](std::string_view name) { return says(test, section, name); });
}

// The field of a message for "specimen.diameter": "[specimen] diameter".
std::string field_name(std::string_view key) {
  constexpr std::string_view nested = "friction.other";
  const bool is_nested = key.starts_with(nested) && key.substr(nested.size()).starts_with('.');
  const std::size_t dot = is_nested ? nested.size() : key.find('.');
  if (key == nested) return fmt::format("[{}]", key);
  if (dot != std::string_view::npos) return fmt::format("[{}] {}", key.substr(0, dot), key.substr(dot + 1));
  const std::vector<std::string> sections = case_sections();
  return std::find(sections.begin(), sections.end(), key) == sections.end() ? std::string(key)
                                                                            : fmt::format("[{}]", key);
}

// The line of a key. A key that is not in the file has the line of its section.
std::size_t line_of(const Test& test, std::string_view key) {
  while (!key.empty()) {
    if (const auto at = test.lines.find(key); at != test.lines.end()) return at->second;
    const std::size_t end = key.find_last_of(".[");
    key = end == std::string_view::npos ? "" : key.substr(0, end);
  }
  return 0;
}

void note_lines(const toml::node& node, const std::string& key, Test& test) {
  if (!key.empty()) test.lines[key] = node.source().begin.line;
  if (const toml::table* table = node.as_table())
    for (auto&& [name, value] : *table)
      note_lines(value, key.empty() ? std::string(name.str()) : fmt::format("{}.{}", key, name.str()), test);
  if (const toml::array* array = node.as_array())
    for (std::size_t i = 0; i < array->size(); ++i) note_lines((*array)[i], fmt::format("{}[{}]", key, i + 1), test);
}

bool is_in_unit(const toml::table& section, std::string_view name, std::string_view symbol) {
  const toml::table* parts = section[name].as_table();
  const auto text = (parts ? (*parts)["value"] : section[name]).value_exact<std::string_view>();
  if (!text || !text->ends_with(symbol)) return false;
  const std::string_view number = text->substr(0, text->size() - symbol.size());
  return !number.empty() && (number.back() == ' ' || is_digit(number.back()));
}

// Reads [friction], where `further` keys belong to any model, or [friction.other], which has no
// such keys. A model without parameters is fitted.
void read_friction(const Keys& keys, FrictionInput& friction, const std::vector<std::string>& further) {
  keys.read(&friction);
  keys.need("model");
  std::vector<std::string> known{"model"};
  const auto names = words_of(keys_of_models.at(static_cast<std::size_t>(*friction.model)));
  for (const std::string_view name : names) known.emplace_back(name.substr(0, name.find('?')));
  if (friction.model != FrictionModel::roughness) known.insert(known.end(), further.begin(), further.end());
  if (friction.model == FrictionModel::roughness && keys.has("other"))
    keys.refuse("other", "[friction.other] needs a model to compute with in [friction], not a model to fit",
                "write a model to compute with into [friction], such as model = \"constant\" with mu0 = 0.5");
  keys.only(known);
  const bool is_to_fit = keys.size() == 1 && !further.empty();
  for (const std::string_view name : names)
    if (!is_to_fit && name.back() != '?') keys.need(name);
  if (friction.model == FrictionModel::surface && !(friction.mu0.value_or(1) > 0))
    keys.refuse("mu0", fmt::format("The friction of the flat surface is {:g}, but it must be above 0", *friction.mu0));
  if (friction.level > max_degree)
    keys.refuse("level", fmt::format("The degree is {}, above the limit of {}", friction.level, max_degree));
  double sum = 0;
  for (const WaveInput& wave : friction.waves) sum += wave.amplitude;
  if (sum > 1)
    keys.refuse("waves", fmt::format("The amplitudes add up to {}, more than 1", sum),
                "they are relative to mu0, and friction cannot be negative");
}

void read_supports(const Keys& keys, Test& test) {
  FrictionInput& friction = test.friction.emplace();
  if (keys.size() == 0) return;
  read_friction(keys, friction, {"static_excess", "wear", "other"});
  if (const toml::node* node = keys.find("other")) {
    if (!node->is_table())
      keys.refuse("other",
                  fmt::format("The other support needs a section [friction.other], not {}", kind_of_node(*node)));
    const Keys side(*node->as_table(), keys.key("other"), test);
    if (side.has("static_excess"))
      side.refuse("static_excess", "The excess of static friction holds for both supports and belongs in [friction]",
                  "delete it");
    read_friction(side, test.other.emplace(), {});
    if (test.other->model == FrictionModel::roughness)
      side.refuse("model", "The model 'roughness' can only be fitted, not computed with",
                  "write a model to compute with, such as model = \"constant\"");
  }
}

[[noreturn]] void refuse(const Test& test, const std::string& key, std::string problem, std::string remedy = "") {
  throw wrong_value(test, key, std::move(problem), std::move(remedy));
}

// The export of a testing machine may state span and section.
bool reads_export(const Test& test) { return test.record && test.record->is_export(); }

void check_specimen(const Test& test) {
  const SpecimenInput& specimen = *test.specimen;
  const bool is_tube = specimen.inner_diameter || specimen.wall;
  if (is_tube && !specimen.diameter) throw missing(test, "specimen.diameter");
  if (specimen.width.has_value() != specimen.height.has_value() && !reads_export(test))
    throw missing(test, specimen.width ? "specimen.height" : "specimen.width");
  if (is_tube) {
    const double inner = specimen.wall ? *specimen.diameter - 2 * *specimen.wall : specimen.inner_diameter->value;
    if (!(inner < *specimen.diameter && inner > 0) && specimen.wall)
      refuse(test, "specimen.wall",
             fmt::format("The wall is {} thick, which is half the diameter or more",
                         readable_length(test, *specimen.wall)),
             "leave it out if the specimen is solid");
    if (!(inner < *specimen.diameter))
      refuse(test, "specimen.inner_diameter",
             fmt::format("The inner diameter of {} is not below the outer diameter", readable_length(test, inner)),
             "check which of the two is which");
  }
  for (std::size_t i = 0; i < specimen.cracks.size(); ++i)
    if (!(specimen.cracks[i].loss < 1))
      refuse(test, fmt::format("specimen.cracks[{}].loss", i + 1),
             fmt::format("A crack takes less than 100 % of the bending stiffness that is left, not {}",
                         specimen.cracks[i].loss));
  if (!specimen.bending_stiffness && !section_of(test) && !reads_export(test)) throw missing(test, "specimen.diameter");
  if (!test.reduced) return;
  if (specimen.strength)
    refuse(test, "specimen.strength", "A reduced case has no strength", "give strain_at_break instead");
  if (specimen.modulus)
    refuse(test, "specimen.modulus", "A reduced case has no modulus",
           "delete it: the bending stiffness is 1, or \"fit\"");
  const Known* known = specimen.bending_stiffness ? std::get_if<Known>(&*specimen.bending_stiffness) : nullptr;
  if (known && known->value != 1)
    refuse(test, "specimen.bending_stiffness",
           fmt::format("The bending stiffness is {}, but a reduced case has 1, the unit of reduced variables",
                       known->value));
}

void check_rig(const Test& test) {
  const RigInput& rig = *test.rig;
  if (!rig.span && !reads_export(test)) throw missing(test, "rig.span");
  const auto written = [&](double length) {
    return test.reduced ? fmt::format("{:.4g}", length) : in_quotes(readable_length(test, length));
  };
  if (test.reduced && rig.span != 1.0)
    refuse(test, "rig.span",
           fmt::format("The span is {}, but a reduced case has 1, the unit of reduced variables", rig.span->value));
  const bool has_radius = rig.roller_radius.value_or(0) > 0;
  if (rig.supports == SupportKind::edges && has_radius)
    refuse(test, "rig.supports", "The supports are \"edges\", but a roller_radius is stated",
           "delete it, or roller_radius");
  if (rig.supports == SupportKind::rollers && !has_radius)
    throw missing(test, "rig.roller_radius", "for supports = \"rollers\"",
                  fmt::format("add yours, such as roller_radius = {}", written(0.05 * *rig.span)));
  if (rig.rollers != Rollers::fixed && !has_radius)
    refuse(test, "rig.rollers", "This needs rollers with a radius, and no radius is stated",
           fmt::format("state the radius, {}, or delete it", keys_in_words(test, "rig", {"roller_radius"})));
  const bool is_pinned = rig.rollers == Rollers::pinned;
  for (const auto& [name, member] :
       {std::pair{"pin_radius", &RigInput::pin_radius}, {"pin_friction", &RigInput::pin_friction}}) {
    if (is_pinned && !(rig.*member))
      throw missing(test, fmt::format("rig.{}", name), "for rollers = \"pinned\"",
                    fmt::format("add yours, such as {} = {}", name,
                                member == &RigInput::pin_friction ? "0.1" : written(0.2 * *rig.roller_radius)));
    if (!is_pinned && rig.*member)
      refuse(test, fmt::format("rig.{}", name), "This needs rollers on pins, and the rollers are 'fixed'",
             "write rollers = \"pinned\", or delete it");
  }
  if (is_pinned && !(*rig.pin_radius <= *rig.roller_radius))
    refuse(test, "rig.pin_radius",
           fmt::format("The radius of the pin is {:g} times the radius of the roller",
                       *rig.pin_radius / *rig.roller_radius),
           "check the units of both");
  if (is_pinned && !rig.pins_turn())
    refuse(test, "rig.pin_friction",
           fmt::format("The friction of the pin is {:g}, not less than the ratio of the radii of roller and pin, so no "
                       "roller turns",
                       *rig.pin_friction),
           fmt::format("write a value below {:.3g}, or a smaller pin_radius", *rig.roller_radius / *rig.pin_radius));
  if (says(test, "rig", "friction_at") && rig.friction_at == FrictionAt::surface && test.specimen &&
      !section_of(test) && test.specimen->bending_stiffness)
    refuse(test, "rig.friction_at", "Friction acts at the surface of the specimen, but no section is stated",
           "add diameter, or width and height, to [specimen], or write \"axis\"");
}

void check_stage(const Test& test) {
  const StageInput& stage = *test.stage;
  if (stage.file && !stage.stage) throw missing(test, "stage.stage");
  if (stage.file) return;
  const auto& positions = stage.program;
  if (!says(test, "stage", "program")) throw missing(test, "stage.program");
  if (positions.size() < 2)
    refuse(test, "stage.program",
           fmt::format("The program needs at least two stage positions, a start and an end, and has {}",
                       positions.size()));
  const auto times = static_cast<double>(stage.cycles);
  if (const double turns = times * static_cast<double>(positions.size() - 1); !(turns <= max_turns))
    refuse(test, stage.cycles > 1 ? "stage.cycles" : "stage.program",
           fmt::format("The program has {:.1e} turning points, more than the limit of {:.0e}", turns, max_turns));
  if (!stage.step) return;
  double travel = times * std::abs(positions[1] - positions.back());
  for (std::size_t i = 2; i < positions.size(); ++i) travel += times * std::abs(positions[i] - positions[i - 1]);
  travel += std::abs(positions[1] - positions[0]);
  if (!(travel / *stage.step <= max_steps))
    refuse(test, "stage.step",
           fmt::format("The program has {:.1e} steps, more than the limit of {:.0e}", travel / *stage.step, max_steps),
           "take a larger step, or \"continuous\"");
}

void check_record(const Test& test) {
  const RecordInput& record = *test.record;
  for (const std::string_view of_export : {"displacement", "displacement_column", "calibration", "speed"})
    for (const std::string_view of_table : {"stage", "deflection"})
      if (says(test, "record", of_export) && says(test, "record", of_table))
        refuse(
            test, fmt::format("record.{}", of_export),
            fmt::format("Of column titles and the description of an export only one can be stated, not both {} and {}",
                        of_table, of_export),
            "delete one");
  if (record.is_export() && record.length)
    refuse(test, "record.length",
           "A length also needs stage or deflection, and force, with the titles of their columns");
  if (record.is_export() && test.reduced)
    refuse(test, "record.stage", "A reduced case needs two of the columns stage, deflection and force",
           "delete reduced = true if the file is an export of a testing machine, in physical units");
  if (record.is_export()) return;
  std::vector<std::string> found;
  for (const std::string_view name : {"stage", "deflection", "force"})
    if (says(test, "record", name)) found.emplace_back(name);
  if (found.size() != 2)
    refuse(test, "record.stage",
           fmt::format("Two of the columns stage, deflection and force are needed, and {} stated",
                       found.size() == 3 ? "all three are" : fmt::format("only {} is", found.front())),
           "the third follows from the stiffness of the rig");
  if (!record.force && test.rig && test.rig->stiffness && std::isinf(*test.rig->stiffness))
    throw wrong_value(test, "record",
                      "The rig is infinitely stiff, so stage and deflection are the same and do not give the force",
                      "name the column of the force");
}

// Checks that involve several keys.
void check(const Test& test) {
  Faults faults;
  const auto refuse_if = [&](const Clash& rule, bool is_beside) {
    std::vector<std::string_view> sections{rule.section};
    if (rule.section == "friction") sections.emplace_back("friction.other");
    for (const std::string_view section : sections)
      if (says(test, section, rule.key) && says_one(test, section, rule.others) == is_beside)
        faults.note([&] {
          refuse(test, fmt::format("{}.{}", section, rule.key), std::string(rule.problem), std::string(rule.remedy));
        });
  };
  for (const Clash& clash : clashes) refuse_if(clash, true);
  for (const Clash& need : needs) refuse_if(need, false);
  faults.raise();
  const auto check_section = [&](const auto& part, auto check) {
    if (part) faults.note([&] { check(test); });
  };
  check_section(test.specimen, check_specimen);
  check_section(test.rig, check_rig);
  check_section(test.stage, check_stage);
  check_section(test.record, check_record);
  faults.raise();
  const auto section = section_of(test);
  if (!section || !test.rig || !test.rig->span || depth(*section) < *test.rig->span) return;
  throw wrong_value(test, depth_key(*section),
                    fmt::format("The specimen is {} thick, which is not less than the span of {}",
                                readable_length(test, depth(*section)), readable_length(test, *test.rig->span)),
                    "check the units of both");
}

template <class Section>
std::vector<std::string> lines_of(const Test& test, Section* part);

// The fewest digits that identify the bits.
std::string quantity_text(const Test& test, const Kind& kind, double value) {
  const bool is_plain = test.reduced || kind.dimension == Dimension{} || kind.dimension == kind::angle.dimension;
  return is_plain ? fmt::format("{}", value) : fmt::format("\"{}\"", exact_text(value, kind));
}

// Writes values in the notation of a case file.
struct Writer {
  const Test& test;
  const CaseKey& key;

  std::string operator()(double value) const {
    const bool in_inches_too = is_in_inches(test) && key.name == "span";
    return quantity_text(test, !key.kind ? kind::number : in_inches_too ? in_inches(*key.kind) : *key.kind, value);
  }
  std::string operator()(const std::string& value) const { return toml_text(value); }
  std::string operator()(char value) const { return fmt::format("\"{}\"", value); }
  std::string operator()(const ToFit&) const { return "\"fit\""; }
  std::string operator()(const Known& known) const {
    if (!known.uncertainty) return (*this)(known.value);
    return fmt::format("{{ value = {}, uncertainty = {} }}", (*this)(known.value), (*this)(*known.uncertainty));
  }
  std::string operator()(const AtRow& at) const { return std::to_string(at.row); }
  std::string operator()(const AtStage& at) const {
    return fmt::format("{{ stage = {} }}", quantity_text(test, kind::length, at.position));
  }
  std::string operator()(const AtDeflection& at) const {
    return fmt::format("{{ deflection = {} }}", quantity_text(test, kind::length, at.position));
  }
  template <class Value>
  std::string operator()(Value value) const {  // a word or a whole number
    const auto number = static_cast<std::uint64_t>(value);
    return std::is_enum_v<Value> ? toml_text(words_of(key).at(static_cast<std::size_t>(number)))
                                 : std::to_string(number);
  }
  template <class... Values>
  std::string operator()(const std::variant<Values...>& value) const {
    return std::visit(*this, value);
  }
  template <class Value>
  std::string operator()(const std::optional<Value>& value) const {
    return (*this)(value.value());
  }
  template <class Value>
  std::string operator()(const std::vector<Value>& values) const {
    std::vector<std::string> texts;
    for (Value value : values)
      if constexpr (std::is_same_v<Value, double>)
        texts.push_back((*this)(value));
      else
        texts.push_back(fmt::format("{{ {} }}", fmt::join(lines_of(test, &value), ", ")));
    return fmt::format("[{}]", fmt::join(texts, ", "));
  }
};
// "name = value" for each member of a part that is required or differs from its default.
template <class Section>
std::vector<std::string> lines_of(const Test& test, Section* part) {
  Section nothing{};
  std::vector<std::string> lines;
  for (const CaseKey& key : case_keys())
    if (const Slot slot = key.of(part); slot.index() > 0)
      std::visit(
          [&](auto member) {
            if constexpr (!std::is_same_v<decltype(member), std::monostate>)
              if (is_required(member) || !(*member == *std::get<decltype(member)>(key.of(&nothing))))
                lines.push_back(fmt::format("{} = {}", key.name, Writer{test, key}(*member)));
          },
          slot);
  return lines;
}

}  // namespace

Test read_case(std::string_view text, const std::string& source, const std::vector<std::string>& changes) {
  const toml::table table = with_changes(parse_toml(text, source), changes);
  Test test{.source = source};
  for (const std::string& change : changes) test.changed.push_back(changed_key(change));
  note_lines(table, "", test);
  const Keys top(table, "", test);
  Faults faults;
  faults.note([&] { top.only({"reduced", "specimen", "rig", "friction", "stage", "record", "sweep"}); });
  if (const toml::node* reduced = top.find("reduced")) {
    if (!reduced->is_boolean())
      top.refuse("reduced", fmt::format("This is true or false, not {}", kind_of_node(*reduced)));
    test.reduced = reduced->value_or(false);
  }
  const auto section = [&](const char* name) -> const toml::table* {
    const toml::node* node = top.find(name);
    if (node && !node->is_table())
      top.refuse(name, fmt::format("The case needs a section [{}], not {}", name, kind_of_node(*node)));
    return node ? node->as_table() : nullptr;
  };
  const auto read = [&](const char* name, auto& part) {
    faults.note([&] {
      if (const toml::table* said = section(name)) Keys(*said, name, test).read(&part.emplace());
    });
  };
  read("specimen", test.specimen);
  read("rig", test.rig);
  if (test.rig) test.rig->in_inches = is_in_unit(*section("rig"), "span", "in");
  if (test.reduced) {
    if (!test.specimen) test.specimen.emplace();
    if (!test.specimen->bending_stiffness) test.specimen->bending_stiffness = Known{1};
    if (!test.rig) test.rig.emplace();
    if (!test.rig->span) test.rig->span = 1;
  }
  faults.note([&] {
    if (const toml::table* friction = section("friction")) read_supports({*friction, "friction", test}, test);
  });
  read("stage", test.stage);
  read("record", test.record);
  faults.raise();
  check(test);
  return test;
}

Test read_case(const std::string& path, const std::vector<std::string>& changes) {
  return read_case(case_text(path), path == "-" ? "standard input" : path, changes);
}

std::string to_toml(Test test) {
  std::string text = test.reduced ? "reduced = true\n" : "";
  const auto write = [&](std::string_view name, auto& part) {
    if (!part) return;
    text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", name);
    for (const std::string& line : lines_of(test, &*part)) text += line + "\n";
  };
  write("specimen", test.specimen);
  write("rig", test.rig);
  write("friction", test.friction);
  write("friction.other", test.other);
  write("stage", test.stage);
  write("record", test.record);
  return text;
}

std::string case_text(const std::string& path) {
  const std::string source = path == "-" ? "standard input" : path;
  const std::shared_ptr<std::istream> in = open_to_read(path);
  std::string text(max_bytes + 1, '\0');
  in->read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in->bad()) throw InputError({.file = source, .problem = "The file could not be read"});
  text.resize(static_cast<std::size_t>(in->gcount()));
  if (text.size() > max_bytes)
    throw InputError({.file = source, .problem = "The file has more than 1 MiB, too much for a case file (TOML)"});
  return text;
}

std::string KeyChange::in_case() const { return fmt::format("[{}] {} = {}", section, name, value); }

namespace {

// The flag of a key: "--sign", or "--set rig.roller_radius".
std::string flag_for(std::string_view section, std::string_view name) {
  const CaseKey* key = case_key(section, name);
  return key && key->has_flag ? flag_of(name) : fmt::format("--set {}.{}", section, name);
}

}  // namespace

std::string KeyChange::flag() const {
  const std::string flag = flag_for(section, name);
  const bool is_word = value.front() == '"' && value.find(' ') == std::string::npos;
  return fmt::format("{}{}{}", flag, flag.starts_with("--set") ? '=' : ' ',
                     is_word ? value.substr(1, value.size() - 2) : value);
}

std::string in_words(const Test& test, const KeyChange& change) {
  return test.by_flags ? change.flag() : change.in_case();
}

std::string instruction_to_set(const Test& test, const std::vector<KeyChange>& changes) {
  std::vector<std::string> said;
  for (const KeyChange& change : changes)
    said.push_back(test.by_flags ? change.flag() : fmt::format("{} = {}", change.name, change.value));
  if (test.by_flags) return fmt::format("pass {}", fmt::join(said, " "));
  return fmt::format("write {} into [{}]", fmt::join(said, " and "), changes.front().section);
}

std::string instruction_to_set(const Test& test, const KeyChange& change) {
  return instruction_to_set(test, std::vector<KeyChange>{change});
}

std::string keys_in_words(const Test& test, std::string_view section, const std::vector<std::string>& names) {
  if (!test.by_flags) return fmt::format("[{}] {}", section, in_words(names));
  std::vector<std::string> flags;
  for (const std::string& name : names) {
    const std::string flag = flag_for(section, name);
    flags.push_back(flag.starts_with("--set") ? flag + "=…" : flag);
  }
  return in_words(flags);
}

InputError wrong_value(const Test& test, std::string_view key, std::string problem, std::string remedy) {
  const bool is_changed = std::any_of(test.changed.begin(), test.changed.end(), [&](const std::string& each) {
    return key == each || (key.starts_with(each) && (key[each.size()] == '[' || key[each.size()] == '.'));
  });
  return InputError({.file = is_changed ? "--set" : test.source,
                     .line = is_changed ? 0 : line_of(test, key),
                     .field = is_changed ? std::string(key) : field_name(key),
                     .problem = std::move(problem),
                     .remedy = std::move(remedy),
                     .key = std::string(key)});
}

InputError wrong_cell(const Table& table, std::size_t row, const Column& column, std::string problem,
                      std::string remedy) {
  return InputError({.file = table.source,
                     .line = table.lines[row],
                     .field = fmt::format("column {}", in_quotes(column.name)),
                     .problem = std::move(problem),
                     .remedy = std::move(remedy)});
}

Kind kind_in(const Test& test, const Kind& kind) {
  if (test.reduced) return kind::number;
  return is_in_inches(test) ? in_inches(kind) : kind;
}

bool is_in_inches(const Test& test) { return test.rig && test.rig->in_inches; }

std::string readable_length(const Test& test, double length) { return readable(length, kind_in(test, kind::length)); }

double quantity_of_flag(std::string_view flag, std::string_view text, const Kind& kind, Range range) {
  try {
    return parse_quantity(text, kind, range);
  } catch (const InputError& error) {
    throw located(error, "", 0, flag);
  }
}

std::string depth_key(const Section& section) {
  return std::holds_alternative<RectangularSection>(section) ? "specimen.height" : "specimen.diameter";
}

InputError missing(const Test& test, std::string_view key, std::string why, std::string remedy) {
  const std::string what = key.find('.') == std::string_view::npos ? "section" : "value";
  InputFault fault = wrong_value(test, key,
                                 why.empty() ? fmt::format("This {} is missing", what)
                                             : fmt::format("This {} is missing {}", what, why),
                                 std::move(remedy))
                         .fault;
  fault.kind = FaultKind::missing;
  return InputError(std::move(fault));
}

std::vector<std::string*> files_of(Test& test) {
  std::vector<std::string*> files;
  const auto add = [&](std::optional<std::string>& file) {
    if (file) files.push_back(&*file);
  };
  if (test.record) files.push_back(&test.record->file);
  for (auto* friction : {&test.friction, &test.other}) {
    if (!*friction) continue;
    add((*friction)->file);
    add((*friction)->trace);
  }
  if (test.stage) add(test.stage->file);
  return files;
}

std::optional<Section> section_of(const Test& test) {
  if (!test.specimen) return std::nullopt;
  const SpecimenInput& specimen = *test.specimen;
  if (specimen.width && specimen.height) return RectangularSection{*specimen.width, *specimen.height};
  if (!specimen.diameter) return std::nullopt;
  if (specimen.inner_diameter) return TubularSection{*specimen.diameter, *specimen.inner_diameter};
  if (specimen.wall) return TubularSection{*specimen.diameter, *specimen.diameter - 2 * *specimen.wall};
  return RoundSection{*specimen.diameter};
}

InputError missing(const Test& test, std::string_view key) {
  const auto fault = [&](std::string remedy) { return missing(test, key, "", std::move(remedy)); };
  for (const Example& example : examples) {
    const std::string_view text = test.reduced ? example.reduced : example.physical;
    if (example.key == key && !text.empty()) return fault(fmt::format("add {}", text));
  }
  const std::size_t dot = key.rfind('.');
  if (dot != std::string_view::npos)
    if (const CaseKey* described = case_key(key.substr(0, dot), key.substr(dot + 1))) {
      const std::string_view text = test.reduced ? described->reduced : described->example;
      if (!text.empty()) return fault(fmt::format("add {} = {}", described->name, text));
    }
  return fault("");
}

}  // namespace flexslip
