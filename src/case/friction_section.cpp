#include "case/friction_section.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "case/case_words.h"
#include "io/input_error.h"
#include "surface/height_trace.h"

namespace flexslip {
namespace {

FrictionModel read_model(const Keys& keys) {
  const toml::node& node = keys.need("model");
  std::vector<std::string> names;
  for (const auto& [name, model] : friction_model_names) {
    if (node.value_exact<std::string_view>() == name) return model;
    names.emplace_back(name);
  }
  const std::string meant = nearest(node.value_exact<std::string>().value_or(""), names);
  keys.refuse("model", "one of the models " + listed(names), kind_of_node(node),
              meant.empty() ? "" : "did you mean " + in_quotes(meant) + "?");
}

WaveInput read_wave(const Keys& keys) {
  return {keys.quantity("amplitude"), keys.quantity("wavelength"), keys.optional_quantity("phase").value_or(0)};
}

std::vector<WaveInput> read_waves(const Keys& keys) {
  std::vector<WaveInput> waves;
  double sum = 0;
  for (const Keys& wave : keys.tables("waves", {"amplitude", "wavelength", "phase"})) {
    waves.push_back(read_wave(wave));
    sum += waves.back().amplitude;
  }
  if (sum > 1)
    keys.refuse("waves", "amplitudes that add up to at most 1", fmt::format("{}", sum),
                "they are relative to mu0, and friction cannot be negative");
  return waves;
}

std::optional<double> read_reference(const Keys& keys) {
  if (keys.has("reference") && !keys.has("drift"))
    keys.refuse("reference", "a drift beside it", "none",
                "add drift, or delete reference: without a drift mu0 holds at every length");
  return keys.optional_quantity("reference");
}

SurfaceFriction read_surface(const Keys& keys, double mu0) {
  if (!(mu0 > 0)) keys.refuse("mu0", "a friction of the flat surface above 0", fmt::format("{:g}", mu0));
  SurfaceFriction surface{mu0, keys.path("trace")};
  if (keys.has("position")) surface.position = keys.text("position");
  if (keys.has("height")) surface.height = keys.text("height");
  if (keys.has("position") && keys.has("trace_step"))
    keys.refuse("trace_step", "either a trace_step or a position", "both", "delete one");
  surface.trace_step = keys.optional_quantity("trace_step");
  surface.trace_begin = keys.optional_quantity("trace_begin");
  if (const auto direction = keys.optional_choice("direction", direction_names)) surface.direction = *direction;
  if (keys.has("level")) surface.level = keys.whole_number("level");
  if (surface.level > most_degree)
    keys.refuse("level", fmt::format("a degree of at most {}", most_degree), fmt::format("{}", surface.level));
  surface.cutoff = keys.optional_quantity("cutoff");
  surface.edge_radius = keys.optional_quantity("edge_radius");
  return surface;
}

FrictionProfileInput read_profile(FrictionModel model, const Keys& keys) {
  if (model == FrictionModel::table)
    return TabulatedFriction{keys.path("file"), keys.column("length"), keys.has("mu") ? keys.column("mu") : "mu"};
  const double mu0 = keys.quantity("mu0");
  if (model == FrictionModel::surface) return read_surface(keys, mu0);
  if (model == FrictionModel::rough)
    return RoughFriction{mu0, keys.quantity("rms"), keys.quantity("correlation_length"), keys.whole_number("seed")};
  WavyFriction wavy{mu0, keys.optional_quantity("drift").value_or(0), {}};
  wavy.reference = read_reference(keys);
  if (model == FrictionModel::sinusoid) wavy.waves = {read_wave(keys)};
  if (model == FrictionModel::sinusoids) wavy.waves = read_waves(keys);
  return wavy;
}

// Of one support.
std::vector<std::string> keys_of(FrictionModel model) {
  switch (model) {
    case FrictionModel::constant:
    case FrictionModel::drift:
      return {"model", "mu0", "drift", "reference"};
    case FrictionModel::sinusoid:
      return {"model", "mu0", "amplitude", "wavelength", "phase", "drift", "reference"};
    case FrictionModel::sinusoids:
      return {"model", "mu0", "waves", "drift", "reference"};
    case FrictionModel::table:
      return {"model", "file", "length", "mu"};
    case FrictionModel::rough:
      return {"model", "mu0", "rms", "correlation_length", "seed"};
    case FrictionModel::surface:
      return {"model",       "mu0",       "trace", "position", "height",     "trace_step",
              "trace_begin", "direction", "level", "cutoff",   "edge_radius"};
    case FrictionModel::roughness:
      return {"model"};
  }
  throw std::invalid_argument("keys_of: no such model");
}

// The model, once it is known that there are no keys but those of models, of this one and the further ones.
FrictionModel read_known_model(const Keys& keys, const std::vector<std::string>& further) {
  keys.only_described();
  const FrictionModel model = read_model(keys);
  std::vector<std::string> all = keys_of(model);
  if (model != FrictionModel::roughness)
    all.insert(all.end(), further.begin(), further.end());
  else if (keys.has("other"))
    keys.refuse("other", "no section [friction.other] beside a model to fit", "one",
                "write a model to compute with into [friction], such as model = \"constant\" with mu0 = 0.5");
  keys.only(all);
  return model;
}

OtherSupport read_other(const Keys& keys, const Case& input) {
  const toml::table* table = keys.need("other").as_table();
  if (!table)
    keys.refuse("other", "a section [friction.other] for the other support", kind_of_node(keys.need("other")));
  if (keys.has("static_excess") && keys.quantity("static_excess") > 0)
    keys.refuse("static_excess", "no excess of static friction, as the two supports differ", "one",
                "delete it, or [friction.other]");
  const Keys side(*table, keys.key("other"), input);
  if (side.has("static_excess"))
    side.refuse("static_excess", "no excess of static friction, as the two supports differ", "one", "delete it");
  const FrictionModel model = read_known_model(side, {});
  if (model == FrictionModel::roughness)
    side.refuse("model", "a model to compute with", "'roughness', which can only be fitted",
                "write a model to compute with, such as model = \"constant\"");
  return {model, read_profile(model, side)};
}

}  // namespace

FrictionInput read_friction(const Keys& keys, const Case& input) {
  if (keys.size() == 0) return {};
  const FrictionModel model = read_known_model(keys, {"static_excess", "other", "build_up_length"});
  FrictionInput friction{model, {}};
  if (keys.size() > 1) friction.profile = read_profile(model, keys);
  if (keys.has("other")) friction.other = read_other(keys, input);
  if (keys.has("static_excess")) friction.static_excess = keys.quantity("static_excess");
  if (keys.has("build_up_length")) friction.build_up_length = keys.quantity("build_up_length");
  for (const std::string_view beside : {"static_excess", "other"})
    if (friction.build_up_length > 0 && keys.has(beside))
      keys.refuse("build_up_length", fmt::format("no build-up length beside {}", beside), "one",
                  fmt::format("delete it, or {}", beside));
  return friction;
}

}  // namespace flexslip
