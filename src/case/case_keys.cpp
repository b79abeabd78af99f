#include "case/case_keys.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

namespace flexslip {
namespace {

template <class Section, class Value>
void point_at(Slot& slot, Value Section::*member, const TestPart& part) {
  if (Section* const* section = std::get_if<Section*>(&part)) slot = &((*section)->*member);
}

template <auto... members>
Slot slot_of(const TestPart& part) {
  Slot slot;
  (point_at(slot, members, part), ...);
  return slot;
}

template <class Section, class Value>
constexpr std::string_view section_of(Value Section::*) {
  if constexpr (std::is_same_v<Section, SpecimenInput>) return "specimen";
  if constexpr (std::is_same_v<Section, CrackInput>) return "specimen.cracks";
  if constexpr (std::is_same_v<Section, RigInput>) return "rig";
  if constexpr (std::is_same_v<Section, FrictionInput>) return "friction";
  if constexpr (std::is_same_v<Section, StageInput>) return "stage";
  return "record";
}

// The section of a key, and its member of the section or of a part of it.
struct Member {
  std::string_view section;
  Slot (*slot)(const TestPart&);
};
template <auto member, auto... others>
constexpr Member at{section_of(member), slot_of<member, others...>};
constexpr Member of_test{"", nullptr}, of_friction{"friction", nullptr}, of_sweep{"sweep", nullptr};

constexpr CaseKey in(Member of, CaseKey key) {
  key.section = of.section;
  key.slot = of.slot;
  return key;
}

constexpr CaseKey quantity(Member of, std::string_view name, const Kind& kind, Range range, std::string_view example,
                           std::string_view reduced, std::string_view meaning, std::string_view more = "") {
  return in(of, {name, Holds::quantity, &kind, range, 0, "", example, reduced, meaning, more});
}

constexpr CaseKey word(Member of, std::string_view name, std::string_view words, std::string_view example,
                       std::string_view meaning, std::string_view more = "") {
  return in(of, {name, Holds::word, nullptr, Range::any, 0, words, example, example, meaning, more});
}

constexpr CaseKey plain(Member of, std::string_view name, Holds holds, std::string_view example,
                        std::string_view meaning, std::string_view more = "", int min = 0) {
  return in(of, {name, holds, nullptr, Range::any, min, "", example, example, meaning, more});
}

constexpr CaseKey estimate(Member of, std::string_view name, const Kind& kind, Range range, std::string_view words,
                           std::string_view example, std::string_view reduced, std::string_view meaning,
                           std::string_view more = "") {
  return in(of, {name, Holds::estimate, &kind, range, 0, words, example, reduced, meaning, more});
}

constexpr CaseKey share(Member of, std::string_view name, Range range, std::string_view example,
                        std::string_view meaning, std::string_view more = "") {
  return in(of, {name, Holds::share, nullptr, range, 0, "", example, example, meaning, more});
}

constexpr CaseKey title(Member of, std::string_view name, const Kind& kind, std::string_view example,
                        std::string_view reduced, std::string_view meaning, std::string_view more = "") {
  return in(of, {name, Holds::title, &kind, Range::any, 0, "", example, reduced, meaning, more});
}

constexpr CaseKey at_most(double max, std::string_view why, CaseKey key) {
  key.max = max;
  key.why_max = why;
  return key;
}

constexpr CaseKey flagged(CaseKey key) {
  key.has_flag = true;
  return key;
}

constexpr CaseKey without(std::string_view gone, std::string_view why, CaseKey key) {
  key.gone = gone;
  key.why_gone = why;
  return key;
}

constexpr std::array keys{
    plain(of_test, "reduced", Holds::yes_no, "true",
          "whether all numbers are in reduced variables, without units; false unless given"),
    // specimen
    flagged(estimate(at<&SpecimenInput::diameter>, "diameter", kind::length, Range::positive, "", R"("34.8 um")",
                     "0.027", "outer diameter of a round specimen or tube")),
    flagged(estimate(at<&SpecimenInput::inner_diameter>, "inner_diameter", kind::length, Range::positive, "",
                     R"("30 um")", "0.02", "inner diameter of a tube; needs diameter, the outer one")),
    flagged(estimate(at<&SpecimenInput::wall>, "wall", kind::length, Range::positive, "", R"("3 um")", "0.003",
                     "wall thickness of a tube, instead of its inner diameter")),
    flagged(estimate(at<&SpecimenInput::width>, "width", kind::length, Range::positive, "", R"("50 um")", "0.04",
                     "width of a rectangular section; needs height")),
    flagged(estimate(at<&SpecimenInput::height>, "height", kind::length, Range::positive, "", R"("30 um")", "0.02",
                     "height of a rectangular section, in the direction of bending")),
    flagged(estimate(at<&SpecimenInput::modulus>, "modulus", kind::pressure, Range::positive, "fit", R"("29.6 GPa")",
                     "", "Young's modulus; found from the initial slope unless given",
                     R"(: `"29.6 GPa"`, `"29.6 GPa ± 5 %"`, or `"fit"`)")),
    flagged(estimate(at<&SpecimenInput::bending_stiffness>, "bending_stiffness", kind::bending_stiffness,
                     Range::positive, "fit", R"("2.1e-9 N m^2")", "1",
                     "bending stiffness EI, instead of section and modulus", ", in the same three ways as a modulus")),
    plain(at<&SpecimenInput::material>, "material", Holds::text, R"("glass")", "material of the specimen",
          ", used with `support_material` to compare friction with the literature"),
    at_most(1, "write it as \"2 %\" or 0.02",
            share(at<&SpecimenInput::strain_at_break>, "strain_at_break", Range::positive, R"("2 %")",
                  "bending strain at the surface at which the specimen breaks; needs a section",
                  ". `design` and `sweep` end there; `simulate` and `fit` report a record that goes beyond it")),
    quantity(at<&SpecimenInput::strength>, "strength", kind::pressure, Range::positive, R"("600 MPa")", "",
             "bending stress at the surface at which the specimen breaks, instead of strain_at_break"),
    in(at<&SpecimenInput::cracks>,
       {"cracks", Holds::tables, nullptr, Range::any, 0, "", R"([{ deflection = "160 um", loss = "3 %" }])",
        R"([{ deflection = 0.12, loss = "3 %" }])", "deflections at which the specimen cracks, for simulate",
        " only. At each deflection the bending stiffness falls by a share of what is left "
        "([theory](theory.md#cracks))"}),
    quantity(at<&CrackInput::deflection>, "deflection", kind::length, Range::positive, R"("160 um")", "0.12",
             "deflection at which the crack opens"),
    share(at<&CrackInput::loss>, "loss", Range::positive, R"("3 %")",
          "share of the remaining bending stiffness that the crack takes away"),
    // rig
    flagged(estimate(at<&RigInput::span>, "span", kind::length, Range::positive, "", R"("1278 um")", "1",
                     "support span: distance between the supports")),
    flagged(estimate(at<&RigInput::stiffness>, "stiffness", kind::stiffness, Range::positive_or_infinite, "",
                     R"("90.65 N/m")", "88.8",
                     "stiffness of the load train, which is everything that carries the load cell; \"inf\" if the "
                     "displacement was measured at the specimen or is already corrected")),
    quantity(at<&RigInput::support_stiffness>, "support_stiffness", kind::stiffness, Range::positive_or_infinite,
             R"("5 kN/mm")", "2000", "vertical stiffness of each of the two supports, if they yield",
             ". They are then in series with the load train. The deflection is measured from the ends of the specimen"),
    flagged(word(at<&RigInput::supports>, "supports", "edges|rollers", R"("edges")",
                 "what the specimen lies on: knife edges, or rollers with a radius; edges are assumed unless given")),
    flagged(estimate(at<&RigInput::roller_radius>, "roller_radius", kind::length, Range::non_negative, "", R"("5 mm")",
                     "0.08", "radius of the rollers that serve as supports; knife edges unless given")),
    without("loose", "loose rollers were a feature of earlier versions: write \"fixed\" or \"pinned\"",
            word(at<&RigInput::rollers>, "rollers", "fixed|pinned", R"("pinned")",
                 "how the rollers move: not at all, or on pins; fixed unless given",
                 ". The friction of the pins limits that of the specimen ([theory](theory.md#rollers-and-thickness))")),
    quantity(at<&RigInput::pin_radius>, "pin_radius", kind::length, Range::positive, R"("1 mm")", "0.02",
             "radius of the pins on which the rollers turn"),
    quantity(at<&RigInput::pin_friction>, "pin_friction", kind::number, Range::non_negative, "0.1", "0.1",
             "coefficient of friction between roller and pin"),
    word(
        at<&RigInput::friction_at>, "friction_at", "surface|axis", R"("axis")",
        "whether friction acts at the surface or at the axis of the specimen; surface unless given",
        R"(. `"surface"`: the specimen has the thickness of its section; friction cannot be determined below a deflection of twice the thickness. `"axis"`: the paper's model, without thickness)"),
    quantity(at<&RigInput::nose_radius>, "nose_radius", kind::length, Range::positive, R"("5 mm")", "0.08",
             "radius of the loading nose; sharp unless given",
             ". All results are for a sharp nose; simulate, design and fit report from where on the specimen wraps "
             "around it"),
    word(
        at<&RigInput::nose>, "nose", "holds|free", R"("free")",
        "whether the loading nose holds the middle of the specimen; it does unless given",
        R"(. If it does, two unlike supports act by their mean. `"free"`: a nose without friction, or one that turns; the weaker side slides, and lengths along the specimen are twice as long ([theory](theory.md#two-supports)))"),
    word(
        at<&RigInput::snaps>, "snaps", "nearest|overshoot", R"("overshoot")",
        "where a snap comes to rest: nearest stable state, or beyond",
        R"(. Unless given, simulate takes the nearest, and fit what the record shows. `"overshoot"`: kinetic energy carries the specimen on until friction has dissipated it, as on a rig with little damping ([theory](theory.md#where-a-snap-comes-to-rest)))"),
    plain(at<&RigInput::support_material>, "support_material", Holds::text, R"("steel")", "material of the supports",
          "; friction is compared with the literature only if both materials are stated"),
    // friction
    word(at<&FrictionInput::model>, "model", "constant|drift|sinusoid|sinusoids|table|rough|surface|roughness",
         R"("sinusoid")", "friction model, to compute with or to fit"),
    quantity(at<&FrictionInput::mu0>, "mu0", kind::number, Range::non_negative, "0.5", "0.5",
             "mean coefficient of friction"),
    quantity(at<&FrictionInput::drift>, "drift", kind::inverse_length, Range::any, R"("0.2 1/mm")", "0.3",
             "slope of friction along the length S; 0 unless given", "; where it would carry μ below 0, μ is 0"),
    quantity(at<&FrictionInput::reference>, "reference", kind::length, Range::positive, R"("1.5 mm")", "1.2",
             "length S at which friction with a drift is mu0; default: the span", ", and never less than the span"),
    at_most(
        1, "it is relative to mu0, and friction cannot be negative",
        quantity(at<&FrictionInput::amplitude, &WaveInput::amplitude>, "amplitude", kind::number, Range::non_negative,
                 "0.15", "0.15", "amplitude of the friction wave, relative to mu0; at most 1")),
    quantity(at<&FrictionInput::wavelength, &WaveInput::wavelength>, "wavelength", kind::length, Range::positive,
             R"("10.9 um")", "0.0085", "wavelength of the friction wave, along the specimen"),
    quantity(at<&FrictionInput::phase, &WaveInput::phase>, "phase", kind::angle, Range::any, R"("90 deg")", "1.0",
             "phase of the friction wave at S = 0; 0 unless given"),
    in(at<&FrictionInput::waves>,
       {"waves", Holds::tables, nullptr, Range::any, 0, "",
        R"([{ amplitude = 0.15, wavelength = "10.9 um", phase = 1.0 }])",
        "[{ amplitude = 0.15, wavelength = 0.0085, phase = 1.0 }]", "several friction waves, for the model sinusoids",
        ", whose amplitudes add up to at most 1"}),
    plain(at<&FrictionInput::file>, "file", Holds::file, R"("trace.csv")",
          "file with a table of friction over the length S"),
    title(at<&FrictionInput::length>, "length", kind::length, R"("S [um]")", R"("S")",
          "title of the column of S in the friction table"),
    title(at<&FrictionInput::mu>, "mu", kind::number, R"("mu")", R"("mu")",
          "title of the column of friction in the friction table; mu unless given"),
    quantity(at<&FrictionInput::rms>, "rms", kind::number, Range::non_negative, "0.1", "0.1",
             "standard deviation of ln μ, for the model rough"),
    quantity(at<&FrictionInput::correlation_length>, "correlation_length", kind::length, Range::positive, R"("5 um")",
             "0.004", "correlation length of the roughness, along the specimen"),
    plain(at<&FrictionInput::seed>, "seed", Holds::whole_number, "1",
          "seed of the random numbers, for the model rough"),
    plain(at<&FrictionInput::trace>, "trace", Holds::file, R"("trace.csv")",
          "file with a height profile of the surface that the support climbs, for the model surface",
          " ([surface.md](surface.md)); `mu0` is then the friction of the flat surface"),
    plain(at<&FrictionInput::position>, "position", Holds::text, R"("x [um]")",
          "column of positions in the height profile, by name or number; found unless given"),
    plain(at<&FrictionInput::height>, "height", Holds::text, R"("z [nm]")",
          "column of heights in the height profile, by name or number; found unless given"),
    quantity(at<&FrictionInput::trace_step>, "trace_step", kind::length, Range::positive, R"("0.1 um")", "8e-5",
             "distance between heights, for a height profile without positions"),
    quantity(at<&FrictionInput::trace_begin>, "trace_begin", kind::length, Range::non_negative, R"("639 um")", "0.5",
             "distance from midspan at which the height profile begins; half the span unless given",
             ". Outside the height profile friction is mu0"),
    word(at<&FrictionInput::direction>, "direction", "outwards|inwards", R"("inwards")",
         "direction of the height profile, seen from midspan; outwards unless given"),
    plain(at<&FrictionInput::level>, "level", Holds::whole_number, "2",
          "degree of the polynomial that is subtracted from the heights; 1, a tilt, unless given"),
    quantity(at<&FrictionInput::cutoff>, "cutoff", kind::length, Range::positive, R"("1 um")", "0.001",
             "cutoff of the Gaussian filter that removes shorter waves from the heights; none unless given"),
    quantity(at<&FrictionInput::edge_radius>, "edge_radius", kind::length, Range::non_negative, R"("1 um")", "0.001",
             "radius of the edge that slides over the surface; default: the rollers' radius, or sharp",
             ". It does not reach into valleys narrower than itself"),
    quantity(at<&FrictionInput::static_excess>, "static_excess", kind::number, Range::non_negative, "0.1", "0.1",
             "excess of static over kinetic friction; 0 unless given", ". Only for simulate"),
    at_most(1, "it is the share that is left",
            quantity(at<&FrictionInput::wear>, "wear", kind::number, Range::positive, "0.9", "0.9",
                     "share of friction that is left after each turn of the stage; 1 unless given",
                     ". Only for simulate ([theory](theory.md#wear))")),
    plain(of_friction, "other", Holds::section, "", "friction of the other support, if it differs",
          ", in a section `[friction.other]` with a model and its keys"),
    // stage
    in(at<&StageInput::program>,
       {"program", Holds::lengths, &kind::length, Range::non_negative, 0, "", R"(["0 um", "900 um"])", "[0, 0.7]",
        "stage positions that are visited one after the other",
        ", at least two, none below 0: load, unload, reload. A repeated position is a halt"}),
    plain(at<&StageInput::cycles>, "cycles", Holds::whole_number, "10",
          "how often the positions after the first are visited; once unless given", "", 1),
    in(at<&StageInput::step>, {"step", Holds::quantity, &kind::length, Range::positive, 0, "continuous", R"("2 um")",
                               "0.002", "stage displacement between readings; continuous unless given",
                               ", which is the whole curve, with exact reversals and snaps"}),
    plain(at<&StageInput::file>, "file", Holds::file, R"("run.csv")", "file with a table of measured stage positions",
          ", as in `[record]`"),
    title(at<&StageInput::stage>, "stage", kind::length, R"("stage [um]")", R"("w_s")",
          "title of the column of stage positions in that file"),
    title(at<&StageInput::time>, "time", kind::time, R"("t [s]")", R"("t")", "title of the column of time in that file",
          ", to check the order of the rows"),
    word(at<&StageInput::decimal>, "decimal", ".|,", R"(",")", "decimal mark of the file of stage positions"),
    word(at<&StageInput::snaps>, "snaps", "nearest|overshoot", R"("overshoot")",
         "where a simulated snap stops; default: as on the rig", "; see `[rig] snaps`"),
    // record
    plain(at<&RecordInput::file>, "file", Holds::file, R"("ss14.csv")", "file with the measured record",
          ": [any file](reading-exports.md) that `flexslip read` reads"),
    flagged(plain(at<&RecordInput::sheet>, "sheet", Holds::name_or_number, R"("Specimen 1")",
                  "sheet of a workbook (.xlsx), by name or number; the first with a table of numbers unless given")),
    flagged(title(at<&RecordInput::stage>, "stage", kind::length, R"("w_s_m [m]")", R"("w_s")",
                  "title of the column of stage (crosshead) displacement")),
    flagged(title(at<&RecordInput::deflection>, "deflection", kind::length, R"("w_m [m]")", R"("w")",
                  "title of the column of deflection at midspan")),
    flagged(title(at<&RecordInput::force>, "force", kind::force, R"("F_N [N]")", R"("F")",
                  "title of the column of force; in an export its name or number, if it is not found")),
    title(at<&RecordInput::length>, "length", kind::length, R"("S-L [um]")", R"("S-1")",
          "title of the column of the imaged length pulled in (both supports)", " (S − L), to compare with the result"),
    flagged(word(at<&RecordInput::displacement>, "displacement", "crosshead|deflection", R"("crosshead")",
                 "what an export's displacement measures: the crosshead or the midpoint",
                 R"(. `"crosshead"` is corrected for the load train. Needed if the file does not say it)")),
    flagged(plain(at<&RecordInput::displacement_column>, "displacement_column", Holds::text, R"("Extension")",
                  "column of displacement in an export, by name or number, if it is not found")),
    flagged(plain(at<&RecordInput::specimen>, "specimen", Holds::whole_number, "2",
                  "which specimen of an export with several, counted from 1", "", 1)),
    flagged(plain(at<&RecordInput::calibration>, "calibration", Holds::text, R"("222 N/V")",
                  "calibration of a force that an export gives in volts")),
    flagged(quantity(at<&RecordInput::speed>, "speed", kind::speed, Range::positive, R"("0.5 mm/s")", "",
                     "speed of the crosshead, for an export that has a time and no displacement")),
    flagged(word(at<&RecordInput::sign>, "sign", "find|keep|reverse", R"("keep")",
                 "whether to keep or reverse signs; found unless given: reversed if compression is negative")),
    flagged(in(at<&RecordInput::zero>,
               {"zero", Holds::quantity, &kind::force, Range::any, 0, "find|keep|slope", R"("0.2 mN")", "0.1",
                "zero of the force, which is subtracted; found from rows before contact unless given",
                R"(. `"slope"` subtracts a force that drifts or settles before contact)"})),
    flagged(in(at<&RecordInput::contact>,
               {"contact", Holds::estimate, &kind::length, Range::any, 0, "find|first row", R"("12 um")", "0.01",
                "displacement at first contact; unless given, found if the record begins before it", ""})),
    at_most(max_uncertainty, "calibrate the load cell",
            share(at<&RecordInput::gain_error>, "gain_error", Range::non_negative, R"("1 %")",
                  "standard deviation of the gain of the load cell; 1 % unless given")),
    quantity(
        at<&RecordInput::preload_error>, "preload_error", kind::length, Range::non_negative, R"("0 um")", "0",
        "standard deviation of the deflection that was there before displacement and force were set to zero, or of "
        "the bow of a specimen, which reads like it; 0.5 % of the span unless given, 0.3 % where the record begins "
        "before the contact"),
    at_most(max_uncertainty, "such a force does not determine friction",
            share(at<&RecordInput::slow_force_error>, "slow_force_error", Range::non_negative, R"("2 %")",
                  "standard deviation of slow deviations of the force, relative to the maximum force: the specimen or "
                  "the rig relaxes, the load cell drifts; 0.65 % unless given, and more where rests of the stage show "
                  "it")),
    flagged(word(at<&RecordInput::failure>, "failure", "find|none", R"("none")",
                 "whether to find where the specimen fails and end the record there; find unless given")),
    flagged(
        word(at<&RecordInput::decimal>, "decimal", ".|,", R"(",")", "decimal mark of the file; found unless given")),
    flagged(plain(at<&RecordInput::first>, "first", Holds::place, "12",
                  "where the record begins: a row, counted from 1, or a stage position")),
    flagged(plain(at<&RecordInput::until>, "until", Holds::place, "250",
                  "where the record ends, before failure: a row or a stage position; found unless given")),
    // sweep
    word(of_sweep, "method", "grid|latin hypercube", R"("grid")", "how designs are chosen: on a grid or as a sample",
         ". `\"grid\"` takes every value of an axis with every value of the others; `\"latin hypercube\"` takes a "
         "sample with one design in each of as many strata of each axis"),
    plain(of_sweep, "samples", Holds::whole_number, "1000", "number of designs in a Latin hypercube", "", 1),
    plain(of_sweep, "seed", Holds::whole_number, "1",
          "seed of a Latin hypercube; it gives the same sample on every machine"),
    plain(of_sweep, "axes", Holds::axes, "", "numbers of the case that vary, by name",
          ", in a section `[sweep.axes]`; all others are as the case has them"),
};

}  // namespace

std::span<const CaseKey> case_keys() { return keys; }

std::vector<std::string> case_sections() {
  std::vector<std::string> sections;
  for (const CaseKey& key : keys)
    if (!key.section.empty() && (sections.empty() || sections.back() != key.section))
      sections.emplace_back(key.section);
  return sections;
}

const CaseKey* case_key(std::string_view section, std::string_view name) {
  if (section.starts_with("friction.")) section = "friction";
  if (section == "sweep.axes") return case_key("sweep", "axes");
  if (const std::size_t index = section.find('['); index != std::string_view::npos) section = section.substr(0, index);
  const auto* at = std::find_if(keys.begin(), keys.end(),
                                [&](const CaseKey& key) { return key.section == section && key.name == name; });
  return at == keys.end() ? nullptr : at;
}

double* number_of(Test& test, const CaseKey& key) {
  const auto number_in = [](auto member) -> double* {
    using Member = decltype(member);
    if constexpr (std::is_same_v<Member, double*>) return member;
    if constexpr (std::is_same_v<Member, std::optional<double>*>) return *member ? &**member : nullptr;
    if constexpr (std::is_same_v<Member, std::optional<Known>*>) return *member ? &(*member)->value : nullptr;
    if constexpr (std::is_same_v<Member, std::vector<double>*>) return member->empty() ? nullptr : &member->back();
    if constexpr (std::is_same_v<Member, std::optional<StatedStiffness>*>) {
      Known* known = *member ? std::get_if<Known>(&**member) : nullptr;
      return known ? &known->value : nullptr;
    }
    return nullptr;
  };
  const auto of = [&](auto& part) { return part ? std::visit(number_in, key.of(&*part)) : nullptr; };
  if (key.section == "specimen") return of(test.specimen);
  if (key.section == "rig") return of(test.rig);
  if (key.section == "friction") return of(test.friction);
  return key.section == "stage" ? of(test.stage) : nullptr;
}

std::string flag_of(std::string_view name) {
  std::string flag = fmt::format("--{}", name);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

std::vector<std::string_view> words_of(std::string_view list) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find('|', at), list.size());
    words.push_back(list.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

std::vector<std::string_view> words_of(const CaseKey& key) { return words_of(key.words); }

std::string what_holds(const CaseKey& key) {
  constexpr std::array words_of_others{"",
                                       "a share, such as \"2 %\"",
                                       "",
                                       "true or false",
                                       "",
                                       "",
                                       "text",
                                       "the title of a column",
                                       "a file",
                                       "text, or a whole number",
                                       "a row, a length, or { deflection = … }",
                                       "an array of lengths",
                                       "a section",
                                       "a section of ranges or lists",
                                       "an array of tables"};
  std::vector<std::string> parts;
  if (key.holds == Holds::quantity || key.holds == Holds::estimate) parts.emplace_back(key.kind->name);
  for (const std::string_view word : words_of(key)) parts.push_back(fmt::format("\"{}\"", word));
  if (key.holds == Holds::whole_number) parts.push_back(fmt::format("a whole number from {}", key.min));
  if (parts.empty()) parts.emplace_back(words_of_others.at(static_cast<std::size_t>(key.holds)));
  return in_words(parts);
}

std::string in_words(const std::vector<std::string>& names, std::string_view before_last) {
  std::string words;
  for (std::size_t i = 0; i < names.size(); ++i)
    words += (i == 0 ? "" : i + 1 < names.size() ? ", " : fmt::format(" {} ", before_last)) + names[i];
  return words;
}

}  // namespace flexslip
