// The JavaScript interface of the mechanics; the only file that depends on Emscripten. Arrays are
// copied, because memory may move as it grows. Failures are returned as sentences.
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include "studio/studio.h"

namespace flexslip::studio {
namespace {

using emscripten::val;

template <class Number>
val copied(const std::vector<Number>& column) {
  return val(emscripten::typed_memory_view(column.size(), column.data())).template call<val>("slice");
}

std::vector<double> column(const val& numbers) { return emscripten::convertJSArrayToNumberVector<double>(numbers); }

double number(const val& object, const char* name) { return object[name].as<double>(); }

RigInput rig_from(const val& rig) {
  return {.span = number(rig, "span"),
          .depth = number(rig, "diameter"),
          .bending_stiffness = number(rig, "bendingStiffness"),
          .stiffness = number(rig, "stiffness"),
          .roller_radius = number(rig, "tipRadius"),
          .friction = {column(rig["friction"]["length"]), column(rig["friction"]["mu"])}};
}

val object_of(const State& state) {
  val object = val::object();
  object.set("deflection", state.deflection);
  object.set("force", state.force);
  object.set("drawn", state.drawn);
  object.set("friction", state.friction);
  return object;
}

val object_of(const Loading& loading) {
  val object = val::object();
  object.set("status", std::string(loading.status));
  object.set("stage", copied(loading.stage));
  object.set("deflection", copied(loading.deflection));
  object.set("force", copied(loading.force));
  object.set("drawn", copied(loading.drawn));
  object.set("friction", copied(loading.friction));
  object.set("motion", copied(loading.motion));
  val snaps = val::array();
  for (const Jump& jump : loading.snaps) {
    val snap = val::object();
    snap.set("stage", jump.stage);
    snap.set("from", object_of(jump.from));
    snap.set("to", object_of(jump.to));
    snaps.call<void>("push", snap);
  }
  object.set("snaps", snaps);
  return object;
}

val pair(const Point& point) {
  val both = val::array();
  both.call<void>("push", point.x);
  both.call<void>("push", point.y);
  return both;
}

val object_of(const Shape& shape) {
  std::vector<double> x, y;
  for (const Point& point : shape.axis) {
    x.push_back(point.x);
    y.push_back(point.y);
  }
  val object = val::object();
  object.set("x", copied(x));
  object.set("y", copied(y));
  val contacts = val::array();
  contacts.call<void>("push", pair(shape.left));
  contacts.call<void>("push", pair(shape.right));
  object.set("contact", contacts);
  object.set("slope", shape.slope);
  object.set("normal", shape.normal);
  object.set("tangential", shape.tangential);
  object.set("force", shape.force);
  object.set("slid", shape.slid);
  return object;
}

template <class Compute>
val answer(const Compute& compute) {
  val object = val::object();
  try {
    object.set("result", compute());
  } catch (const std::exception& error) {
    object.set("error", std::string(error.what()));
  }
  return object;
}

val simulated(const val& rig, const val& programme, double step, int points) {
  return answer([&] {
    return object_of(simulate(rig_from(rig), column(programme), step > 0 ? std::optional(step) : std::nullopt, points));
  });
}

val sketched(const val& rig, double farthest, int steps) {
  return answer([&] { return object_of(sketch(rig_from(rig), farthest, steps)); });
}

val in_equilibrium(const val& rig, double longest, int points) {
  return answer([&] { return object_of(equilibrium(rig_from(rig), longest, points)); });
}

val shaped(const val& rig, double deflection, double friction, int points, double beyond) {
  return answer([&] { return object_of(shape(rig_from(rig), deflection, friction, points, beyond)); });
}

val quantity_in(const std::string& words, const std::string& kind) {
  return answer([&] { return val(quantity(words, kind)); });
}

val unit_in(const std::string& words, const std::string& kind) {
  return answer([&] { return val(unit(words, kind)); });
}

val linear(const val& rig, double deflection) {
  return answer([&] { return val(euler_bernoulli(rig_from(rig), deflection)); });
}

}  // namespace

EMSCRIPTEN_BINDINGS(mechanics) {
  emscripten::function("simulate", &simulated);
  emscripten::function("sketch", &sketched);
  emscripten::function("equilibrium", &in_equilibrium);
  emscripten::function("shape", &shaped);
  emscripten::function("linear", &linear);
  emscripten::function("quantity", &quantity_in);
  emscripten::function("unit", &unit_in);
}

}  // namespace flexslip::studio
