// docs/accuracy.md is what this run measures. To write it: tools/write-accuracy.
#include "tests/fibre/accuracy.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include <doctest/doctest.h>

#include "fibre/batch.h"
#include "fibre/state_table.h"
#include "tests/uniform.h"

namespace flexslip {

void Worsts::add(std::string_view group, std::string_view quantity, double error, const std::string& row) {
  auto worst = std::find_if(all_.begin(), all_.end(),
                            [&](const Worst& w) { return w.group == group && w.quantity == quantity; });
  if (worst == all_.end()) worst = all_.insert(all_.end(), Worst{std::string(group), std::string(quantity), row, 0, 0});
  ++worst->rows;
  if (!(error <= worst->error)) {
    worst->error = error;
    worst->row = row;
  }
}

const Worst* Worsts::find(std::string_view group, std::string_view quantity) const {
  for (const auto& worst : all_)
    if (worst.group == group && worst.quantity == quantity) return &worst;
  return nullptr;
}

const Worst& Worsts::of(std::string_view quantity) const {
  const Worst* worst = nullptr;
  for (const auto& w : all_)
    if (w.quantity == quantity && (!worst || !(w.error <= worst->error))) worst = &w;
  REQUIRE(worst != nullptr);
  return *worst;
}

std::string row_name(const char* first, double a, const char* second, double b) {
  char text[100];
  std::snprintf(text, sizeof text, "%s = %.17g, %s = %.17g", first, a, second, b);
  return text;
}

namespace {

// To one significant digit, upwards: the last bits may differ between compilers and mathematical libraries.
double rounded_up(double x) {
  if (x == 0) return 0;
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  const double digits = x / power;
  return (digits - std::floor(digits) < 1e-9 ? std::floor(digits) : std::ceil(digits)) * power;
}

std::string number(const char* format, double x) {
  char text[40];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

// The worst of each group, in units of 2^-52.
void write_tables(std::ostream& out, const Worsts& worsts, const std::vector<std::string>& quantities) {
  out << "| group | rows |";
  for (const auto& quantity : quantities) out << " " << quantity << " |";
  out << "\n|---|---|";
  for (std::size_t i = 0; i < quantities.size(); ++i) out << "---|";
  std::string group;
  for (const auto& worst : worsts.all()) {
    if (worst.group == group) continue;
    group = worst.group;
    out << "\n| " << group << " | " << worst.rows << " |";
    for (const auto& quantity : quantities) {
      const Worst* found = worsts.find(group, quantity);
      out << " " << (found ? number("%g", rounded_up(found->error)) : "") << " |";
    }
  }
  out << "\n";
}

// Worst errors of the table for q in a band.
struct Band {
  double from, to;
  double w, F, S_slopes, q_slopes;
};

std::vector<Band> measured_table() {
  std::vector<Band> bands;
  Uniform uniform;
  constexpr int count = 6;
  for (int i = 0; i < count; ++i) {
    const double width = (table_q.greatest - table_q.least) / count;
    Band band{table_q.least + i * width, table_q.least + (i + 1) * width, 0, 0, 0, 0};
    std::vector<double> S, q;
    for (int j = 0; j < 4000; ++j) {
      S.push_back(1 + std::pow(uniform(0, table_sigma), 2));
      q.push_back(uniform(band.from, band.to));
    }
    const SlopeArrays table = tabulated_states_slopes({S, q});
    const SlopeArrays exact = fibre_states_slopes({S, q});
    for (std::size_t j = 0; j < S.size(); ++j) {
      if (std::isnan(exact.w[j])) continue;
      const double w = exact.w[j], F = exact.F[j];
      const double condition = 1 + std::abs((S[j] - 1) * exact.F_S[j] / F) + std::abs(q[j] * exact.F_q[j] / F);
      const auto error = [](double found, double expected, double size) {
        return std::abs(found - expected) / std::max(std::abs(expected), size);
      };
      band.w = std::max(band.w, std::abs(table.w[j] / w - 1));
      band.F = std::max(band.F, std::abs(table.F[j] / F - 1) / condition);
      band.S_slopes = std::max({band.S_slopes, error(table.w_S[j], exact.w_S[j], w / (S[j] - 1)),
                                error(table.F_S[j], exact.F_S[j], F / (S[j] - 1)) / condition});
      band.q_slopes = std::max({band.q_slopes, error(table.w_q[j], exact.w_q[j], w / (1 + std::abs(q[j]))),
                                error(table.F_q[j], exact.F_q[j], F / (1 + std::abs(q[j]))) / condition});
    }
    bands.push_back(band);
  }
  return bands;
}

std::string document() {
  std::ostringstream out;
  out << R"(# Accuracy

Written by `tools/write-accuracy`, compared by the test `fibre/accuracy`; do not edit. Errors are relative, in units of 2⁻⁵² = 2.2e-16, against the 40-digit values
of `tests/fibre/reference`, rounded up to one digit. The bounds in the headers are asserted over more states than these.

)";
  const auto states = measured_states();
  const auto worst = [&](std::string_view quantity) {
    return number("%.0e", rounded_up(states.of(quantity).error * unit));
  };
  out << "In short: deflections are good to " << worst("w") << ", forces to " << worst("F / condition")
      << " times their condition number, over the whole branch.\n";
  out << R"(
## The elastica: `fibre_state`

F vanishes at the end of the branch: its error is also divided by the condition number 1 + |(S − 1) F_S/F| + |q F_q/F|, what rounding S − 1 and q alone may do.

)";
  write_tables(out, states, {"w", "Pn", "theta0", "U", "F", "F / condition"});
  out << R"(
## Its slopes: `fibre_state_slopes`

The error of X_S is measured by the larger of |X_S| and |X|/(S − 1), that of X_q by the larger of |X_q| and |X|/(1 + |q|), that of F_S and F_q divided by the condition number.

)";
  write_tables(out, states, {"w_S", "w_q", "Pn_S", "Pn_q", "U_S", "U_q", "F_S", "F_q"});
  out << R"(
## The table: `tabulated_states` and `tabulated_states_slopes`

Against `fibre_states_slopes`, 4,000 random states in each row. States beyond the table, and near the end of the branch, are exact.

| q | w | F / condition | w_S, F_S | w_q, F_q |
|---|---|---|---|---|
)";
  for (const auto& band : measured_table())
    out << "| " << number("%g", band.from) << " to " << number("%g", band.to) << " | "
        << number("%.0e", rounded_up(band.w)) << " | " << number("%.0e", rounded_up(band.F)) << " | "
        << number("%.0e", rounded_up(band.S_slopes)) << " | " << number("%.0e", rounded_up(band.q_slopes)) << " |\n";
  out << R"(
