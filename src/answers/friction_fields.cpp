#include "answers/friction_fields.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace flexslip {
namespace {

using T = const FittedTest&;

// A part of the fit, where there is one.
template <class Part>
auto of_fit(Part FrictionFit::*part) {
  return [part](T test) { return test.analysis.fit.*part; };
}

Fields<WaveEstimate> wave_fields() {
  return Fields<WaveEstimate>()
      .estimate(parameter::amplitude, &WaveEstimate::amplitude)
      .estimate(parameter::wavelength, &WaveEstimate::wavelength)
      .estimate(parameter::phase, &WaveEstimate::phase)
      .estimate("phase_at_middle", kind::angle, "phase of the wave at the reference", &WaveEstimate::phase_at_middle);
}

}  // namespace

Fields<FittedTest> parameter_fields() {
  const auto wave = [](std::size_t i) {
    return [i](T test) -> const WaveEstimate* {
      const auto& fit = test.analysis.fit;
      return fit.wave_claimed && i < fit.waves.size() ? &fit.waves[i] : nullptr;
    };
  };
  Fields<WaveEstimate> second;
  second
      .estimate("amplitude_2", kind::number, "amplitude of the second wave, relative to mu0", &WaveEstimate::amplitude)
      .estimate("wavelength_2", kind::length, "wavelength of the second wave, along the specimen",
                &WaveEstimate::wavelength)
      .estimate("phase_2", kind::angle, "phase of the second wave at the length 0", &WaveEstimate::phase)
      .estimate("phase_at_middle_2", kind::angle, "phase of the second wave at the reference",
                &WaveEstimate::phase_at_middle);
  return Fields<FittedTest>()
      .left_out_where_missing()
      .only_where(is_fitted)
      .estimate(parameter::mu0.name, parameter::mu0.kind, parameter::mu0.meaning, of_fit(&FrictionFit::mu0),
                Fields<FittedTest>().yes_no("bound", parameter::bound, of_fit(&FrictionFit::mu0_is_bound)))
      .all_of(wave_fields(), wave(0))
      .all_of(second, wave(1))
      .only_where([](T test) { return is_fitted(test) && test.analysis.fit.model != ProfileModel::constant; })
      .estimate("drift", kind::inverse_length, "slope of friction along the specimen", of_fit(&FrictionFit::drift))
      .estimate("force_noise", kind::force, "standard deviation of a force reading, from the fit",
                of_fit(&FrictionFit::noise))
      .only_where([](T test) { return is_fitted(test) && test.analysis.fit.model == ProfileModel::roughness; })
      .estimate(parameter::roughness, of_fit(&FrictionFit::roughness))
      .estimate(parameter::correlation_length, of_fit(&FrictionFit::length))
      .only_where(is_fitted)
      .estimate(parameter::bending_stiffness, of_fit(&FrictionFit::bending_stiffness))
      .estimate("reference", kind::length,
                "length between the contacts to which phase_at_middle refers, and mu0 if there is a drift or a wave",
                [](T test) { return normal_estimate(test.analysis.fit.S_middle, 0); })
      .anywhere()
      .own_estimate(
          "contact_offset", kind::length, "stage position of the contact in the file, which is subtracted",
          [](T test) { return normal_estimate(test.measurement.contact_offset, test.measurement.contact_error); });
}

Fields<FittedTest> likeliest_wave_fields() {
  return Fields<FittedTest>()
      .yes_no("claimed", "the evidence supports the wave, and it is shorter than a quarter of the specimen seen",
              of_fit(&FrictionFit::wave_claimed))
      .number("log_evidence", "ln of the ratio of the evidence with and without a wave",
              of_fit(&FrictionFit::log_evidence_of_wave))
      .all_of(
          wave_fields(), [](T test) -> const auto& { return test.analysis.fit.waves.front(); });
}

