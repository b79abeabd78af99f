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
          "whether all its numbers are in reduced variables, without units; false, unless it is given"),
    // specimen
    quantity("specimen", "diameter", kind::length, Range::positive, R"("34.8 um")", "0.027", "--diameter",
             "of a solid round section, or the outer one of a tube"),
    quantity("specimen", "inner_diameter", kind::length, Range::positive, R"("30 um")", "0.02", "--inner-diameter",
             "of a tube, beside its diameter"),
    quantity("specimen", "wall", kind::length, Range::positive, R"("3 um")", "0.003", "--wall",
             "of a tube, instead of its inner diameter"),
    quantity("specimen", "width", kind::length, Range::positive, R"("50 um")", "0.04", "--width",
             "of a rectangular section, beside its height"),
    quantity("specimen", "height", kind::length, Range::positive, R"("30 um")", "0.02", "--height",
             "of a rectangular section, in the direction of bending"),
    estimate(
        "modulus", kind::pressure, R"("29.6 GPa")", "", "--modulus",
        "Young's modulus; found from the initial slope, unless it is given",
        R"(: `"29.6 GPa"`, with its standard deviation `{ value = "29.6 GPa", uncertainty = "1.5 GPa" }` or `uncertainty = "5 %"`, or `"fit"`)"),
    estimate("bending_stiffness", kind::bending_stiffness, R"("2.1e-9 N m^2")", "1", "--bending-stiffness",
             "EI, instead of section and modulus, in the same three ways", ""),
    plain("specimen", "material", Holds::text, R"("glass")", "", "what it is made of",
          ", only to hold friction against the literature, together with `support_material`"),
    at_most(1, "write it as \"2 %\" or 0.02",
            CaseKey{"specimen", "strain_at_break", Holds::share, nullptr, Range::positive, 0, "", R"("2 %")",
                    R"("2 %")", "", "the bending strain of its surface at which it breaks, with a section",
                    ": [`design` and `sweep`](rig-design.md) end there, `simulate` and `fit` say if the record gets "
                    "beyond"}),
    quantity("specimen", "strength", kind::pressure, Range::positive, R"("600 MPa")", "", "",
             "the bending stress of its surface at which it breaks, instead"),
    CaseKey{
        "specimen", "cracks", Holds::tables, nullptr, Range::any, 0, "", R"([{ deflection = "160 um", loss = "3 %" }])",
        R"([{ deflection = 0.12, loss = "3 %" }])", "", "where it cracks, for simulate",
        " (`design` and `sweep` refuse it, other commands leave it). When the deflection is first reached, the bending "
        "stiffness falls by that share of what is left, at once and for good ([theory.md](theory.md#cracks))"},
    quantity("specimen.cracks", "deflection", kind::length, Range::positive, R"("160 um")", "0.12", "",
             "at which it happens"),
    plain("specimen.cracks", "loss", Holds::share, R"("3 %")", "", "of the bending stiffness that is left"),
    // rig
    quantity("rig", "span", kind::length, Range::positive, R"("1278 um")", "1", "--span", "distance of the supports"),
    quantity("rig", "stiffness", kind::stiffness, Range::positive_or_infinite, R"("90.65 N/m")", "88.8", "--stiffness",
             "of the load train, which is whatever carries the load cell; \"inf\" for displacement control"),
    quantity("rig", "support_stiffness", kind::stiffness, Range::positive_or_infinite, R"("5 kN/mm")", "2000", "",
             "of each of the two supports, if they give way vertically",
             ". Load train and supports in line are then what stands between the stage and the deflection, which is "
             "always that of the midpoint below the ends of the specimen, and what it snaps on"),
    quantity("rig", "roller_radius", kind::length, Range::non_negative, R"("5 mm")", "0.08", "",
             "of rollers as supports; edges, unless it is given",
             ". What the specimen slides over is looked up where its axis touches"),
    word(
        "rig", "rollers", "fixed|pinned|loose", R"("pinned")", "", "what rollers do; fixed, unless it is given",
        R"(. `"pinned"`: they turn on pins, and friction is at most that of the pins, the same everywhere; `"loose"`: they roll on a flat base, and the specimen on them, as long as there is friction enough for that: simulate shows the curve, the other commands, which ask for friction, refuse it ([theory](theory.md#rollers-and-thickness)))"),
    quantity("rig", "pin_radius", kind::length, Range::positive, R"("1 mm")", "0.02", "", "of rollers on pins"),
    quantity("rig", "pin_friction", kind::number, Range::non_negative, "0.1", "0.1", "", "between roller and pin"),
    word(
        "rig", "friction_at", "surface|axis", R"("axis")", "",
        "where friction acts; at the surface, unless it is given",
        R"(: the specimen has the thickness of its section, and stands half of it off its supports; nothing is told of friction below a deflection of twice the thickness. `"axis"`: the paper's model, in which it has none)"),
    quantity("rig", "nose_radius", kind::length, Range::positive, R"("5 mm")", "0.08", "",
             "of the nose; sharp, unless it is given",
             ". It has no effect until the specimen is bent more sharply than nose and half depth allow; simulate, "
             "design and fit say where that is so, and compute on with a sharp one"),
    plain("rig", "support_material", Holds::text, R"("steel")", "", "what the supports are made of",
          "; nothing is said of the literature unless both materials are stated"),
    // friction
    word("friction", "model", "constant|drift|sinusoid|sinusoids|table|rough|surface|roughness", R"("sinusoid")", "",
         "the model of friction, to compute with or to fit"),
    quantity("friction", "mu0", kind::number, Range::non_negative, "0.5", "0.5", "", "mean coefficient of friction"),
    quantity("friction", "drift", kind::inverse_length, Range::any, R"("0.2 1/mm")", "0.3", "",
             "slope of friction in S; none, unless it is given", "; where it would carry μ below 0, μ is 0"),
    quantity("friction", "reference", kind::length, Range::positive, R"("1.5 mm")", "1.2", "",
             "length S at which friction is mu0, beside a drift; the span, unless it is given", ", and never below it"),
    at_most(1, "it is relative to mu0, and friction cannot be negative",
            quantity("friction", "amplitude", kind::number, Range::non_negative, "0.15", "0.15", "",
                     "of a wave, relative to mu0; at most 1")),
    quantity("friction", "wavelength", kind::length, Range::positive, R"("10.9 um")", "0.0085", "",
             "of a wave, along the specimen"),
    quantity("friction", "phase", kind::angle, Range::any, R"("90 deg")", "1.0", "",
             "of a wave, at S = 0; 0, unless it is given"),
    CaseKey{"friction", "waves", Holds::tables, nullptr, Range::any, 0, "",
            R"([{ amplitude = 0.15, wavelength = "10.9 um", phase = 1.0 }])",
            "[{ amplitude = 0.15, wavelength = 0.0085, phase = 1.0 }]", "", "several waves, of the model sinusoids",
            ", their amplitudes at most 1 in sum"},
    plain("friction", "file", Holds::file, R"("trace.csv")", "", "a table of friction over S"),
    title("friction", "length", kind::length, R"("S [um]")", R"("S")", "", "title of its column of S"),
    title("friction", "mu", kind::number, R"("mu")", R"("mu")", "",
          "title of its column of friction; mu, unless it is given"),
    quantity("friction", "rms", kind::number, Range::non_negative, "0.1", "0.1", "",
             "standard deviation of ln μ, of the model rough"),
    quantity("friction", "correlation_length", kind::length, Range::positive, R"("5 um")", "0.004", "",
             "of roughness, along the specimen"),
    plain("friction", "seed", Holds::whole_number, "1", "", "of its random numbers"),
    plain("friction", "trace", Holds::file, R"("trace.csv")", "",
          "a height profile of the surface that the support climbs, of the model surface",
          ", read as [`surface`](surface.md) reads it; `mu0` is the friction of the flat surface then"),
    plain("friction", "position", Holds::text, R"("x [um]")", "",
          "column of its positions, by name or number; found, unless it is given"),
    plain("friction", "height", Holds::text, R"("z [nm]")", "", "column of its heights, likewise"),
    quantity("friction", "trace_step", kind::length, Range::positive, R"("0.1 um")", "8e-5", "",
             "distance of its heights, of a file without positions"),
    quantity("friction", "trace_begin", kind::length, Range::non_negative, R"("639 um")", "0.5", "",
             "where on the specimen it begins, from midspan; half the span, unless it is given",
             ". Before it and beyond its end friction is mu0"),
    word("friction", "direction", "outwards|inwards", R"("inwards")", "",
         "which way it runs, seen from midspan; outwards, unless it is given"),
    plain("friction", "level", Holds::whole_number, "2", "",
          "degree of the polynomial that is taken off its heights; 1, a tilt, unless it is given"),
    quantity("friction", "cutoff", kind::length, Range::positive, R"("1 um")", "0.001", "",
             "of the Gaussian filter that takes shorter waves out of it; none, unless it is given"),
    quantity("friction", "edge_radius", kind::length, Range::non_negative, R"("1 um")", "0.001", "",
             "of the edge that climbs it; that of the rollers, or sharp, unless it is given",
             ": it reaches into no valley narrower than itself"),
    quantity("friction", "static_excess", kind::number, Range::non_negative, "0.1", "0.1", "",
             "by how much static friction is greater than kinetic friction; 0, unless it is given",
             ". For simulate alone"),
    quantity("friction", "build_up_length", kind::length, Range::non_negative, R"("2.5 um")", "0.002", "",
             "of sliding, over which friction builds up once the specimen turns back; 0, unless it is given",
             ", in S, as both sides slide ([theory](theory.md#friction-that-builds-up)); not beside `static_excess`, "
             "`[friction.other]`, `roller_radius`, cracks, or `snaps = \"overshoot\"`"),
    plain("friction", "other", Holds::section, "", "", "the friction of the other support, where it is another",
          ", in a section `[friction.other]` with a model and its keys"),
    // stage
    CaseKey{"stage", "program", Holds::lengths, &kind::length, Range::non_negative, 0, "", R"(["0 um", "900 um"])",
            "[0, 0.7]", "", "positions between which the stage moves straight on",
            ", at least two, none below 0: load, unload, reload. A position repeated is a halt"},
    plain("stage", "cycles", Holds::whole_number, "10", "",
          "how often all positions after the first are gone through; once, unless it is given", "", 1),
    CaseKey{"stage", "step", Holds::quantity, &kind::length, Range::positive, 0, "continuous", R"("2 um")", "0.002", "",
            "distance of the readings; continuous, unless it is given",
            ": the whole curve, with exact reversals and snaps"},
    plain("stage", "file", Holds::file, R"("run.csv")", "", "a table of positions that were measured",
          ", as in `[record]`"),
    title("stage", "stage", kind::length, R"("stage [um]")", R"("w_s")", "", "title of its column of positions"),
    title("stage", "time", kind::time, R"("t [s]")", R"("t")", "", "title of its column of time",
          ", if it is to be checked that no row is earlier than the one before. The model has no speed"),
    word("stage", "decimal", ".|,", R"(",")", "", "its decimal mark"),
    word(
        "stage", "snaps", "nearest|overshoot", R"("overshoot")", "",
        "where a snap comes to rest; nearest, unless it is given",
        R"(: at the next stable state, where the energy set free is lost at once, as in the paper; `"overshoot"`: it carries the specimen on until friction has consumed it)"),
    // record
    plain("record", "file", Holds::file, R"("ss14.csv")", "", "the measured record",
          ": CSV, or text separated by semicolons, tabs or spaces, with one header line; or an export of a testing "
          "machine; or a workbook (.xlsx) with either"),
    plain("record", "sheet", Holds::name_or_number, R"("Specimen 1")", "--sheet",
          "of a workbook (.xlsx): name or number of the sheet; the first with a table of numbers, unless it is given"),
    title("record", "stage", kind::length, R"("w_s_m [m]")", R"("w_s")", "--stage",
          "title of the column of the stage (crosshead) displacement"),
    title("record", "deflection", kind::length, R"("w_m [m]")", R"("w")", "--deflection",
          "title of the column of the deflection at midspan"),
    title("record", "force", kind::force, R"("F_N [N]")", R"("F")", "--force",
          "title of the column of the force; of an export, its name or number, if it is not found"),
    title("record", "length", kind::length, R"("S-L [um]")", R"("S-1")", "",
          "title of the column of the length pulled in over both supports, as imaged",
          " (S − L), if there is one: held against what the force says, point by point"),
    word(
        "record", "displacement", "crosshead|deflection", R"("crosshead")", "--displacement",
        "of an export: what its displacement is one of",
        R"(: `"crosshead"`, which is corrected for the load train, or `"deflection"`, of the specimen's midpoint. Needed where the words of the file do not say it)"),
    plain("record", "displacement_column", Holds::text, R"("Extension")", "--displacement-column",
          "of an export: name or number of a column, if it is not found"),
    plain("record", "specimen", Holds::whole_number, "2", "--specimen", "of an export of several: which, from 1", "",
          1),
    plain("record", "calibration", Holds::text, R"("222 N/V")", "--calibration",
          "of a force that an export gives in volts"),
    word("record", "sign", "find|keep|reverse", R"("keep")", "--sign",
         "of the force; found, unless it is given: reversed where compression is negative"),
    CaseKey{"record", "zero", Holds::quantity, &kind::force, Range::any, 0, "find|keep", R"("0.2 mN")", "0.1", "--zero",
            "of the force; found, unless it is given, from rows before the contact", ""},
    CaseKey{"record", "contact", Holds::quantity, &kind::length, Range::any, 0, "find|first row", R"("12 um")", "0.01",
            "--contact", "displacement at first contact; found if the record begins before it, unless it is given", ""},
    word("record", "failure", "find|none", R"("none")", "--failure",
         "whether the record ends where the specimen fails; found, unless it is given"),
    word("record", "decimal", ".|,", R"(",")", "--decimal", "decimal mark of the file"),
    plain("record", "first", Holds::place, "12", "--first",
          "where the record begins: a row, counted from 1, or a position of the stage"),
    plain("record", "until", Holds::place, "250", "--until",
          "where it ends, before failure, likewise; found, unless it is given"),
    // sweep
    word("sweep", "method", "grid|latin hypercube", R"("grid")", "", "how designs are taken",
         ": `\"grid\"`, every value of an axis with every value of the others, or `\"latin hypercube\"`, a sample that "
         "meets each of as many strata of each axis once"),
    plain("sweep", "samples", Holds::whole_number, "1000", "", "how many designs, of a Latin hypercube", "", 1),
    plain("sweep", "seed", Holds::whole_number, "1", "",
          "which sample, of a Latin hypercube; the same one on every machine"),
    plain("sweep", "axes", Holds::axes, "", "", "the numbers of the case that vary, by name",
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
