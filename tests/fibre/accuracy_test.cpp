// Measures the section "Errors" of docs/numerics.md. To write it: tools/write-numerics --errors.
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

// The section "Errors" of docs/numerics.md.
std::string document() {
  std::ostringstream out;
  const auto states = measured_states();
  const auto worst = [](double error) { return number("%.0e", rounded_up(error)); };
  const auto worst_of = [&](std::string_view quantity) { return worst(states.of(quantity).error * unit); };
  out << "## Errors\n\nErrors of deflections are at most " << worst_of("w") << ", and errors of forces at most "
      << worst_of("F / condition") << R"( times the condition number, over the whole branch.

The reference has 40 digits. The working group has S from 1.001 to 1.6 and q from −1 to 2. Errors are relative, in units of 2⁻⁵² = 2.2e-16, rounded up to one digit. Two scales differ:

- Errors of F and its slopes are divided by the condition number 1 + |(S − 1) F_S/F| + |q F_q/F|, the effect of rounding S − 1 and q.
- The error of a slope X_S is relative to the larger of |X_S| and |X|/(S − 1), the error of X_q to the larger of |X_q| and |X|/(1 + |q|).

)";
  write_tables(out, states, {"w", "Pn", "theta0", "U", "F / condition", "w_S", "w_q", "F_S", "F_q"});
  Band table{};
  for (const auto& band : measured_table()) {
    table.w = std::max(table.w, band.w);
    table.F = std::max(table.F, band.F);
    table.S_slopes = std::max(table.S_slopes, band.S_slopes);
    table.q_slopes = std::max(table.q_slopes, band.q_slopes);
  }
  out << "\n**Table of states.** The relative error at 24,000 random states is at most " << worst(table.w) << " in w, "
      << worst(table.F) << " in F, " << worst(table.S_slopes) << " in slopes along S, and " << worst(table.q_slopes)
      << " in slopes along q. States beyond the table and near the end of the branch are exact.\n\n";
  const auto elliptic = measured_elliptic();
  out << "**Elliptic functions.** These are the maximum errors for u ≤ K(m), in the same units:";
  const char* separator = " ";
  for (const char* quantity : {"sn", "cn", "dn", "1 - cn", "P", "R", "E(u)"}) {
    out << separator << number("%g", rounded_up(elliptic.of(quantity).error)) << " in " << quantity;
    separator = ", ";
  }
  out << ". The error of cn is absolute, because cn vanishes at K.\n\n";
  const auto digits = [](double error) { return number("%.0f", std::max(0.0, std::floor(-std::log10(error * unit)))); };
  out << "**Why not the AGM?** The closed forms from an arithmetic–geometric ladder lose digits of S − 1. Digits that "
         "remain at given S − 1, for m = 3/4:";
  separator = " ";
  double program = 0;
  for (const auto& [excess, agm, integrals] : digits_of_S()) {
    out << separator << digits(agm) << " at " << number("%g", excess);
    separator = ", ";
    program = std::max(program, integrals);
  }
  out << ". The integrals P and R keep " << digits(program) << " at all of these.\n";
  return out.str();
}

}  // namespace

TEST_CASE("docs/numerics.md has the measured errors (outside)") {
  const std::string written = document();
  if (const char* name = std::getenv("FLEXSLIP_WRITE_ERRORS")) {
    std::ofstream file(name);
    file << written;
    REQUIRE(file.good());
    return;
  }
  std::ifstream file(FLEXSLIP_SOURCE_DIR "/docs/numerics.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  const auto from = page.find("## Errors\n"), to = page.find("\n## Times\n");
  REQUIRE(from < to);
  REQUIRE(to != std::string::npos);
  INFO("tools/write-numerics --errors writes them anew");
  CHECK(page.substr(from, to - from) == written);
}

}  // namespace flexslip