## Jacobi's functions: `elliptic_arc` and `jacobi_epsilon`, for u ≤ K(m)

cn vanishes at K: its error is absolute.

)";
  write_tables(out, measured_elliptic(), {"sn", "cn", "dn", "1 - cn", "P", "R", "E(u)"});
  out << R"(
## Why not the AGM

S − 1 at m = 3/4 by the closed forms from one arithmetic–geometric ladder, and by the integrals P and R of `elliptic_arc`; the worst of 64 neighbouring u.

| S − 1 | AGM, relative | digits kept | P and R, relative | digits kept |
|---|---|---|---|---|
)";
  const auto digits = [](double error) { return number("%.0f", std::max(0.0, std::floor(-std::log10(error * unit)))); };
  for (const auto& [excess, agm, program] : digits_of_S())
    out << "| " << number("%.0e", excess) << " | " << number("%.0e", rounded_up(agm * unit)) << " | " << digits(agm)
        << " | " << number("%.0e", rounded_up(program * unit)) << " | " << digits(program) << " |\n";
  return out.str();
}

}  // namespace

TEST_CASE("docs/accuracy.md is what the tables measure (outside)") {
  const std::string written = document();
  if (const char* name = std::getenv("FLEXSLIP_WRITE_ACCURACY")) {
    std::ofstream file(name);
    file << written;
    REQUIRE(file.good());
    return;
  }
  std::ifstream file(FLEXSLIP_SOURCE_DIR "/docs/accuracy.md");
  const std::string committed{std::istreambuf_iterator<char>(file), {}};
  INFO("tools/write-accuracy writes it anew");
  CHECK(committed == written);
}

}  // namespace flexslip
