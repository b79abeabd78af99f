#include "report/campaign_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "fibre/elementary.h"
#include "io/table.h"
#include "io/text_table.h"

namespace flexslip {
namespace {

Cell number(double value) { return std::isnan(value) ? Cell{} : Cell{value}; }
Cell number(std::size_t count) { return static_cast<double>(count); }
Cell words(std::string_view text) { return printable(text); }
Cell yes(bool is) { return std::string(is ? "yes" : "no"); }

CampaignColumn word_column(std::string name, std::string meaning) {
  return {std::move(name), std::nullopt, "", std::move(meaning), ""};
}

CampaignColumn number_column(std::string name, const Kind& kind, std::string unit, std::string meaning) {
  std::string quantity = name;
  return {std::move(name), kind, std::move(unit), std::move(meaning), std::move(quantity)};
}

// A table described column by column: what it is, and how to read it off an item.
template <class Item>
class TableOf {
 public:
  using Read = std::function<Cell(const Item&)>;
  explicit TableOf(std::string name) { table_.name = std::move(name); }

  void add(CampaignColumn column, Read read) {
    table_.columns.push_back(std::move(column));
    reads_.push_back(std::move(read));
  }
  void add(const Item& item) {
    auto& row = table_.rows.emplace_back();
    row.reserve(reads_.size());
    for (const auto& read : reads_) row.push_back(read(item));
  }
  CampaignTable table() const { return table_; }

