// The elastica, on knife edges and on rollers, as universal functions of NumPy. NumPy handles
// broadcasting, strides, types, `out`, and releases the interpreter's lock.
#include <algorithm>
#include <array>
#include <cfenv>
#include <cstddef>
#include <exception>
#include <span>
#include <utility>

#include <Python.h>
#define NPY_NO_DEPRECATED_API NPY_1_22_API_VERSION
#include <numpy/arrayobject.h>
#include <numpy/ufuncobject.h>
#include <pybind11/pybind11.h>

#include "case/mechanics.h"
#include "fibre/batch.h"
#include "fibre/batch_inverse.h"
#include "fibre/elastica.h"
#include "fibre/supported_state.h"
#include "parts.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;

constexpr std::size_t block =
    1024;  // states per block, so that their arrays stay in the nearest cache, also with strides

constexpr std::size_t most_outputs = 9;
using Columns = std::array<const double*, most_outputs>;
using Numbers = std::span<const double>;

// A function of arrays that returns columns.
struct TwoOf {
  static constexpr std::size_t inputs = 2, outputs = 2;
  StateArrays states{0};
  Columns operator()(Numbers S, Numbers q) {
    states = fibre_states({S, q});
    return {states.w.data(), states.F.data()};
  }
};
struct Slopes {
  static constexpr std::size_t inputs = 2, outputs = 6;
  SlopeArrays states{0};
  Columns operator()(Numbers S, Numbers q) {
    states = fibre_states_slopes({S, q});
    Columns columns{};
    std::copy_n(states.columns().begin(), outputs, columns.begin());
    return columns;
  }
};
struct Inverse {
  static constexpr std::size_t inputs = 2, outputs = 2;
  InverseArrays states{};
  Columns operator()(Numbers w, Numbers F) {
    states = fibre_states_from_forces(w, F);
    return {states.S.data(), states.q.data()};
  }
};
// A function of single states that returns n numbers; NaN if there is no state.
template <std::size_t n>
struct Each {
  std::array<std::array<double, block>, n> values{};
  void put(std::size_t i, const std::array<double, n>& numbers, bool is_there) {
    for (std::size_t k = 0; k < n; ++k) values[k][i] = is_there ? numbers[k] : NAN;
  }
  Columns columns() const {
    Columns out{};
    for (std::size_t k = 0; k < n; ++k) out[k] = values[k].data();
    return out;
  }
};

struct WholeState {
  static constexpr std::size_t inputs = 2, outputs = 4;
  Each<outputs> each{};  // theta0, Pn, U, curvature
  Columns operator()(Numbers S, Numbers q) {
    for (std::size_t i = 0; i < S.size(); ++i) {
      const FibreState state = fibre_state(S[i], q[i]);
      const bool is_there = state.status == FibreStatus::ok;
      each.put(i, {state.theta0, state.Pn, state.U, is_there ? curvature_at_midspan(state) : NAN}, is_there);
    }
    return each.columns();
  }
};

std::array<double, 9> numbers_of(const SupportedState& state) {
  return {state.q, state.F, state.theta0, state.Pn, state.U, state.curvature, state.length, state.slid, state.imaged};
}

struct OnRollers {
  static constexpr std::size_t inputs = 4, outputs = 9;
  Each<outputs> each{};
  Columns operator()(Numbers w, Numbers q, Numbers radius, Numbers thickness) {
    for (std::size_t i = 0; i < w.size(); ++i) {
      const SupportedState state = state_on_supports(w[i], q[i], {radius[i], 0.5 * thickness[i]});
      each.put(i, numbers_of(state), state.status == FibreStatus::ok);
    }
    return each.columns();
  }
};
struct InverseOnRollers {
  static constexpr std::size_t inputs = 4, outputs = 2;
  Each<outputs> each{};
  Columns operator()(Numbers w, Numbers F, Numbers radius, Numbers thickness) {
    for (std::size_t i = 0; i < w.size(); ++i) {
      const SupportedState state = state_on_supports_from_force(w[i], F[i], {radius[i], 0.5 * thickness[i]});
      each.put(i, {state.length, state.q}, state.status == FibreStatus::ok);
    }
    return each.columns();
  }
};

