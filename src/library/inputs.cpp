#include "library/inputs.h"

#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "case/case_file.h"
#include "contact/friction.h"
#include "flexslip/flexslip.h"

namespace flexslip::library {
namespace {

std::optional<Known> stated(const v1::Known& number) {
  if (std::isnan(number.value) && std::isnan(number.error)) return std::nullopt;
  if (std::isnan(number.error)) return Known(number.value);
  return Known(number.value, number.error);
}

std::optional<StatedStiffness> stated_stiffness(const v1::Known& number) {
  const auto known = stated(number);
  return known ? std::optional<StatedStiffness>(*known) : std::nullopt;
}

FrictionInput listed_friction(const v1::Friction& friction) {
  if (!std::isnan(friction.mu0) || !friction.waves.empty())
    throw InputError({.problem = "Friction is either mu0 with waves, or a list of points, not both",
                      .remedy = "leave one of them out",
                      .key = "friction"});
  auto table = std::make_shared<FrictionTable>();
  for (const v1::FrictionPoint& point : friction.points) {
    table->S.push_back(point.length);
    table->mu.push_back(point.mu);
  }
  return {.model = FrictionModel::table, .file = "points", .length = "length", .points = std::move(table)};
}

FrictionInput friction_of(const v1::Friction& friction) {
  if (!friction.points.empty()) return listed_friction(friction);
  FrictionInput input{.model = friction.waves.empty() ? FrictionModel::constant : FrictionModel::sinusoids,
                      .mu0 = friction.mu0};
  for (const v1::Wave& wave : friction.waves) input.waves.push_back({wave.amplitude, wave.wavelength, wave.phase});
  return input;
}

}  // namespace

Test described(const v1::Setup& setup) {
  Test test;
  test.specimen = {.diameter = stated(setup.diameter),
                   .inner_diameter = stated(setup.inner_diameter),
                   .width = stated(setup.width),
                   .height = stated(setup.height),
                   .modulus = stated_stiffness(setup.modulus),
                   .bending_stiffness = stated_stiffness(setup.bending_stiffness)};
  test.rig = {.span = stated(setup.span),
              .stiffness = stated(setup.load_train_stiffness),
              .roller_radius = stated(setup.roller_radius)};
  return test;
}

Test with(Test test, const v1::Friction& friction) {
  test.friction = friction_of(friction);
  return test;
}

Test with(Test test, const v1::Programme& programme) {
  test.stage = {.program = programme.stages, .step = programme.step};
  return test;
}

Test with(Test test, const v1::Record& record) {
  RecordInput& input = test.record.emplace(RecordInput{.file = "the record"});
  Table table{input.file, {}, {}};
  const auto add = [&](std::optional<std::string>& title, const char* words, const std::vector<double>& values) {
    if (values.empty()) return;
    title = words;
    if (!table.columns.empty() && values.size() != table.rows())
      throw InputError({.problem = fmt::format("{} has {} readings, where {} has {}", words, values.size(),
                                               table.columns.front().name, table.rows()),
                        .remedy = "pass columns of one length",
                        .key = "record"});
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isfinite(values[i]))
        throw InputError({.problem = fmt::format("Reading {} of {} is not a finite number", i, words),
                          .remedy = "leave such readings out",
                          .key = "record"});
    table.columns.push_back({words, values});
  };
  add(input.stage, "stage [m]", record.stage);
  add(input.deflection, "deflection [m]", record.deflection);
  add(input.force, "force [N]", record.force);
  if (table.columns.empty())
    throw InputError({.problem = "The record has no readings",
                      .remedy = "pass two of stage, deflection and force",
                      .key = "record"});
  table.lines.resize(table.rows());
  std::iota(table.lines.begin(), table.lines.end(), std::size_t{1});
  input.given = std::make_shared<const Table>(std::move(table));
  return test;
}

Test checked(const Test& test) {
  Test read = read_case(to_toml(test), "");
  if (read.friction) read.friction->points = test.friction->points;
  if (read.record) read.record->given = test.record->given;
  return read;
}

Json field(const Json& group, const char* name) { return group.is_object() ? group.value(name, Json()) : Json(); }

double number(const Json& value) { return value.is_number() ? value.get<double>() : v1::not_known; }

v1::Estimate estimate(const Json& value) {
  const Json interval = field(value, "interval95");
  const bool is_known = interval.is_array() && interval.size() == 2;
  return {number(field(value, "value")), number(field(value, "standard_error")),
          is_known ? number(interval[0]) : v1::not_known, is_known ? number(interval[1]) : v1::not_known};
}

v1::Error error_of(InputFault fault) {
  if (fault.file.empty()) fault.line = 0;  // of a text that the user has not seen
  v1::Error error(InputError(fault).what(), fault.problem, fault.remedy);
  error.key = fault.key;
  error.file = fault.file;
  error.line = fault.line;
  return error;
}

}  // namespace flexslip::library

namespace flexslip::v1 {

Error::Error(const std::string& words, std::string what_is_wrong, std::string what_to_do)
    : std::runtime_error(words), problem(std::move(what_is_wrong)), remedy(std::move(what_to_do)) {}
Error::~Error() = default;

std::string version() { return FLEXSLIP_VERSION; }

}  // namespace flexslip::v1