 private:
  CampaignTable table_;
  std::vector<Read> reads_;
};

// Reads a summary, where there is one.
template <class Read>
auto summarised(Read read) {
  return [read](const CampaignTest& test) { return test.summary ? read(*test.summary) : Cell{}; };
}

// An estimate takes four columns.
template <class Read>
void add_estimate(TableOf<CampaignTest>& table, const std::string& name, const Kind& kind, const std::string& unit,
                  const std::string& meaning, Read read) {
  const auto add = [&](const std::string& suffix, const std::string& what, double ParameterEstimate::*part) {
    table.add({name + suffix, kind, unit, what, name}, [read, part](const CampaignTest& test) {
      const std::optional<ParameterEstimate> estimate =
          test.summary ? read(*test.summary) : std::optional<ParameterEstimate>();
      return estimate ? number((*estimate).*part) : Cell{};
    });
  };
  add("", meaning, &ParameterEstimate::value);
  add("_standard_error", "its standard error", &ParameterEstimate::standard_error);
  add("_low", "lower end of its 95 % interval", &ParameterEstimate::low);
  add("_high", "upper end of its 95 % interval", &ParameterEstimate::high);
}

struct CategoryRow {
  std::string key;
  std::string suspects;  // "without" or "with" them
  const CategorySpread* spread;
};

void add_spread(TableOf<CategoryRow>& table, const std::string& name, const Kind& kind, const std::string& unit,
                const std::string& meaning, Spread CategorySpread::*spread) {
  const auto add = [&](const std::string& suffix, const std::string& what, double Spread::*part) {
    table.add({name + suffix, kind, unit, what, name}, [spread, part](const CategoryRow& row) {
      const Spread& over = (*row.spread).*spread;
      return over.count > 0 ? number(over.*part) : Cell{};
    });
  };
  add("_mean", meaning + ", mean", &Spread::mean);
  add("_min", "smallest", &Spread::min);
  add("_max", "largest", &Spread::max);
  table.add(number_column(name + "_tests", kind::number, "", "tests that it is taken over"),
            [spread](const CategoryRow& row) { return number(((*row.spread).*spread).count); });
}

// The length of the valid UTF-8 character that a text begins with [bytes]; 0 if there is none.
std::size_t character_at(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  if (length < 3) return length;
  const std::uint32_t second = byte(1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool no_character = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90) ||
                            (first == 0xef && second == 0xbf && byte(2) >= 0xbe);
  return overlong || no_character ? 0 : length;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = character_at(text);
    const auto first = static_cast<unsigned char>(text.front());
    if (length == 0)
      out += "\ufffd";
    else if (first < ' ' || first == 0x7f || (first == 0xc2 && static_cast<unsigned char>(text[1]) < 0xa0))
      out += ' ';
    else
      out += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

std::string key_of(const CategorySummary& category) { return category.category ? name_of(*category.category) : "all"; }

CampaignTable test_table(const Campaign& campaign) {
  TableOf<CampaignTest> table("tests");
  table.add(word_column("test", "its name"), [](const CampaignTest& test) { return words(test.name); });
  table.add(word_column("status", "ok, or why not"), [](const CampaignTest& test) { return words(test.status); });
  table.add(word_column("category", "of the sawtooth: clear, nominal, none"),
            summarised([](const TestSummary& test) { return words(name_of(test.category)); }));
  table.add(word_column("suspect", "its standing is suspect or untrusted"),
            summarised([](const TestSummary& test) { return yes(test.suspect); }));
  table.add(word_column("standing", "sound, doubtful, suspect, untrusted: the remarks say why"),
            summarised([](const TestSummary& test) { return words(std::string(name_of(test.standing))); }));
  table.add(word_column("drops_verdict", "not_by_cracks_alone, cracks, cannot_be_told; empty without drops"),
            summarised([](const TestSummary& test) {
              return words(test.drops > 0 ? std::string(name_of(test.drops_verdict)) : "");
            }));
  table.add(word_column("model", "of friction, that was fitted"),
            summarised([](const TestSummary& test) { return words(name_of(test.model)); }));
  using Maybe = std::optional<ParameterEstimate>;
  add_estimate(table, "mu0", kind::number, "", "mean friction over the fibre seen",
               [](const TestSummary& test) { return Maybe(test.mu0); });
  table.add(word_column("mu0_is_bound", "the record does not tell mu0 from 0: mu0_high is its upper limit"),
            summarised([](const TestSummary& test) { return yes(test.mu0_is_bound); }));
  const auto of_roughness = [](ParameterEstimate TestSummary::*estimate) {
    return [estimate](const TestSummary& test) {
      return test.model == ProfileModel::roughness ? Maybe(test.*estimate) : Maybe();
    };
  };
  add_estimate(table, "roughness", kind::number, "", "standard deviation of friction about its mean",
               of_roughness(&TestSummary::roughness));
  add_estimate(table, "correlation_length", kind::length, "m", "of the roughness along the specimen",
               of_roughness(&TestSummary::correlation_length));
  add_estimate(table, "amplitude", kind::number, "", "of the likeliest wave of friction, relative to mu0",
               [](const TestSummary& test) { return test.amplitude; });
  add_estimate(table, "wavelength", kind::length, "m", "of that wave, along the specimen",
               [](const TestSummary& test) { return test.wavelength; });
  add_estimate(table, "phase", kind::angle, "rad", "of that wave, at the length 0",
               [](const TestSummary& test) { return test.phase; });
  table.add(word_column("wave_claimed", "by the evidence; a wave that is not is only indicative"),
            summarised([](const TestSummary& test) { return test.wavelength ? yes(test.wave_claimed) : Cell{}; }));
  add_estimate(table, "bending_stiffness", kind::bending_stiffness, "N m^2", "EI",
               [](const TestSummary& test) { return Maybe(test.bending_stiffness); });
  table.add(number_column("residual_rms", kind::force, "N",
                          "measured force less the mean of the fit run forward, root mean square"),
            summarised([](const TestSummary& test) { return number(test.residual_rms); }));
  table.add(number_column("drops", kind::number, "", "of the force, beyond its noise"),
            summarised([](const TestSummary& test) { return number(test.drops); }));
  table.add(number_column("work_of_fracture", kind::energy, "J", "work on the specimen"),
            summarised([](const TestSummary& test) { return number(test.work_of_fracture); }));
  table.add(number_column("friction_share", kind::number, "", "of it, friction and drops"),
            summarised([](const TestSummary& test) { return number(test.friction_share); }));
  table.add(word_column("reason", "why the status is not ok"),
            [](const CampaignTest& test) { return words(test.reason); });
  table.add(word_column("remarks", ""),
            [](const CampaignTest& test) { return words(fmt::format("{}", fmt::join(test.remarks, "; "))); });
  table.add(word_column("file", "what describes the test"), [](const CampaignTest& test) { return words(test.file); });
  for (const auto& test : campaign.tests) table.add(test);
  return table.table();
}

CampaignTable category_table(const Campaign& campaign) {
  TableOf<CategoryRow> table("categories");
  table.add(word_column("category", "of the sawtooth"), [](const CategoryRow& row) { return words(row.key); });
  table.add(word_column("suspects", "left out or counted in"),
            [](const CategoryRow& row) { return words(row.suspects); });
  table.add(number_column("tests", kind::number, "", "in the category"),
            [](const CategoryRow& row) { return number(row.spread->tests); });
  add_spread(table, "mu0", kind::number, "", "mean friction", &CategorySpread::mu0);
  add_spread(table, "amplitude", kind::number, "", "of one wave of friction, relative to mu0",
             &CategorySpread::amplitude);
  add_spread(table, "wavelength", kind::length, "m", "of that wave, along the specimen", &CategorySpread::wavelength);
  for (const auto& category : campaign.categories) {
    table.add({key_of(category), "without", &category.without_suspects});
    table.add({key_of(category), "with", &category.with_suspects});
  }
  return table.table();
}

std::vector<SpecimenLine> specimen_lines(const Campaign& campaign) {
  std::vector<SpecimenLine> lines;
  const auto exponential = [](const ParameterEstimate& log) {
    const double value = elementary::exp(log.value);
    return ParameterEstimate{value, value * log.standard_error, elementary::exp(log.low), elementary::exp(log.high)};
  };
  for (const auto& category : campaign.categories) {
    const auto add = [&](const char* parameter, const char* unit, const std::optional<BetweenSpecimens>& between) {
      if (!between) return;
      const Population& found = between->population;
      const bool by_factors = &between != &category.mu0;
      lines.push_back({key_of(category), parameter, unit, by_factors, by_factors ? exponential(found.mean) : found.mean,
                       by_factors ? exponential(found.spread) : found.spread, &*between});
    };
    add("mu0", "1", category.mu0);
    add("roughness", "1", category.log_roughness);
    add("correlation_length", "m", category.log_length);
  }
  return lines;
}

CampaignTable specimen_table(const Campaign& campaign) {
  TableOf<SpecimenLine> table("specimens");
  table.add(word_column("category", "of the sawtooth, suspects left out"),
            [](const SpecimenLine& line) { return words(line.category); });
  table.add(word_column("parameter", "of friction"), [](const SpecimenLine& line) { return words(line.parameter); });
  table.add(word_column("unit", "of typical, low and high"), [](const SpecimenLine& line) { return words(line.unit); });
  table.add(number_column("tests", kind::number, "", "whose records tell it"),
            [](const SpecimenLine& line) { return number(line.between->tests.size()); });
  const auto add = [&](const std::string& name, const std::string& meaning, ParameterEstimate SpecimenLine::*estimate,
                       double ParameterEstimate::*part) {
    table.add(number_column(name, kind::number, "", meaning),
              [estimate, part](const SpecimenLine& line) { return number(line.*estimate.*part); });
  };
  add("typical", "mean of the specimens, of mu0; of the others the middle one", &SpecimenLine::typical,
      &ParameterEstimate::value);
  add("typical_low", "lower end of its 95 % interval", &SpecimenLine::typical, &ParameterEstimate::low);
  add("typical_high", "upper end of its 95 % interval", &SpecimenLine::typical, &ParameterEstimate::high);
  table.add(word_column("differ_by", "what spread is: a standard deviation, or a factor either way"),
            [](const SpecimenLine& line) { return words(line.by_factors ? "factor" : "standard deviation"); });
  add("spread", "between specimens", &SpecimenLine::spread, &ParameterEstimate::value);
  add("spread_low", "lower end of its 95 % interval", &SpecimenLine::spread, &ParameterEstimate::low);
  add("spread_high", "upper end of its 95 % interval", &SpecimenLine::spread, &ParameterEstimate::high);
  for (const auto& line : specimen_lines(campaign)) table.add(line);
  return table.table();
}

CampaignTable failure_table(const Campaign& campaign) {
  TableOf<CampaignTest> table("failures");
  table.add(word_column("test", "its name"), [](const CampaignTest& test) { return words(test.name); });
  table.add(word_column("status", ""), [](const CampaignTest& test) { return words(test.status); });
  table.add(word_column("reason", "why there is no answer"),
            [](const CampaignTest& test) { return words(test.reason); });
  table.add(word_column("file", "what describes the test"), [](const CampaignTest& test) { return words(test.file); });
  for (const auto& test : campaign.tests)
    if (!test.summary) table.add(test);
  return table.table();
}

CampaignTable shared_table(const Campaign& campaign) {
  TableOf<SharedParameter> table("shared");
  table.add(word_column("parameter", "estimated from several tests"),
            [](const SharedParameter& shared) { return words(shared.name); });
  table.add(word_column("unit", "of its numbers"), [](const SharedParameter& shared) { return words(shared.unit); });
  const auto add = [&](const std::string& name, const std::string& meaning, double ParameterEstimate::*part) {
    table.add(number_column(name, kind::number, "", meaning),
              [part](const SharedParameter& shared) { return number(shared.estimate.*part); });
  };
  add("value", "", &ParameterEstimate::value);
  add("standard_error", "", &ParameterEstimate::standard_error);
  add("low", "lower end of its 95 % interval", &ParameterEstimate::low);
  add("high", "upper end of its 95 % interval", &ParameterEstimate::high);
  table.add(number_column("tests", kind::number, "", "whose records tell it"),
            [](const SharedParameter& shared) { return number(shared.tests); });
  table.add(number_column("chi_squared", kind::number, "", "of the tests about it, with one freedom less than tests"),
            [](const SharedParameter& shared) { return number(shared.chi_squared); });
  table.add(number_column("agreement", kind::number, "", "probability that tests that do share it differ as much"),
            [](const SharedParameter& shared) { return number(shared.agreement); });
  for (const auto& shared : campaign.shared) table.add(shared);
  return table.table();
}

TableUnit best_unit_of(std::vector<double> values, const Kind& kind) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); }),
               values.end());
  for (double& value : values) value = std::abs(value);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  const std::string_view unit = best_unit(values.empty() ? 1 : *middle, kind);
  return {std::string(unit), unit.empty() ? 1 : from_si(1, parse_unit(unit))};
}