std::span<const double> gathered(const char* from, npy_intp step, std::size_t count, double* into) {
  if (step == sizeof(double)) return {reinterpret_cast<const double*>(from), count};  // NOLINT: NumPy's aligned doubles
  for (std::size_t i = 0; i < count; ++i)
    into[i] = *reinterpret_cast<const double*>(from + static_cast<npy_intp>(i) * step);
  return {into, count};
}

// Restores the floating-point flags. Intermediate results divide by zero at times, and NumPy would
// warn.
class WithoutFlags {
 public:
  WithoutFlags() { std::feholdexcept(&before_); }
  ~WithoutFlags() { std::fesetenv(&before_); }
  WithoutFlags(const WithoutFlags&) = delete;
  WithoutFlags& operator=(const WithoutFlags&) = delete;

 private:
  std::fenv_t before_{};
};

// A loop of NumPy without the interpreter's lock, on aligned data. Values outside the domain are
// NaN; the caller checks.
template <class Function>
void loop(char** arrays, const npy_intp* dimensions, const npy_intp* steps, void* /*data*/) {
  constexpr std::size_t inputs = Function::inputs, outputs = Function::outputs;
  const WithoutFlags guard;
  Function function;
  // Not initialised, because each block fills what it needs.
  std::array<std::array<double, block>, inputs> given;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  const auto all = static_cast<std::size_t>(dimensions[0]);
  for (std::size_t begin = 0; begin < all; begin += block) {
    const std::size_t count = std::min(block, all - begin);
    const auto at = [&](std::size_t k) { return arrays[k] + static_cast<npy_intp>(begin) * steps[k]; };
    Columns columns{};
    try {
      columns = [&]<std::size_t... k>(std::index_sequence<k...>) {
        return function(gathered(at(k), steps[k], count, given[k].data())...);
      }
      (std::make_index_sequence<inputs>());
    } catch (const std::exception&) {
      given[0].fill(NAN);
      columns.fill(given[0].data());
    }
    for (std::size_t k = 0; k < outputs; ++k) {
      char* to = at(inputs + k);
      const npy_intp step = steps[inputs + k];
      if (step == sizeof(double))
        std::copy_n(columns[k], count, reinterpret_cast<double*>(to));  // NOLINT: as above
      else
        for (std::size_t i = 0; i < count; ++i)
          *reinterpret_cast<double*>(to + static_cast<npy_intp>(i) * step) = columns[k][i];
    }
  }
}

template <class Function>
py::object ufunc(const char* name, const char* what) {
  constexpr std::size_t inputs = Function::inputs, outputs = Function::outputs;
  static PyUFuncGenericFunction loops[] = {&loop<Function>};
  static char types[inputs + outputs];  // NOLINT(modernize-avoid-c-arrays): as NumPy has it
  static void* data[] = {nullptr};
  std::fill(std::begin(types), std::end(types), static_cast<char>(NPY_DOUBLE));
  return py::reinterpret_steal<py::object>(PyUFunc_FromFuncAndData(
      loops, data, types, 1, static_cast<int>(inputs), static_cast<int>(outputs), PyUFunc_None, name, what, 0));
}

void import_numpy() {
  if (_import_array() < 0 || _import_umath() < 0) throw py::error_already_set();
}

}  // namespace

void add_states(py::module_& module) {
  import_numpy();
  module.attr("states") = ufunc<TwoOf>("states", "w, F of S, q; NaN where there is no state");
  module.attr("states_slopes") = ufunc<Slopes>("states_slopes", "w, F, w_S, w_q, F_S, F_q of S, q");
  module.attr("states_from_forces") =
      ufunc<Inverse>("states_from_forces", "S, q of w, F; NaN where no friction explains them");
  module.attr("states_more") = ufunc<WholeState>("states_more", "theta0, Pn, U, curvature of S, q");
  module.attr("states_on_rollers") = ufunc<OnRollers>(
      "states_on_rollers", "q, F, theta0, Pn, U, curvature, length, slid, imaged of w, q, radius, thickness");
  module.attr("states_on_rollers_from_forces") =
      ufunc<InverseOnRollers>("states_on_rollers_from_forces", "length, q of w, F, radius, thickness");
  module.attr("largest_q") = largest_q;
  module.attr("deepest_on_supports") = deepest_on_supports;
  module.attr("widest_supports") = widest_supports;
  module.attr("thickest") = thickest;
}

}  // namespace flexslip::python
