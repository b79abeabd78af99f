// The elastica on edges as universal functions of NumPy, which do what is not mechanics: broadcasting, strides, types, `out`, and the interpreter's
// lock, which is released.
#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <cstddef>
#include <exception>
#include <span>

#include <Python.h>
#define NPY_NO_DEPRECATED_API NPY_1_22_API_VERSION
#include <numpy/arrayobject.h>
#include <numpy/ufuncobject.h>
#include <pybind11/pybind11.h>

#include "fibre/batch.h"
#include "fibre/batch_inverse.h"
#include "fibre/elastica.h"
#include "parts.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;

constexpr std::size_t block = 1024;  // states at a time: their arrays stay in the nearest cache, strided ones as well

using Columns = std::array<const double*, 6>;

// Column by column, what a function of two arrays gives.
struct TwoOf {
  StateArrays states{0};
  Columns operator()(std::span<const double> S, std::span<const double> q) {
    states = fibre_states({S, q});
    return {states.w.data(), states.F.data()};
  }
};
struct Slopes {
  SlopeArrays states{0};
  Columns operator()(std::span<const double> S, std::span<const double> q) {
    states = fibre_states_slopes({S, q});
    Columns columns{};
    std::copy_n(states.columns().begin(), columns.size(), columns.begin());
    return columns;
  }
};
struct Inverse {
  InverseArrays states{};
  Columns operator()(std::span<const double> w, std::span<const double> F) {
    states = fibre_states_from_forces(w, F);
    return {states.S.data(), states.q.data()};
  }
};
struct WholeState {
  std::array<std::array<double, block>, 4> values{};  // theta0, Pn, U, curvature
  Columns operator()(std::span<const double> S, std::span<const double> q) {
    for (std::size_t i = 0; i < S.size(); ++i) {
      const FibreState state = fibre_state(S[i], q[i]);
      const bool is_there = state.status == FibreStatus::ok;
      values[0][i] = is_there ? state.theta0 : NAN;
      values[1][i] = is_there ? state.Pn : NAN;
      values[2][i] = is_there ? state.U : NAN;
      values[3][i] = is_there ? curvature_at_midspan(state) : NAN;
    }
    return {values[0].data(), values[1].data(), values[2].data(), values[3].data()};
  }
};

std::span<const double> gathered(const char* from, npy_intp step, std::size_t count, double* into) {
  if (step == sizeof(double)) return {reinterpret_cast<const double*>(from), count};  // NOLINT: NumPy's aligned doubles
  for (std::size_t i = 0; i < count; ++i)
    into[i] = *reinterpret_cast<const double*>(from + static_cast<npy_intp>(i) * step);
  return {into, count};
}

// What is computed on the way to a state divides by zero at times, of which NumPy would warn.
class WithoutFlags {
 public:
  WithoutFlags() { std::feholdexcept(&before_); }
  ~WithoutFlags() { std::fesetenv(&before_); }
  WithoutFlags(const WithoutFlags&) = delete;
  WithoutFlags& operator=(const WithoutFlags&) = delete;

 private:
  std::fenv_t before_{};
};

// A loop of NumPy's: without the interpreter's lock, and aligned. What is outside of the domain is NaN; who calls has looked.
template <class Function, std::size_t outputs>
void loop(char** arrays, const npy_intp* dimensions, const npy_intp* steps, void* /*data*/) {
  const WithoutFlags guard;
  Function function;
  std::array<double, block> first,
      second;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled where they are needed
  const auto all = static_cast<std::size_t>(dimensions[0]);
  for (std::size_t begin = 0; begin < all; begin += block) {
    const std::size_t count = std::min(block, all - begin);
    const auto at = [&](std::size_t k) { return arrays[k] + static_cast<npy_intp>(begin) * steps[k]; };
    Columns columns{};
    try {
      columns =
          function(gathered(at(0), steps[0], count, first.data()), gathered(at(1), steps[1], count, second.data()));
    } catch (const std::exception&) {
      first.fill(NAN);
      columns.fill(first.data());
    }
    for (std::size_t k = 0; k < outputs; ++k) {
      char* to = at(2 + k);
      if (steps[2 + k] == sizeof(double))
        std::copy_n(columns[k], count, reinterpret_cast<double*>(to));  // NOLINT: as above
      else
        for (std::size_t i = 0; i < count; ++i)
          *reinterpret_cast<double*>(to + static_cast<npy_intp>(i) * steps[2 + k]) = columns[k][i];
    }
  }
}

template <class Function, std::size_t outputs>
py::object ufunc(const char* name, const char* what) {
  static PyUFuncGenericFunction loops[] = {&loop<Function, outputs>};
  static char types[2 + outputs];  // NOLINT(modernize-avoid-c-arrays): as NumPy has it
  static void* data[] = {nullptr};
  std::fill(std::begin(types), std::end(types), static_cast<char>(NPY_DOUBLE));
  return py::reinterpret_steal<py::object>(
      PyUFunc_FromFuncAndData(loops, data, types, 1, 2, static_cast<int>(outputs), PyUFunc_None, name, what, 0));
}

void import_numpy() {
  if (_import_array() < 0 || _import_umath() < 0) throw py::error_already_set();
}

}  // namespace

void add_states(py::module_& module) {
  import_numpy();
  module.attr("states") = ufunc<TwoOf, 2>("states", "w, F of S, q; NaN where there is no state");
  module.attr("states_slopes") = ufunc<Slopes, 6>("states_slopes", "w, F, w_S, w_q, F_S, F_q of S, q");
  module.attr("states_from_forces") =
      ufunc<Inverse, 2>("states_from_forces", "S, q of w, F; NaN where no friction explains them");
  module.attr("states_more") = ufunc<WholeState, 4>("states_more", "theta0, Pn, U, curvature of S, q");
  module.attr("largest_q") = largest_q;
}

}  // namespace flexslip::python
