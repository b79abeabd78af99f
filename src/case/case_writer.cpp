// A case as the text of a case file.
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "case/case_file.h"
#include "case/case_keys.h"
#include "case/case_words.h"

namespace flexslip {
namespace {

// The fewest digits that identify the bits, as a TOML number.
std::string plain(double value) { return fmt::format("{}", value); }

std::string basic_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += fmt::format("\\{}", c);
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + "\"";
}

std::string array_text(const std::vector<std::string>& values) {
  std::string out;
  for (const std::string& value : values) out += (out.empty() ? "" : ", ") + value;
  return fmt::format("[{}]", out);
}

class Writer {
 public:
  explicit Writer(bool reduced) : reduced_(reduced) {
    if (reduced_) text_ = "reduced = true\n";
  }

  void section(std::string_view name) {
    section_ = name;
    text_ += fmt::format("{}[{}]\n", text_.empty() ? "" : "\n", name);
  }
  void line(std::string_view key, std::string_view value) { text_ += fmt::format("{} = {}\n", key, value); }

  std::string quantity(double value, const Kind& kind) const {
    return reduced_ ? plain(value) : fmt::format("\"{}\"", exact_text(value, kind));
  }

  void quantity(std::string_view key, double value) { line(key, quantity(value, *case_key(section_, key)->kind)); }

  void estimate(std::string_view key, const StatedStiffness& estimate) {
    const Kind& kind = *case_key(section_, key)->kind;
    const Known* known = std::get_if<Known>(&estimate);
    if (!known)
      line(key, "\"fit\"");
    else if (known->uncertainty == 0)
      line(key, quantity(known->value, kind));
    else
      line(key, fmt::format("{{ value = {}, uncertainty = {} }}", quantity(known->value, kind),
                            quantity(known->uncertainty, kind)));
  }

  std::string text() const { return text_; }

