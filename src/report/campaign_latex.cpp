#include "report/campaign_latex.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "answers/campaign_fields.h"
#include "io/text_table.h"
#include "report/campaign_units.h"
#include "report/digits.h"

namespace flexslip {
namespace {

// "nN mm^2" as "nN\,mm$^{2}$".
std::string latex_unit(std::string_view unit) {
  std::string out;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (unit[i] == ' ') {
      out += "\\,";
    } else if (unit[i] == 'u') {
      out += "$\\mu$";
    } else if (unit[i] == '^' && i + 1 < unit.size()) {
      out += fmt::format("$^{{{}}}$", unit[++i]);
    } else {
      out += unit[i];
    }
  }
  return out;
}

std::string minus(const std::string& text) {
  return text.empty() || text.front() != '-' ? text : "$-$" + text.substr(1);
}

std::string cell(const Estimate& estimate, double factor) {
  const MatchedDigits digits = matched_digits(estimate, factor);
  return digits.error.empty() ? minus(digits.value) : fmt::format("{} $\\pm$ {}", minus(digits.value), digits.error);
}

std::string cell(const Spread& spread, double factor, int decimals) {
  if (spread.count == 0) return "--";
  return fmt::format("{:.{}f} ({:.{}f}, {:.{}f})", factor * spread.mean, decimals, factor * spread.min, decimals,
                     factor * spread.max, decimals);
}

std::string row_of(const CampaignTest& test, const CampaignUnits& units) {
  const TestSummary& summary = test.summary.value();
  const auto of_wave = [&](const std::optional<Estimate>& estimate, double factor) {
    if (!estimate) return std::string("--");
    return summary.wave_claimed ? cell(*estimate, factor) : fmt::format("[{}]", cell(*estimate, factor));
  };
  const std::string mean_friction =
      summary.mu0_is_bound ? fmt::format("$\\leq$ {}", significant(summary.mu0.high, 2)) : cell(summary.mu0, 1);
  return fmt::format("{}{} & {} & {} & {} & {} & {} & {} & {} \\\\\n", latex_escaped(test.name),
                     summary.suspect ? "$^{\\times}$" : "", mean_friction, of_wave(summary.amplitude, 1),
                     of_wave(summary.wavelength, units.wavelength.factor),
                     cell(summary.bending_stiffness, units.bending_stiffness.factor),
                     significant(units.residual.factor * summary.residual_rms, 3), summary.drops,
                     std::lround(100 * summary.friction_share));
}

std::string tests_of(const Campaign& campaign) {
  const CampaignUnits units = units_of(campaign);
  const std::string head = fmt::format(
      "Test & $\\mu_0$ & $A$ & $\\lambda$ ({}) & $EI$ ({}) & Residual ({}) & Drops & Friction (\\%) \\\\\n",
      latex_unit(units.wavelength.name), latex_unit(units.bending_stiffness.name), latex_unit(units.residual.name));
  std::string out =
      "{\\footnotesize\\setlength{\\tabcolsep}{4pt}\n\\begin{longtable}{lrrrrrrr}\n"
      "\\caption{Friction in bending tests, by the sawtooth of their force curves: mean friction $\\mu_0$, amplitude "
      "$A$ "
      "and wavelength $\\lambda$ of one wave of friction along the specimen (in brackets where it is only "
      "indicative), bending stiffness $EI$, root mean square of measured less model force, drops of the force, and the "
      "share "
      "of "
      "the work that was friction; $\\pm$ standard error, $\\times$ suspect.}\n"
      "\\label{tab:friction}\\\\\n";
  out += "\\toprule\n" + head + "\\midrule\n\\endfirsthead\n\\toprule\n" + head +
         "\\midrule\n\\endhead\n\\bottomrule\n\\endfoot\n";
  const std::array<std::pair<SawtoothCategory, const char*>, 3> categories{
      {{SawtoothCategory::clear, "Clear sawtooth"},
       {SawtoothCategory::nominal, "Nominal sawtooth"},
       {SawtoothCategory::none, "Almost no sawtooth"}}};
  bool first = true;
  for (const auto& [category, title] : categories) {
    std::string rows;
    for (const auto& test : campaign.tests)
      if (test.summary && test.summary->category == category) rows += row_of(test, units);
    if (rows.empty()) continue;
    out += fmt::format("{}\\multicolumn{{8}}{{l}}{{\\emph{{{}}}}} \\\\*\n{}", first ? "" : "\\addlinespace\n", title,
                       rows);
    first = false;
  }
  if (first) out += "\\multicolumn{8}{l}{No test with an answer.} \\\\\n";
  return out + "\\end{longtable}}\n";
}

std::string categories_of(const Campaign& campaign) {
  const TableUnit length = units_of(campaign).wavelength;
  std::string out = fmt::format(
      "\\begin{{table}}\n\\centering\\footnotesize\n\\caption{{Friction by category of the sawtooth: mean (min, "
      "max).}}\n\\label{{tab:friction-categories}}\n\\begin{{tabular}}{{llrrrr}}\n\\toprule\n"
      "Sawtooth & Suspects & Tests & $\\mu_0$ & $A$ & $\\lambda$ ({}) \\\\\n\\midrule\n",
      latex_unit(length.name));
  for (const auto& category : campaign.categories)
    for (const auto* spreads : {&category.without_suspects, &category.with_suspects})
      out += fmt::format(
          "{} & {} & {} & {} & {} & {} \\\\\n", spreads == &category.without_suspects ? key_of(category) : "",
          spreads == &category.without_suspects ? "left out" : "counted in", spreads->tests, cell(spreads->mu0, 1, 3),
          cell(spreads->amplitude, 1, 3), cell(spreads->wavelength, length.factor, 1));
  return out + "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
}

std::string with_interval(const Estimate& estimate, double factor) {
  const MatchedDigits digits = matched_digits(estimate, factor);
  return digits.low.empty() ? digits.value : fmt::format("{} ({}, {})", digits.value, digits.low, digits.high);
}

std::string specimens_of(const Campaign& campaign) {
  const auto lines = specimen_lines(campaign);
  if (lines.empty()) return "";
  const TableUnit length = units_of(campaign).wavelength;
  std::string out = fmt::format(
      "\n\\begin{{table}}\n\\centering\\footnotesize\n\\caption{{Friction between specimens, suspects left out: mean "
      "of "
      "$\\mu_0$ and its standard deviation between specimens; middle roughness $\\sigma$ and correlation length "
      "$\\ell$ ({}) "
      "and the factor by which specimens differ; 95\\,\\% intervals.}}\n\\label{{tab:friction-specimens}}\n"
      "\\begin{{tabular}}{{llrrr}}\n\\toprule\nSawtooth & & Tests & Typical & Differ by \\\\\n\\midrule\n",
      latex_unit(length.name));
  for (const auto& line : lines) {
    const bool is_length = line.parameter == "correlation_length";
    const char* symbol = is_length ? "$\\ell$" : line.by_factors ? "$\\sigma$" : "$\\mu_0$";
    const std::string spread = line.between->population.spread_is_bound
                                   ? fmt::format("$\\leq$ {}", significant(line.spread.high, 2))
                                   : with_interval(line.spread, 1);
    out += fmt::format("{} & {} & {} & {} & {}{} \\\\\n", line.by_factors ? "" : line.category, symbol,
                       line.between->tests.size(), with_interval(line.typical, is_length ? length.factor : 1),
                       line.by_factors ? "$\\times$ " : "$\\pm$ ", spread);
  }
  return out + "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
}

std::string shared_of(const Campaign& campaign) {
  if (campaign.shared.empty()) return "";
  std::string out =
      "\n\\begin{table}\n\\centering\\footnotesize\n\\caption{One value for several tests, with its 95\\,\\% interval; "
      "$p$: probability that tests that share it differ as much.}\n\\label{tab:friction-shared}\n"
      "\\begin{tabular}{lrlrr}\n\\toprule\nParameter & Value & Unit & Tests & $p$ \\\\\n\\midrule\n";
  for (const auto& shared : campaign.shared) {
    if (!std::isfinite(shared.estimate.value)) {
      out += fmt::format("{} & not told & & {} & \\\\\n", latex_escaped(shared.name), shared.tests);
      continue;
    }
    const TableUnit unit = print_unit(shared.estimate.value, shared.unit);
    out += fmt::format("{} & {} & {} & {} & {} \\\\\n", latex_escaped(shared.name),
                       with_interval(shared.estimate, unit.factor), latex_unit(unit.name), shared.tests,
                       shared.agreement < 1e-4 ? "$<$ 0.0001" : significant(shared.agreement, 2));
  }
  return out + "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
}

}  // namespace

std::string latex_escaped(std::string_view text) {
  std::string out;
  for (const char c : printable(text)) switch (c) {
      case '\\':
        out += "\\textbackslash{}";
        break;
      case '{':
      case '}':
      case '$':
      case '&':
      case '#':
      case '_':
      case '%':
        out += '\\';
        out += c;
        break;
      case '^':
        out += "\\textasciicircum{}";
        break;
      case '~':
        out += "\\textasciitilde{}";
        break;
      case '<':
        out += "\\textless{}";
        break;
      case '>':
        out += "\\textgreater{}";
        break;
      case '|':
        out += "\\textbar{}";
        break;
      case '[':  // an argument of the row's end before it
      case '*':
        out += fmt::format("{{{}}}", c);
        break;
      case '"':
        out += "''";
        break;
      default:
        out += c;
    }
  return out;
}

std::string campaign_latex(const Campaign& campaign) {
  return fmt::format(
      "% FlexSlip {}. Needs \\usepackage{{booktabs,longtable}}; letters beyond those of the document's fonts, in "
      "names, "
      "need others.\n{}\n{}{}{}",
      FLEXSLIP_VERSION, tests_of(campaign), categories_of(campaign), specimens_of(campaign), shared_of(campaign));
}

}  // namespace flexslip