Fields<Explanation> explanation_fields() {
  return Fields<Explanation>()
      .words("kernel", "kernel of the roughness: exponential, matern_3_2, matern_5_2 or none",
             [](const Explanation& each) { return name_of(each.kernel); })
      .numbers("wavelengths", kind::length, "wavelengths of the waves in the explanation",
               [](const Explanation& each) { return each.wavelengths; })
      .number("weight", "weight of the explanation; all weights add up to 1", &Explanation::weight)
      .number("log_evidence", "ln of the evidence of the explanation", &Explanation::log_evidence)
      .number("log_likelihood", "ln of the likelihood of the explanation at the maximum of its posterior",
              &Explanation::log_likelihood);
}

// All of the fit that is made of the bands along the fibre.
Fields<FittedTest> band_fields() {
  return Fields<FittedTest>()
      .numbers("length", kind::length, "length between the contacts",
               [](T test) {
                 std::vector<double> lengths;
                 for (const double S : test.analysis.fit.band.S)
                   lengths.push_back(test.analysis.fit.between_contacts(S));
                 return lengths;
               })
      .numbers("drawn_in", kind::length, "length pulled in (both supports)",
               [](T test) {
                 std::vector<double> lengths;
                 for (const double S : test.analysis.fit.band.S) lengths.push_back(S - 1);
                 return lengths;
               })
      .own_numbers("mean", kind::number, "mean friction at this length",
                   [](T test) { return test.analysis.fit.band.mean; })
      .own_numbers("deviation", kind::number, "standard deviation of friction at this length",
                   [](T test) { return test.analysis.fit.band.deviation; });
}

Fields<Check> check_fields() {
  Fields<Check> fields;
  fields
      .words("name", "name of the check: residuals, drops, whiteness, nesting, friction, stability or stiffness",
             [](const Check& check) { return name_of(check.kind); })
      .yes_no("passed", "whether the check passed; null if it was not possible",
              [](const Check& check) {
                return check.outcome == CheckOutcome::not_possible
                           ? std::nullopt
                           : std::optional(check.outcome == CheckOutcome::passed);
              })
      .left_out_where_missing();
  struct Number {
    std::string_view name;
    const Kind& kind;
    std::string_view meaning;
  };
  for (const auto& [name, kind, meaning] :
       {Number{"residual_rms", kind::force,
               "root mean square difference between the force and the mean of the fit run forward"},
        Number{"greatest_force", kind::force, "greatest force measured"},
        Number{"threshold", kind::force, "smallest fall that counts as a drop"},
        Number{"record", kind::number, "number of drops in the record"},
        Number{"draws_low", kind::number, "fewest drops with a profile drawn from the fit"},
        Number{"draws_median", kind::number, "median number of drops with profiles drawn from the fit"},
        Number{"draws_high", kind::number, "most drops with a profile drawn from the fit"},
        Number{"record_fall", kind::force, "mean fall of the force in the drops of the record"},
        Number{"draws_fall", kind::force, "mean fall of the force in the drops with profiles drawn from the fit"},
        Number{"ljung_box", kind::number, "Ljung-Box statistic of the residuals"},
        Number{"lags", kind::number, "number of lags in the Ljung-Box statistic"},
        Number{"p_value", kind::number, "probability of a value at least this large from noise alone"},
        Number{"most_below", kind::number,
               "largest amount by which ln L of an explanation lies below that of one that it contains"},
        Number{"mu0_high", kind::number, "upper end of the 95 % interval of mu0"},
        Number{"mu0_moved", kind::number,
               "shift of mu0, in standard errors, when the force changes in its ninth digit"},
        Number{"same_explanation", kind::number,
               "1 if the likeliest explanation stays when the force changes in its ninth digit, else 0"},
        Number{"fitted_over_nominal", kind::number, "bending stiffness of the fit divided by the nominal one"},
        Number{"errors", kind::number, "difference between the two bending stiffnesses, in errors of the nominal one"}})
    fields.number(name, kind, meaning, [name = name](const Check& check) {
      const auto found = std::find_if(check.numbers.begin(), check.numbers.end(),
                                      [&](const CheckNumber& number) { return number.name == name; });
      return found == check.numbers.end() ? std::nullopt : std::optional(found->value);
    });
  return fields;
}

}  // namespace flexslip