TableUnit print_unit(double value, const std::string& si_unit) {
  if (si_unit == "1") return {"", 1};
  const Unit si = parse_unit(si_unit);
  for (const Kind* kind : {&kind::length, &kind::pressure, &kind::bending_stiffness})
    if (kind->dimension == si.dimension) return best_unit_of({value}, *kind);
  return {si_unit, 1};
}

CampaignUnits units_of(const Campaign& campaign) {
  std::vector<double> wavelengths, stiffnesses, residuals, works;
  for (const auto& test : campaign.tests) {
    if (!test.summary) continue;
    if (test.summary->wavelength) wavelengths.push_back(test.summary->wavelength->value);
    stiffnesses.push_back(test.summary->bending_stiffness.value);
    residuals.push_back(test.summary->residual_rms);
    works.push_back(test.summary->work_of_fracture);
  }
  return {best_unit_of(std::move(wavelengths), kind::length),
          best_unit_of(std::move(stiffnesses), kind::bending_stiffness),
          best_unit_of(std::move(residuals), kind::force), best_unit_of(std::move(works), kind::energy)};
}

CampaignTable in_best_units(CampaignTable table) {
  std::map<std::string, std::string> units;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    auto& column = table.columns[i];
    if (column.unit.empty()) continue;
    const auto [unit, is_first] = units.try_emplace(column.quantity);
    if (is_first) {
      std::vector<double> values;
      for (const auto& row : table.rows)
        if (const double* value = std::get_if<double>(&row[i])) values.push_back(*value);
      unit->second = best_unit_of(std::move(values), *column.kind).name;
    }
    column.unit = unit->second;
    const Unit scale = parse_unit(column.unit);
    for (auto& row : table.rows)
      if (double* value = std::get_if<double>(&row[i])) *value = from_si(*value, scale);
  }
  return table;
}

void write_campaign_csv(const std::string& path, const CampaignTable& table) {
  const auto rows = table.rows.size();
  std::vector<std::vector<double>> numbers(table.columns.size());
  std::vector<std::vector<std::string>> words(table.columns.size());
  std::vector<std::vector<std::string_view>> texts(table.columns.size());
  std::vector<OutputColumn> columns;
  columns.reserve(table.columns.size());
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const auto& column = table.columns[i];
    OutputColumn output{column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit), {}};
    if (column.kind) {
      numbers[i].reserve(rows);
      for (const auto& row : table.rows) {
        const double* value = std::get_if<double>(&row[i]);
        numbers[i].push_back(value ? *value : std::numeric_limits<double>::quiet_NaN());
      }
      output.cells = std::span<const double>(numbers[i]);
    } else {
      texts[i].reserve(rows);
      for (const auto& row : table.rows) {
        const std::string* text = std::get_if<std::string>(&row[i]);
        words[i].push_back(text ? without_formula(*text) : "");
      }
      texts[i].assign(words[i].begin(), words[i].end());
      output.cells = std::span<const std::string_view>(texts[i]);
    }
    columns.push_back(std::move(output));
  }
  write_table(path, columns);
}

}  // namespace flexslip
