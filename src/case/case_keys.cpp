#include "case/case_keys.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

namespace flexslip {
namespace {

constexpr CaseKey quantity(std::string_view section, std::string_view name, const Kind& kind, Range range,
                           std::string_view example, std::string_view reduced, std::string_view flag,
                           std::string_view meaning, std::string_view more = "") {
  return {section, name, Holds::quantity, &kind, range, 0, "", example, reduced, flag, meaning, more};
}

constexpr CaseKey word(std::string_view section, std::string_view name, std::string_view words,
                       std::string_view example, std::string_view flag, std::string_view meaning,
                       std::string_view more = "") {
  return {section, name, Holds::word, nullptr, Range::any, 0, words, example, example, flag, meaning, more};
}

constexpr CaseKey plain(std::string_view section, std::string_view name, Holds holds, std::string_view example,
                        std::string_view flag, std::string_view meaning, std::string_view more = "", int least = 0) {
  return {section, name, holds, nullptr, Range::any, least, "", example, example, flag, meaning, more};
}

constexpr CaseKey estimate(std::string_view name, const Kind& kind, std::string_view example, std::string_view reduced,
                           std::string_view flag, std::string_view meaning, std::string_view more) {
  return {"specimen", name, Holds::estimate, &kind, Range::positive, 0, "fit", example, reduced, flag, meaning, more};
}

constexpr CaseKey title(std::string_view section, std::string_view name, const Kind& kind, std::string_view example,
                        std::string_view reduced, std::string_view flag, std::string_view meaning,
                        std::string_view more = "") {
  return {section, name, Holds::title, &kind, Range::any, 0, "", example, reduced, flag, meaning, more};
}

constexpr CaseKey at_most(double most, std::string_view why, CaseKey key) {
  key.most = most;
  key.why_most = why;
  return key;
}

constexpr std::array keys{
    plain("", "reduced", Holds::yes_no, "true", "",
          "whether all numbers are in reduced variables, without units; false unless given"),
    // specimen
    quantity("specimen", "diameter", kind::length, Range::positive, R"("34.8 um")", "0.027", "--diameter",
             "outer diameter of a round specimen or tube"),
    quantity("specimen", "inner_diameter", kind::length, Range::positive, R"("30 um")", "0.02", "--inner-diameter",
             "inner diameter of a tube, beside its outer diameter"),
    quantity("specimen", "wall", kind::length, Range::positive, R"("3 um")", "0.003", "--wall",
             "wall thickness of a tube, instead of its inner diameter"),
    quantity("specimen", "width", kind::length, Range::positive, R"("50 um")", "0.04", "--width",
             "width of a rectangular section, beside its height"),
    quantity("specimen", "height", kind::length, Range::positive, R"("30 um")", "0.02", "--height",
             "height of a rectangular section, in the direction of bending"),
    estimate(
        "modulus", kind::pressure, R"("29.6 GPa")", "", "--modulus",
        "Young's modulus; found from the initial slope unless given",
        R"(: `"29.6 GPa"`, with its standard deviation `{ value = "29.6 GPa", uncertainty = "1.5 GPa" }` or `uncertainty = "5 %"`, or `"fit"`)"),
    estimate("bending_stiffness", kind::bending_stiffness, R"("2.1e-9 N m^2")", "1", "--bending-stiffness",
             "bending stiffness EI, instead of section and modulus", ", in the same three ways as a modulus"),
    plain("specimen", "material", Holds::text, R"("glass")", "", "material of the specimen",
          ", used with `support_material` to compare friction with the literature"),
    at_most(
        1, "write it as \"2 %\" or 0.02",
        CaseKey{"specimen", "strain_at_break", Holds::share, nullptr, Range::positive, 0, "", R"("2 %")", R"("2 %")",
                "", "bending strain at the surface at which the specimen breaks; needs a section",
                ". [`design` and `sweep`](rig-design.md) end there; `simulate` and `fit` say whether the record goes "
                "beyond it"}),
    quantity("specimen", "strength", kind::pressure, Range::positive, R"("600 MPa")", "", "",
             "bending stress at the surface at which the specimen breaks, instead of strain_at_break"),
    CaseKey{
        "specimen", "cracks", Holds::tables, nullptr, Range::any, 0, "", R"([{ deflection = "160 um", loss = "3 %" }])",
        R"([{ deflection = 0.12, loss = "3 %" }])", "", "deflections at which the specimen cracks, for simulate",
        " (`design` and `sweep` refuse it, other commands ignore it). When a deflection is first reached, the bending "
        "stiffness falls at once and for good by the stated share of what is left ([theory.md](theory.md#cracks))"},
    quantity("specimen.cracks", "deflection", kind::length, Range::positive, R"("160 um")", "0.12", "",
             "deflection at which the crack opens"),
    plain("specimen.cracks", "loss", Holds::share, R"("3 %")", "",
          "share of the remaining bending stiffness that the crack takes away"),
    // rig
    quantity("rig", "span", kind::length, Range::positive, R"("1278 um")", "1", "--span",
             "support span: distance between the supports"),
    quantity("rig", "stiffness", kind::stiffness, Range::positive_or_infinite, R"("90.65 N/m")", "88.8", "--stiffness",
             "stiffness of the load train, which is everything that carries the load cell; \"inf\" for displacement "
             "control"),
    quantity(
        "rig", "support_stiffness", kind::stiffness, Range::positive_or_infinite, R"("5 kN/mm")", "2000", "",
        "vertical stiffness of each of the two supports, if they yield",
        ". Load train and supports in series then stand between the stage and the deflection, and a snap happens on "
        "both. The deflection is always that of the midpoint below the ends of the specimen"),
    quantity("rig", "roller_radius", kind::length, Range::non_negative, R"("5 mm")", "0.08", "",
             "radius of the rollers that serve as supports; knife edges unless given",
             ". Friction along the specimen is looked up where its axis touches the roller"),
    word(
        "rig", "rollers", "fixed|pinned|loose", R"("pinned")", "",
        "how the rollers move: not at all, on pins, or loose on a base; fixed unless given",
        R"(. `"pinned"` rollers turn on pins, and friction is at most that of the pins, the same everywhere. `"loose"` rollers roll on a flat base and the specimen rolls on them as long as there is enough friction: simulate shows the curve, and the other commands, which ask for friction, refuse them ([theory](theory.md#rollers-and-thickness)))"),
    quantity("rig", "pin_radius", kind::length, Range::positive, R"("1 mm")", "0.02", "",
             "radius of the pins on which the rollers turn"),
    quantity("rig", "pin_friction", kind::number, Range::non_negative, "0.1", "0.1", "",
             "coefficient of friction between roller and pin"),
    word(
        "rig", "friction_at", "surface|axis", R"("axis")", "",
        "whether friction acts at the surface or at the axis of the specimen; surface unless given",
        R"(. `"surface"`: the specimen has the thickness of its section and its axis lies half of it above the supports; friction cannot be read off below a deflection of twice the thickness. `"axis"`: the paper's model, a specimen without thickness)"),
    quantity("rig", "nose_radius", kind::length, Range::positive, R"("5 mm")", "0.08", "",
             "radius of the loading nose; sharp unless given",
             ". It has no effect until the specimen is bent more sharply than nose and half depth allow; simulate, "
             "design and fit say where that happens, and go on computing with a sharp nose"),
    plain("rig", "support_material", Holds::text, R"("steel")", "", "material of the supports",
          "; friction is compared with the literature only if both materials are stated"),
    // friction
    word("friction", "model", "constant|drift|sinusoid|sinusoids|table|rough|surface|roughness", R"("sinusoid")", "",
         "friction model, to compute with or to fit"),
    quantity("friction", "mu0", kind::number, Range::non_negative, "0.5", "0.5", "", "mean coefficient of friction"),
    quantity("friction", "drift", kind::inverse_length, Range::any, R"("0.2 1/mm")", "0.3", "",
             "slope of friction along the length S; 0 unless given", "; where it would carry μ below 0, μ is 0"),
    quantity("friction", "reference", kind::length, Range::positive, R"("1.5 mm")", "1.2", "",
             "length S at which friction is mu0, beside a drift; the span unless given",
             ", and never less than the span"),
    at_most(1, "it is relative to mu0, and friction cannot be negative",
            quantity("friction", "amplitude", kind::number, Range::non_negative, "0.15", "0.15", "",
                     "amplitude of the friction wave, relative to mu0; at most 1")),
    quantity("friction", "wavelength", kind::length, Range::positive, R"("10.9 um")", "0.0085", "",
             "wavelength of the friction wave, along the specimen"),
    quantity("friction", "phase", kind::angle, Range::any, R"("90 deg")", "1.0", "",
             "phase of the friction wave at S = 0; 0 unless given"),
    CaseKey{"friction", "waves", Holds::tables, nullptr, Range::any, 0, "",
            R"([{ amplitude = 0.15, wavelength = "10.9 um", phase = 1.0 }])",
            "[{ amplitude = 0.15, wavelength = 0.0085, phase = 1.0 }]", "",
            "several friction waves, for the model sinusoids", ", whose amplitudes add up to at most 1"},
    plain("friction", "file", Holds::file, R"("trace.csv")", "", "file with a table of friction over the length S"),
    title("friction", "length", kind::length, R"("S [um]")", R"("S")", "",
          "title of the column of S in the friction table"),
    title("friction", "mu", kind::number, R"("mu")", R"("mu")", "",
          "title of the column of friction in the friction table; mu unless given"),
    quantity("friction", "rms", kind::number, Range::non_negative, "0.1", "0.1", "",
             "standard deviation of ln μ, for the model rough"),
    quantity("friction", "correlation_length", kind::length, Range::positive, R"("5 um")", "0.004", "",
             "correlation length of the roughness, along the specimen"),
    plain("friction", "seed", Holds::whole_number, "1", "", "seed of the random numbers, for the model rough"),
    plain("friction", "trace", Holds::file, R"("trace.csv")", "",
          "file with a height profile of the surface that the support climbs, for the model surface",
          ", read as [`surface`](surface.md) reads it; `mu0` is then the friction of the flat surface"),
    plain("friction", "position", Holds::text, R"("x [um]")", "",
          "column of positions in the height profile, by name or number; found unless given"),
    plain("friction", "height", Holds::text, R"("z [nm]")", "",
          "column of heights in the height profile, by name or number; found unless given"),
    quantity("friction", "trace_step", kind::length, Range::positive, R"("0.1 um")", "8e-5", "",
             "distance between heights, for a height profile without positions"),
    quantity("friction", "trace_begin", kind::length, Range::non_negative, R"("639 um")", "0.5", "",
             "distance from midspan at which the height profile begins; half the span unless given",
             ". Outside the height profile friction is mu0"),
    word("friction", "direction", "outwards|inwards", R"("inwards")", "",
         "direction of the height profile, seen from midspan; outwards unless given"),
    plain("friction", "level", Holds::whole_number, "2", "",
          "degree of the polynomial that is subtracted from the heights; 1, a tilt, unless given"),
    quantity("friction", "cutoff", kind::length, Range::positive, R"("1 um")", "0.001", "",
             "cutoff of the Gaussian filter that removes shorter waves from the heights; none unless given"),
    quantity("friction", "edge_radius", kind::length, Range::non_negative, R"("1 um")", "0.001", "",
             "radius of the edge that climbs the surface; that of the rollers, or sharp, unless given",
             ". It does not reach into valleys narrower than itself"),
    quantity("friction", "static_excess", kind::number, Range::non_negative, "0.1", "0.1", "",
             "excess of static over kinetic friction; 0 unless given", ". Only for simulate"),
    quantity("friction", "build_up_length", kind::length, Range::non_negative, R"("2.5 um")", "0.002", "",
             "length of sliding over which friction builds up after the specimen turns back; 0 unless given",
             ", in S, over both supports together ([theory](theory.md#friction-that-builds-up)); not beside "
             "`static_excess`, "
             "`[friction.other]`, `roller_radius`, cracks, or `snaps = \"overshoot\"`"),
    plain("friction", "other", Holds::section, "", "", "friction of the other support, if it differs",
          ", in a section `[friction.other]` with a model and its keys"),
    // stage
    CaseKey{"stage", "program", Holds::lengths, &kind::length, Range::non_negative, 0, "", R"(["0 um", "900 um"])",
            "[0, 0.7]", "", "stage positions that are visited one after the other",
            ", at least two, none below 0: load, unload, reload. A repeated position is a halt"},
    plain("stage", "cycles", Holds::whole_number, "10", "",
          "how often the positions after the first are visited; once unless given", "", 1),
    CaseKey{"stage", "step", Holds::quantity, &kind::length, Range::positive, 0, "continuous", R"("2 um")", "0.002", "",
            "stage displacement between readings; continuous unless given",
            ", which is the whole curve, with exact reversals and snaps"},
    plain("stage", "file", Holds::file, R"("run.csv")", "", "file with a table of measured stage positions",
          ", as in `[record]`"),
    title("stage", "stage", kind::length, R"("stage [um]")", R"("w_s")", "",
          "title of the column of stage positions in that file"),
    title("stage", "time", kind::time, R"("t [s]")", R"("t")", "", "title of the column of time in that file",
          ", to check that no row is earlier than the one before. The model has no speed"),
    word("stage", "decimal", ".|,", R"(",")", "", "decimal mark of the file of stage positions"),
    word(
        "stage", "snaps", "nearest|overshoot", R"("overshoot")", "",
        "where a snap comes to rest: nearest stable state, or beyond; nearest unless given",
        R"(. `"nearest"`: the energy set free is lost at once, as in the paper. `"overshoot"`: it carries the specimen on until friction has consumed it)"),
    // record
    plain("record", "file", Holds::file, R"("ss14.csv")", "", "file with the measured record",
          ": CSV, or text separated by semicolons, tabs or spaces, with one header line; or an export of a testing "
          "machine; or a workbook (.xlsx) with either"),
    plain("record", "sheet", Holds::name_or_number, R"("Specimen 1")", "--sheet",
          "sheet of a workbook (.xlsx), by name or number; the first with a table of numbers unless given"),
    title("record", "stage", kind::length, R"("w_s_m [m]")", R"("w_s")", "--stage",
          "title of the column of stage (crosshead) displacement"),
    title("record", "deflection", kind::length, R"("w_m [m]")", R"("w")", "--deflection",
          "title of the column of deflection at midspan"),
    title("record", "force", kind::force, R"("F_N [N]")", R"("F")", "--force",
          "title of the column of force; in an export its name or number, if it is not found"),
    title("record", "length", kind::length, R"("S-L [um]")", R"("S-1")", "",
          "title of the column of the imaged length pulled in (both supports)",
          " (S − L), if there is one: compared with what the force says, point by point"),
    word(
        "record", "displacement", "crosshead|deflection", R"("crosshead")", "--displacement",
        "what an export's displacement measures: the crosshead or the midpoint",
        R"(. `"crosshead"` is corrected for the load train; `"deflection"` is that of the specimen's midpoint. Needed if the file does not say it)"),
    plain("record", "displacement_column", Holds::text, R"("Extension")", "--displacement-column",
          "column of displacement in an export, by name or number, if it is not found"),
    plain("record", "specimen", Holds::whole_number, "2", "--specimen",
          "which specimen of an export with several, counted from 1", "", 1),
    plain("record", "calibration", Holds::text, R"("222 N/V")", "--calibration",
          "calibration of a force that an export gives in volts"),
    word("record", "sign", "find|keep|reverse", R"("keep")", "--sign",
         "whether to keep or reverse signs; found unless given: reversed if compression is negative"),
    CaseKey{"record", "zero", Holds::quantity, &kind::force, Range::any, 0, "find|keep", R"("0.2 mN")", "0.1", "--zero",
            "zero of the force, which is subtracted; found from rows before contact unless given", ""},
    CaseKey{"record", "contact", Holds::quantity, &kind::length, Range::any, 0, "find|first row", R"("12 um")", "0.01",
            "--contact", "displacement at first contact; unless given, found if the record begins before it", ""},
    word("record", "failure", "find|none", R"("none")", "--failure",
         "whether to find where the specimen fails and end the record there; find unless given"),
    word("record", "decimal", ".|,", R"(",")", "--decimal", "decimal mark of the file"),
    plain("record", "first", Holds::place, "12", "--first",
          "where the record begins: a row, counted from 1, or a stage position"),
    plain("record", "until", Holds::place, "250", "--until",
          "where the record ends, before failure: a row or a stage position; found unless given"),
    // sweep
    word("sweep", "method", "grid|latin hypercube", R"("grid")", "", "how designs are chosen: on a grid or as a sample",
         ". `\"grid\"` takes every value of an axis with every value of the others; `\"latin hypercube\"` takes a "
         "sample "
         "with one design in each of as many strata of each axis"),
    plain("sweep", "samples", Holds::whole_number, "1000", "", "number of designs in a Latin hypercube", "", 1),
    plain("sweep", "seed", Holds::whole_number, "1", "",
          "seed of a Latin hypercube; it gives the same sample on every machine"),
    plain("sweep", "axes", Holds::axes, "", "", "numbers of the case that vary, by name",
          ", in a section `[sweep.axes]`; all others are as the case has them"),
};

}  // namespace

std::span<const CaseKey> case_keys() { return keys; }

const CaseKey* case_key(std::string_view section, std::string_view name) {
  if (section.starts_with("friction.")) section = "friction";
  if (section == "sweep.axes") return case_key("sweep", "axes");
  if (const std::size_t index = section.find('['); index != std::string_view::npos) section = section.substr(0, index);
  const auto* at = std::find_if(keys.begin(), keys.end(),
                                [&](const CaseKey& key) { return key.section == section && key.name == name; });
  return at == keys.end() ? nullptr : at;
}

std::vector<std::string_view> words_of(const CaseKey& key) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < key.words.size();) {
    const std::size_t end = std::min(key.words.find('|', at), key.words.size());
    words.push_back(key.words.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

std::string what_holds(const CaseKey& key) {
  std::vector<std::string> parts;
  for (const std::string_view word : words_of(key)) parts.push_back(fmt::format("\"{}\"", word));
  switch (key.holds) {
    case Holds::quantity:
    case Holds::estimate:
      parts.insert(parts.begin(), std::string(key.kind->name));
      break;
    case Holds::share:
      parts.emplace_back("a share, such as \"2 %\"");
      break;
    case Holds::whole_number:
      parts.push_back(fmt::format("a whole number from {}", key.least));
      break;
    case Holds::yes_no:
      parts.emplace_back("true or false");
      break;
    case Holds::word:
      break;
    case Holds::name_or_number:
      parts.emplace_back("text, or a whole number");
      break;
    case Holds::text:
      parts.emplace_back("text");
      break;
    case Holds::title:
      parts.emplace_back("the title of a column");
      break;
    case Holds::file:
      parts.emplace_back("a file");
      break;
    case Holds::place:
      parts.emplace_back("a row, a length, or { deflection = … }");
      break;
    case Holds::lengths:
      parts.emplace_back("an array of lengths");
      break;
    case Holds::axes:
      parts.emplace_back("a section of ranges or lists");
      break;
    case Holds::section:
      parts.emplace_back("a section");
      break;
    case Holds::tables:
      parts.emplace_back("an array of tables");
      break;
  }
  if (parts.size() == 1) return parts.front();
  const std::string last = parts.back();
  parts.pop_back();
  return fmt::format("{} or {}", fmt::join(parts, ", "), last);
}

}  // namespace flexslip