 private:
  bool reduced_;
  std::string_view section_;
  std::string text_;
};

void write(Writer& out, const RoundSection& round) { out.quantity("diameter", round.diameter); }

void write(Writer& out, const TubularSection& tube) {
  out.quantity("diameter", tube.diameter);
  out.quantity("inner_diameter", tube.inner_diameter);
}

void write(Writer& out, const RectangularSection& rectangle) {
  out.quantity("width", rectangle.width);
  out.quantity("height", rectangle.height);
}

void write(Writer& out, const SpecimenInput& specimen) {
  out.section("specimen");
  if (specimen.section) std::visit([&](const auto& section) { write(out, section); }, *specimen.section);
  if (const auto* modulus = std::get_if<Modulus>(&specimen.rigidity))
    out.estimate("modulus", modulus->estimate);
  else
    out.estimate("bending_stiffness", std::get<BendingStiffness>(specimen.rigidity).estimate);
  if (specimen.material) out.line("material", basic_string(*specimen.material));
  if (specimen.strain_at_break) out.line("strain_at_break", plain(*specimen.strain_at_break));
  if (specimen.strength) out.quantity("strength", *specimen.strength);
  std::vector<std::string> cracks;
  for (const CrackInput& crack : specimen.cracks)
    cracks.push_back(fmt::format("{{ deflection = {}, loss = {} }}", out.quantity(crack.deflection, kind::length),
                                 plain(crack.loss)));
  if (!cracks.empty()) out.line("cracks", array_text(cracks));
}

void write(Writer& out, const RigInput& rig) {
  out.section("rig");
  if (rig.span && rig.in_inches)
    out.line("span", out.quantity(*rig.span, in_inches(kind::length)));
  else if (rig.span)
    out.quantity("span", *rig.span);
  if (rig.stiffness) out.quantity("stiffness", *rig.stiffness);
  if (rig.support_material) out.line("support_material", basic_string(*rig.support_material));
  if (rig.nose_radius) out.quantity("nose_radius", *rig.nose_radius);
  if (rig.roller_radius) out.quantity("roller_radius", *rig.roller_radius);
  if (rig.rollers != Rollers::fixed) out.line("rollers", rig.rollers == Rollers::pinned ? "\"pinned\"" : "\"loose\"");
  if (rig.rollers == Rollers::pinned) {
    out.quantity("pin_radius", rig.pin_radius);
    out.line("pin_friction", plain(rig.pin_friction));
  }
  if (rig.friction_at == FrictionAt::axis) out.line("friction_at", "\"axis\"");
  if (rig.support_stiffness) out.quantity("support_stiffness", *rig.support_stiffness);
}

std::string wave_text(const Writer& out, const WaveInput& wave) {
  return fmt::format("{{ amplitude = {}, wavelength = {}, phase = {} }}", plain(wave.amplitude),
                     out.quantity(wave.wavelength, kind::length), plain(wave.phase));
}

void write(Writer& out, const WavyFriction& wavy, FrictionModel model) {
  out.line("mu0", plain(wavy.mu0));
  if (model == FrictionModel::sinusoid) {
    out.line("amplitude", plain(wavy.waves.front().amplitude));
    out.quantity("wavelength", wavy.waves.front().wavelength);
    out.line("phase", plain(wavy.waves.front().phase));
  } else if (model == FrictionModel::sinusoids) {
    std::vector<std::string> waves;
    for (const WaveInput& wave : wavy.waves) waves.push_back(wave_text(out, wave));
    out.line("waves", array_text(waves));
  }
  if (wavy.drift != 0 || wavy.reference) out.quantity("drift", wavy.drift);
  if (wavy.reference) out.quantity("reference", *wavy.reference);
}

void write(Writer& out, const TabulatedFriction& table, FrictionModel) {
  out.line("file", basic_string(table.file));
  out.line("length", basic_string(table.length));
  out.line("mu", basic_string(table.mu));
}

void write(Writer& out, const RoughFriction& rough, FrictionModel) {
  out.line("mu0", plain(rough.mu0));
  out.line("rms", plain(rough.rms));
  out.quantity("correlation_length", rough.correlation_length);
  out.line("seed", std::to_string(rough.seed));
}

void write(Writer& out, const SurfaceFriction& surface, FrictionModel) {
  out.line("mu0", plain(surface.mu0));
  out.line("trace", basic_string(surface.trace));
  if (!surface.position.empty()) out.line("position", basic_string(surface.position));
  if (!surface.height.empty()) out.line("height", basic_string(surface.height));
  if (surface.trace_step) out.quantity("trace_step", *surface.trace_step);
  if (surface.trace_begin) out.quantity("trace_begin", *surface.trace_begin);
  if (surface.direction == TraceDirection::inwards) out.line("direction", "\"inwards\"");
  if (surface.level != 1) out.line("level", std::to_string(surface.level));
  if (surface.cutoff) out.quantity("cutoff", *surface.cutoff);
  if (surface.edge_radius) out.quantity("edge_radius", *surface.edge_radius);
}

void write_model(Writer& out, FrictionModel written) {
  for (const auto& [name, model] : friction_model_names)
    if (written == model) out.line("model", fmt::format("\"{}\"", name));
}

void write(Writer& out, const FrictionInput& friction) {
  out.section("friction");
  if (friction.model) write_model(out, *friction.model);
  if (friction.profile)
    std::visit([&](const auto& profile) { write(out, profile, *friction.model); }, *friction.profile);
  if (friction.static_excess != 0) out.line("static_excess", plain(friction.static_excess));
  if (friction.build_up_length != 0) out.quantity("build_up_length", friction.build_up_length);
  if (!friction.other) return;
  out.section("friction.other");
  write_model(out, friction.other->model);
  std::visit([&](const auto& profile) { write(out, profile, friction.other->model); }, friction.other->profile);
}

void write(Writer& out, const TurningPoints& stage) {
  std::vector<std::string> turns;
  for (const double turn : stage.positions) turns.push_back(out.quantity(turn, kind::length));
  out.line("program", array_text(turns));
  if (stage.cycles != 1) out.line("cycles", std::to_string(stage.cycles));
  out.line("step", stage.step ? out.quantity(*stage.step, kind::length) : "\"continuous\"");
}

void write(Writer& out, const MeasuredProgramme& stage) {
  out.line("file", basic_string(stage.file));
  out.line("stage", basic_string(stage.stage));
  if (stage.time) out.line("time", basic_string(*stage.time));
  if (stage.decimal != '.') out.line("decimal", basic_string({&stage.decimal, 1}));
}

void write(Writer& out, const StageInput& stage) {
  out.section("stage");
  std::visit([&](const auto& programme) { write(out, programme); }, stage.programme);
  if (stage.snaps != SnapRest::nearest_stable) out.line("snaps", basic_string(name_in(snap_names, stage.snaps)));
}

void write(Writer& out, const TableColumns& columns) {
  if (columns.stage) out.line("stage", basic_string(*columns.stage));
  if (columns.deflection) out.line("deflection", basic_string(*columns.deflection));
  if (columns.force) out.line("force", basic_string(*columns.force));
  if (columns.length) out.line("length", basic_string(*columns.length));
  if (columns.decimal != '.') out.line("decimal", basic_string({&columns.decimal, 1}));
}

void write(Writer& out, const ExportColumns& columns) {
  if (columns.displacement) out.line("displacement", basic_string(name_in(displacement_names, *columns.displacement)));
  if (columns.displacement_column) out.line("displacement_column", basic_string(*columns.displacement_column));
  if (columns.force) out.line("force", basic_string(*columns.force));
  if (columns.specimen) out.line("specimen", std::to_string(*columns.specimen));
  if (columns.calibration) out.line("calibration", basic_string(*columns.calibration));
  if (columns.decimal) out.line("decimal", basic_string({&*columns.decimal, 1}));
}

void write(Writer& out, const RecordInput& record) {
  out.section("record");
  out.line("file", basic_string(record.file));
  if (record.sheet) {
    const std::string* name = std::get_if<std::string>(&*record.sheet);
    out.line("sheet", name != nullptr ? basic_string(*name) : std::to_string(std::get<std::size_t>(*record.sheet)));
  }
  std::visit([&](const auto& columns) { write(out, columns); }, record.columns);
  if (record.sign != SignRule::find) out.line("sign", basic_string(name_in(sign_names, record.sign)));
  if (std::holds_alternative<ToKeep>(record.zero)) out.line("zero", "\"keep\"");
  if (const auto* zero = std::get_if<double>(&record.zero)) out.quantity("zero", *zero);
  if (std::holds_alternative<ToFind>(record.contact)) out.line("contact", "\"find\"");
  if (std::holds_alternative<AtFirstRow>(record.contact)) out.line("contact", "\"first row\"");
  if (const auto* contact = std::get_if<double>(&record.contact)) out.quantity("contact", *contact);
  if (!record.find_failure) out.line("failure", basic_string(name_in(failure_names, false)));
  const auto place = [&](std::string_view key, const std::optional<PlaceInRecord>& at) {
    if (!at) return;
    if (const auto* row = std::get_if<AtRow>(&*at)) out.line(key, std::to_string(row->row));
    if (const auto* stage = std::get_if<AtStage>(&*at))
      out.line(key, fmt::format("{{ stage = {} }}", out.quantity(stage->position, kind::length)));
    if (const auto* deflection = std::get_if<AtDeflection>(&*at))
      out.line(key, fmt::format("{{ deflection = {} }}", out.quantity(deflection->position, kind::length)));
  };
  place("first", record.first);
  place("until", record.until);
}

}  // namespace

std::string to_toml(const Case& input) {
  Writer out(input.reduced);
  if (input.specimen) write(out, *input.specimen);
  if (input.rig) write(out, *input.rig);
  if (input.friction) write(out, *input.friction);
  if (input.stage) write(out, *input.stage);
  if (input.record) write(out, *input.record);
  return out.text();
}

}  // namespace flexslip
