#include "case/case_file.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "tests/has.h"
#include "tests/refusal.h"

using namespace flexslip;

namespace {

// The example of the documentation, whole.
constexpr std::string_view full = R"([specimen]
diameter = "34.8 um"
modulus  = { value = "29.6 GPa", uncertainty = "1.5 GPa" }
[rig]
span      = "1278 um"
stiffness = "90.65 N/m"
[friction]
model = "sinusoid"
mu0 = 0.5
amplitude = 0.15
wavelength = "10.9 um"
phase = 1.0
[stage]
program = ["0 um", "900 um", "0 um", "900 um"]
step = "2 um"
[record]
file  = "ss14.csv"
stage = "w_s_m [m]"
force = "F_N [N]"
until = 267
)";

Test read(std::string_view text) { return read_case(text, "data/case.toml"); }

std::string complaint(std::string_view text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// The complaint about the full example with one piece of it replaced.
std::string complaint_with(std::string_view piece, std::string_view replacement) {
  std::string text(full);
  const std::size_t at = text.find(piece);
  REQUIRE(at != std::string::npos);
  return complaint(text.replace(at, piece.size(), replacement));
}

void check_same(const Test& a, const Test& b) {
  CHECK(a.reduced == b.reduced);
  CHECK(a.specimen == b.specimen);
  CHECK(a.rig == b.rig);
  CHECK(a.friction == b.friction);
  CHECK(a.other == b.other);
  CHECK(a.stage == b.stage);
  CHECK(a.record == b.record);
}

}  // namespace

TEST_CASE("table: the documented example, in SI") {
  const Test input = read(full);
  CHECK_FALSE(input.reduced);
  CHECK(input.specimen == SpecimenInput{.diameter = 34.8e-6, .modulus = Known{29.6e9, 1.5e9}});
  CHECK(input.rig == RigInput{.span = 1278e-6, .stiffness = 90.65});
  CHECK(input.friction ==
        FrictionInput{
            .model = FrictionModel::sinusoid, .mu0 = 0.5, .amplitude = 0.15, .wavelength = 10.9e-6, .phase = 1.0});
  CHECK(input.stage == StageInput{.program = {0, 900e-6, 0, 900e-6}, .step = 2e-6});
  CHECK(input.record ==
        RecordInput{.file = "data/ss14.csv", .stage = "w_s_m [m]", .force = "F_N [N]", .until = AtRow{267}});
  CHECK(input.lines.at("specimen.diameter") == 2);
  CHECK(input.lines.at("specimen.modulus.uncertainty") == 3);
  CHECK(input.lines.at("rig") == 4);
  CHECK(input.lines.at("stage.program[2]") == 14);
  CHECK(input.lines.at("record.until") == 20);
}

TEST_CASE("table: the specimens that can be described") {
  const auto specimen = [](const std::string& text) { return *read("[specimen]\n" + text).specimen; };
  CHECK(specimen("diameter = '1 um'") == SpecimenInput{.diameter = 1e-6});
  CHECK(specimen("diameter = '1 um'\nmodulus = 'fit'") == SpecimenInput{.diameter = 1e-6, .modulus = ToFit{}});
  CHECK(specimen("width = '2 um'\nheight = '1 um'\nmodulus = '3 GPa'") ==
        SpecimenInput{.width = 2e-6, .height = 1e-6, .modulus = Known{3e9}});
  CHECK(specimen("diameter = '4 mm'\ninner_diameter = '3 mm'") ==
        SpecimenInput{.diameter = 4e-3, .inner_diameter = 3e-3});
  CHECK(section_of(read("[specimen]\ndiameter = '4 mm'\nwall = '0.5 mm'")) == Section{TubularSection{4e-3, 3e-3}});
  CHECK(section_of(read("[specimen]\nwidth = '2 um'\nheight = '1 um'")) == Section{RectangularSection{2e-6, 1e-6}});
  CHECK(specimen("bending_stiffness = '2.1e-12 N m^2'") == SpecimenInput{.bending_stiffness = Known{2.1e-12}});
  CHECK(specimen("bending_stiffness = 'fit'\ndiameter = '1 um'") ==
        SpecimenInput{.diameter = 1e-6, .bending_stiffness = ToFit{}});
  CHECK(specimen("bending_stiffness = { value = '2 N m^2', uncertainty = '5 %' }") ==
        SpecimenInput{.bending_stiffness = Known{2, 2 * 0.05}});
}

TEST_CASE("table: the uncertainties that can be stated, in three ways") {
  const auto rig = [](const std::string& text) { return *read("[rig]\n" + text).rig; };
  const RigInput known{.span = 1e-3, .stiffness = Known{90, 0.003 * 90}};
  CHECK(rig("span = '1 mm'\nstiffness = { value = '90 N/m', uncertainty = '0.3 %' }") == known);
  CHECK(rig("span = '1 mm'\nstiffness = '90 N/m ± 0.3 %'") == known);
  CHECK(rig("span = '1 mm'\nstiffness = '90 ± 0.27 N/m'") == known);
  CHECK(rig("span = '1 mm'\nstiffness = '90 N/m ± 0.27'") == known);
  CHECK(rig("span = '1 mm'\nstiffness = '90 N/m +- 0.3 %'") == known);
  const std::string plain = "[rig]\nspan = '1 mm'\nstiffness = '90 N/m'";
  CHECK(read_case(plain, "case.toml", {"rig.stiffness.uncertainty=0.3 %"}).rig == known);
  CHECK(read_case(plain, "case.toml", {"rig.stiffness=90 N/m ± 2 %", "rig.stiffness.uncertainty=0.3 %"}).rig == known);
  CHECK(rig("span = '1 mm ± 2 um'\nroller_radius = '1 mm ± 0 %'") ==
        RigInput{.span = Known{1e-3, 2e-6}, .roller_radius = Known{1e-3, 0}});
  CHECK(read("[specimen]\nwidth = '2 um ± 1 %'\nheight = '1 um ± 10 nm'").specimen ==
        SpecimenInput{.width = Known{2e-6, 0.01 * 2e-6}, .height = Known{1e-6, 10e-9}});
  const auto record = [](const std::string& text) {
    return *read(
                "[rig]\nspan = '1 mm'\n[specimen]\ndiameter = '1 um'\n[record]\nfile = 'a.csv'\nstage = 'w [um]'\n"
                "force = 'F [N]'\n" +
                text)
                .record;
  };
  CHECK(record("gain_error = '1 %'").gain_error == 0.01);
  CHECK(record("gain_error = '0 %'").gain_error == 0.0);
  CHECK(record("slow_force_error = '2 %'").slow_force_error == 0.02);
  CHECK(record("preload_error = '3 um'").preload_error == doctest::Approx(3e-6));
  CHECK(record("contact = '-3 um ± 1 um'").contact == ContactRule{Known{-3e-6, 1e-6}});
  CHECK(record("contact = 'find'").contact == ContactRule{ContactWord::find});
}

TEST_CASE("table: uncertainties that are refused") {
  const auto said = [](const std::string& text) { return complaint("[rig]\nspan = '1 mm'\n" + text); };
  CHECK(has(said("stiffness = '90 N/m ± -1 %'"),
            ":3: [rig] stiffness.uncertainty: '-1 %' is not a non-negative plain number"));
  CHECK(has(said("stiffness = { value = '90 N/m', uncertainty = '31 %' }"),
            ":3: [rig] stiffness.uncertainty: The uncertainty is 31 % of the value, more than 30 %"));
  CHECK(has(said("stiffness = '90 N/m ± 1 um'"), "'1 um' is a length, not a stiffness"));
  CHECK(has(said("stiffness = 'inf ± 1 %'"), "An infinite value has no uncertainty"));
  CHECK(has(said("nose_radius = { value = '1 mm', uncertainty = '1 %' }"),
            ":3: [rig] nose_radius: A table is not a length. It is taken as exact: leave the uncertainty out"));
  CHECK(has(said("roller_radius = '0 mm ± 1 um'"), "of the value, more than 30 %"));
  CHECK_THROWS_AS(read_case("", "case.toml", {"rig.nose_radius.uncertainty=1 %"}), InputError);
}

TEST_CASE("table: the friction that can be described") {
  const auto friction = [](const std::string& text) { return *read("[friction]\n" + text).friction; };
  using enum FrictionModel;
  CHECK(friction("") == FrictionInput{});
  CHECK(friction("model = 'roughness'") == FrictionInput{.model = roughness});
  CHECK(friction("model = 'sinusoid'") == FrictionInput{.model = sinusoid});
  CHECK(friction("model = 'constant'\nmu0 = 0.5\ndrift = '0.2 1/mm'") ==
        FrictionInput{.model = constant, .mu0 = 0.5, .drift = 200});
  CHECK(friction("model = 'drift'\nmu0 = 0.5\ndrift = '0.2 1/mm'\nreference = '1.4 mm'") ==
        FrictionInput{.model = drift, .mu0 = 0.5, .drift = 200, .reference = 1.4e-3});
  CHECK(friction("model = 'sinusoids'\nmu0 = 0.5\ndrift = '0.2 1/mm'\nreference = '1.4 mm'\n"
                 "waves = [{ amplitude = 0.1, wavelength = '1 um' }]") ==
        FrictionInput{.model = sinusoids, .mu0 = 0.5, .drift = 200, .reference = 1.4e-3, .waves = {{0.1, 1e-6}}});
  CHECK(friction("model = 'sinusoid'\nmu0 = 1\namplitude = 0\nwavelength = '1 um'\nphase = '90 deg'") ==
        FrictionInput{.model = sinusoid, .mu0 = 1, .amplitude = 0, .wavelength = 1e-6, .phase = std::numbers::pi / 2});
  const Test unlike = read(
      "[friction]\nmodel = 'constant'\nmu0 = 0.5\n[friction.other]\nmodel = 'sinusoid'\nmu0 = 0.4\namplitude = 0.1\n"
      "wavelength = '1 um'\nphase = 2");
  CHECK(unlike.friction == FrictionInput{.model = constant, .mu0 = 0.5});
  CHECK(unlike.other == FrictionInput{.model = sinusoid, .mu0 = 0.4, .amplitude = 0.1, .wavelength = 1e-6, .phase = 2});
  const FrictionInput two{.model = sinusoids, .mu0 = 0.5, .waves = {{0.1, 1e-6, 2}, {0.2, 3e-6}}};
  CHECK(friction("model = 'sinusoids'\nmu0 = 0.5\nwaves = [{ amplitude = 0.1, wavelength = '1 um', phase = 2 }, "
                 "{ amplitude = 0.2, wavelength = '3 um' }]") == two);
  CHECK(friction("model = 'sinusoids'\nmu0 = 0.5\n[[friction.waves]]\namplitude = 0.1\nwavelength = '1 um'\nphase = 2\n"
                 "[[friction.waves]]\namplitude = 0.2\nwavelength = '3 um'") == two);
  CHECK(friction("model = 'table'\nfile = 'afm.csv'\nlength = 'S [um]'") ==
        FrictionInput{.model = table, .file = "data/afm.csv", .length = "S [um]"});
  CHECK(friction("model = 'constant'\nmu0 = 0.5\nstatic_excess = 0.05\nwear = 0.9") ==
        FrictionInput{.model = constant, .mu0 = 0.5, .static_excess = 0.05, .wear = 0.9});
  CHECK(friction("model = 'rough'\nmu0 = 0.5\nrms = 0.1\ncorrelation_length = '5 um'\nseed = 7") ==
        FrictionInput{.model = rough, .mu0 = 0.5, .rms = 0.1, .correlation_length = 5e-6, .seed = 7});
  CHECK(friction("model = 'surface'\nmu0 = 0.5\ntrace = 'afm.csv'") ==
        FrictionInput{.model = surface, .mu0 = 0.5, .trace = "data/afm.csv"});
  CHECK(
      friction("model = 'surface'\nmu0 = 0.5\ntrace = 'afm.csv'\nposition = 'x [um]'\nheight = '3'\ntrace_begin = '600 "
               "um'\ndirection = 'inwards'\nlevel = 2\ncutoff = '1 um'\nedge_radius = '2 um'") ==
      FrictionInput{.model = surface,
                    .mu0 = 0.5,
                    .trace = "data/afm.csv",
                    .position = "x [um]",
                    .height = "3",
                    .trace_begin = 600e-6,
                    .direction = TraceDirection::inwards,
                    .level = 2,
                    .cutoff = 1e-6,
                    .edge_radius = 2e-6});
}

TEST_CASE("table: surfaces that cannot be are refused") {
  const auto refusal = [](const std::string& text) {
    return message_of([&] { read_case("[friction]\nmodel = 'surface'\n" + text, "case.toml"); });
  };
  CHECK(has(refusal("mu0 = 0\ntrace = 'a'"),
            "[friction] mu0: The friction of the flat surface is 0, but it must be above 0"));
  CHECK(has(refusal("mu0 = 0.5"), "[friction] trace"));
  CHECK(has(refusal("mu0 = 0.5\ntrace = 'a'\nlevel = 10"), "The degree is 10, above the limit of 9"));
  CHECK(has(refusal("mu0 = 0.5\ntrace = 'a'\nposition = 'x'\ntrace_step = '1 um'"),
            "trace_step: A trace has either a trace_step or a position, not both"));
  CHECK(has(refusal("mu0 = 0.5\ntrace = 'a'\ndirection = 'up'"), "direction"));
}

TEST_CASE("table: rigs, stages and records that can be described") {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(read("[rig]\nspan = '1 mm'\nstiffness = 'inf'").rig == RigInput{.span = 1e-3, .stiffness = infinity});
  CHECK(read("[rig]\nspan = '1 mm'\nstiffness = inf").rig == RigInput{.span = 1e-3, .stiffness = infinity});
  CHECK(read("[rig]\nspan = '1 mm'").rig == RigInput{.span = 1e-3});
  CHECK(read("[stage]\nprogram = ['0 um', '1 mm']\nstep = 'continuous'").stage == StageInput{.program = {0, 1e-3}});
  CHECK(read("[stage]\nprogram = ['0 um', '1 mm']").stage == StageInput{.program = {0, 1e-3}});
  CHECK(read("[stage]\nprogram = ['0 um', '1 mm', '1 mm', '0 um']\ncycles = 10\nsnaps = 'overshoot'").stage ==
        StageInput{.program = {0, 1e-3, 1e-3, 0}, .cycles = 10, .snaps = SnapRest::overshoot});
  CHECK(read("[stage]\nfile = 'run.csv'\nstage = 'w_s [um]'").stage ==
        StageInput{.file = "data/run.csv", .stage = "w_s [um]"});
  CHECK(read("[stage]\nfile = 'run.csv'\nstage = 's'\ntime = 't [s]'\ndecimal = ','\nsnaps = 'nearest'").stage ==
        StageInput{
            .file = "data/run.csv", .stage = "s", .time = "t [s]", .decimal = ',', .snaps = SnapRest::nearest_stable});
  CHECK(read("[record]\nfile = '/a/b.csv'\ndeflection = 'w'\nforce = 'F [mN]'\ncontact = '-3 um'\ndecimal = ','")
            .record ==
        RecordInput{.file = "/a/b.csv", .deflection = "w", .force = "F [mN]", .contact = -3e-6, .decimal = ','});
  CHECK(read_case("[record]\nfile = 'b.csv'\nstage = 's'\nforce = 'F'", "standard input").record->file == "b.csv");
}

TEST_CASE("table: the exports and the preparations that can be described") {
  const auto record = [](const std::string& text) { return *read("[record]\nfile = '/a'\n" + text).record; };
  CHECK(record("") == RecordInput{.file = "/a"});
  CHECK(record("displacement = 'crosshead'") == RecordInput{.file = "/a", .displacement = DisplacementOf::crosshead});
  CHECK(record("displacement = 'deflection'\ndisplacement_column = 'LVDT'\nforce = '4'\nspecimen = 2\n"
               "calibration = '222 N/V'\ndecimal = ','") == RecordInput{.file = "/a",
                                                                        .force = "4",
                                                                        .displacement = DisplacementOf::deflection,
                                                                        .displacement_column = "LVDT",
                                                                        .specimen = 2,
                                                                        .calibration = "222 N/V",
                                                                        .decimal = ','});
  const std::string table = "stage = 's'\nforce = 'F'\n";
  CHECK(record(table).sign == SignRule::find);
  CHECK(record(table + "sign = 'find'").sign == SignRule::find);
  CHECK(record(table + "sign = 'keep'").sign == SignRule::keep);
  CHECK(record(table + "sign = 'reverse'").sign == SignRule::reverse);
  CHECK(record(table).zero == ForceZeroRule{ZeroWord::find});
  CHECK(record(table + "zero = 'find'").zero == ForceZeroRule{ZeroWord::find});
  CHECK(record(table + "zero = 'keep'").zero == ForceZeroRule{ZeroWord::keep});
  CHECK(record(table + "zero = '-0.12 N'").zero == ForceZeroRule{-0.12});
  CHECK(!record(table).contact);
  CHECK(record(table + "contact = 'find'").contact == ContactRule{ContactWord::find});
  CHECK(record(table + "contact = 'first row'").contact == ContactRule{ContactWord::first_row});
  CHECK(record(table + "contact = '12 um'").contact == ContactRule{12e-6});
  CHECK(record(table + "until = 250").until == PlaceInRecord{AtRow{250}});
  CHECK(record(table + "first = '120 um'").first == PlaceInRecord{AtStage{120e-6}});
  CHECK(record(table + "first = { stage = '120 um' }").first == PlaceInRecord{AtStage{120e-6}});
  CHECK(record(table + "until = { deflection = '80 um' }").until == PlaceInRecord{AtDeflection{80e-6}});
  CHECK(read("[specimen]\nbending_stiffness = 'fit'\nmaterial = 'glass'").specimen->material == "glass");
  CHECK(read("[rig]\nspan = '1 mm'\nsupport_material = 'steel'").rig->support_material == "steel");
  CHECK(record(table).failure == FailureRule::find);
  CHECK(record(table + "failure = 'find'").failure == FailureRule::find);
  CHECK(record(table + "failure = 'none'").failure == FailureRule::none);

  // What an export may say itself is not asked for.
  CHECK_FALSE(read("[record]\nfile = 'a'\n[rig]\nstiffness = 'inf'").rig->span.has_value());
  CHECK_FALSE(section_of(read("[record]\nfile = 'a'\n[specimen]\nmodulus = '3 GPa'")).has_value());
}

TEST_CASE("table: exports and preparations that cannot be are refused") {
  const auto refusal = [](const std::string& text) { return complaint("[record]\nfile = 'a'\n" + text); };
  CHECK(has(refusal("stage = 's'\ndisplacement = 'crosshead'"),
            ":4: [record] displacement: Of column titles and the description of an export only one can be stated"));
  CHECK(has(refusal("displacement = 'stage'"),
            ":3: [record] displacement: 'stage' is not \"crosshead\" or \"deflection\""));
  CHECK(has(refusal("specimen = 0"), "[record] specimen: The number 0 is not a whole number of at least 1"));
  CHECK(has(refusal("sign = 'flip'"), "[record] sign: 'flip' is not \"find\", \"keep\" or \"reverse\""));
  CHECK(has(refusal("zero = '3 um'"), "[record] zero: '3 um' is a length, not a force"));
  CHECK(has(refusal("contact = 'first'"), "[record] contact: 'first' is not a length"));
  CHECK(has(refusal("failure = true"), "[record] failure: True or false is not \"find\" or \"none\""));
  CHECK(has(complaint("reduced = true\n[record]\nfile = 'a'\ndisplacement = 'deflection'"),
            "A reduced case needs two of the columns stage, deflection and force. Delete reduced = true"));
}

TEST_CASE("table: a place in the record is a row, or one position") {
  const auto until = [](const std::string& place) { return complaint("[record]\nfile = '/a'\nuntil = " + place); };
  CHECK(has(complaint("[record]\nfile = '/a'\nlength = 'dS [mm]'"),
            "A length also needs stage or deflection, and force"));
  CHECK(has(until("0"), "The number 0 is not a whole number of at least 1"));
  CHECK(has(until("{ }"), "A place is either a stage or a deflection, and neither is stated"));
  CHECK(has(until("{ stage = '1 mm', deflection = '1 mm' }"),
            "A place is either a stage or a deflection, and both are stated"));
  CHECK(has(until("{ depth = '1 mm' }"), "depth"));
  CHECK(has(until("{ stage = 3 }"), "unit"));
}

TEST_CASE("table: a fault is data for programs: its kind, its key, its limit") {
  const auto fault_of = [](const char* text) {
    try {
      read_case(text, "case.toml");
    } catch (const InputError& error) {
      return error.fault;
    }
    return InputFault{};
  };
  const InputFault missing = fault_of("[specimen]\nwidth = \"1 mm\"\nmodulus = \"1 GPa\"\n");
  CHECK(missing.kind == FaultKind::missing);
  CHECK(missing.key == "specimen.height");
  const InputFault unknown = fault_of("[rig]\nspam = \"1 mm\"\n");
  CHECK(unknown.kind == FaultKind::unknown);
  CHECK(unknown.key == "rig.spam");
  const InputFault wrong = fault_of("[rig]\nspan = \"1 N\"\n");
  CHECK(wrong.kind == FaultKind::wrong);
  CHECK(wrong.key == "rig.span");
  CHECK(!wrong.limit);
  const InputFault too_much = fault_of("[specimen]\ndiameter = \"1 mm\"\nmodulus = \"1 GPa\"\nstrain_at_break = 2.5\n");
  CHECK(too_much.kind == FaultKind::too_much);
  CHECK(too_much.limit == 1);
}

TEST_CASE("table: a tube needs a wall") {
  const auto refusal = [](const std::string& text) { return complaint("[specimen]\n" + text); };
  CHECK(has(refusal("diameter = '4 mm'\ninner_diameter = '4 mm'"),
            ":3: [specimen] inner_diameter: The inner diameter of 4 mm is not below the outer diameter"));
  CHECK(has(refusal("diameter = '4 mm'\ninner_diameter = '5 mm'"), "Check which of the two is which"));
  CHECK(has(refusal("diameter = '4 mm'\nwall = '2 mm'"),
            ":3: [specimen] wall: The wall is 2 mm thick, which is half the diameter or more"));
  CHECK(has(refusal("diameter = '4 mm'\nwall = '1 mm'\ninner_diameter = '2 mm'"),
            "A tube has either an inner_diameter or a wall, not both. Delete one"));
  CHECK(has(refusal("inner_diameter = '4 mm'"), "[specimen] diameter: This value is missing"));
  CHECK(has(refusal("width = '4 mm'\ninner_diameter = '2 mm'"), "either a diameter or width and height"));
}

TEST_CASE("table: a reference is a length beside a drift") {
  const auto refusal = [](const std::string& text) { return complaint("[friction]\nmu0 = 0.5\n" + text); };
  CHECK(refusal("model = 'sinusoid'\namplitude = 0.1\nwavelength = '1 um'\nreference = '1.4 mm'") ==
        "data/case.toml:6: [friction] reference: A reference length needs a drift. Add drift, or delete reference: "
        "without a drift mu0 holds at every length.");
  CHECK(has(refusal("model = 'constant'\nreference = '1.4 mm'"), "A reference length needs a drift"));
  CHECK(
      has(refusal("model = 'constant'\ndrift = '0.2 1/mm'\nreference = 1.4"), ":5: [friction] reference: The number"));
  CHECK(has(refusal("model = 'constant'\ndrift = '0.2 1/mm'\nreference = '0 mm'"), "is not a positive length"));
  CHECK(has(refusal("model = 'rough'\nrms = 0.1\ncorrelation_length = '5 um'\nseed = 1\nreference = '1.4 mm'"),
            ":7: [friction] reference: This key has no meaning here"));
  const Test reduced = read("reduced = true\n[friction]\nmodel = 'constant'\nmu0 = 0.5\ndrift = 0.2\nreference = 1.1");
  CHECK(reduced.friction ==
        FrictionInput{.model = FrictionModel::constant, .mu0 = 0.5, .drift = 0.2, .reference = 1.1});
}

TEST_CASE("table: reduced cases hold plain numbers, and have the span and EI of one") {
  const Test input = read(
      "reduced = true\n[rig]\nstiffness = 30\n[friction]\nmodel = 'sinusoid'\nmu0 = 0.6\n"
      "amplitude = 0.4\nwavelength = 0.0628\nphase = '180 deg'\n[stage]\nprogram = [0, 0.75]\nstep = 0.01");
  CHECK(input.reduced);
  CHECK(input.specimen == SpecimenInput{.bending_stiffness = Known{1}});
  CHECK(input.rig == RigInput{.span = 1, .stiffness = 30});
  CHECK(input.friction == FrictionInput{.model = FrictionModel::sinusoid,
                                        .mu0 = 0.6,
                                        .amplitude = 0.4,
                                        .wavelength = 0.0628,
                                        .phase = std::numbers::pi});
  CHECK(input.stage == StageInput{.program = {0, 0.75}, .step = 0.01});
  CHECK(read("reduced = true\n[specimen]\nbending_stiffness = { value = 1, uncertainty = 0.05 }")
            .specimen->bending_stiffness == StatedStiffness{Known{1, 0.05}});
  CHECK(std::isinf(*read("reduced = true\n[rig]\nspan = 1\nstiffness = 'inf'").rig->stiffness));

  CHECK(complaint("reduced = true\n[rig]\nstiffness = '30 N/m'") ==
        "data/case.toml:3: [rig] stiffness: '30 N/m' is not a plain number. The case is reduced: write it in reduced "
        "variables, without quotes and unit, or delete reduced = true");
  CHECK(has(complaint("reduced = true\n[rig]\nspan = 2"), "[rig] span: The span is 2, but a reduced case has 1"));
  CHECK(has(complaint("reduced = true\n[specimen]\nbending_stiffness = 2"), "but a reduced case has 1"));
  CHECK(has(complaint("reduced = true\n[specimen]\nmodulus = 3"), "A reduced case has no modulus"));
  CHECK(has(complaint("reduced = true\n[record]\nfile = 'a'\nstage = 'w [m]'\nforce = 'F'"), "but no unit is needed"));
  CHECK(has(complaint("reduced = 1"), "data/case.toml:1: reduced: This is true or false, not the number 1"));
}

TEST_CASE("table: a bare number, a wrong unit or an impossible value is refused at its line") {
  CHECK(complaint_with("\"1278 um\"", "1278") ==
        "data/case.toml:5: [rig] span: The number '1278' has no unit, but a length needs one. Write \"1278 nm\", "
        "\"1278 um\", \"1278 mm\" or \"1278 m\".");
  CHECK(has(complaint_with("\"90.65 N/m\"", "\"90.65 N\""),
            ":6: [rig] stiffness: '90.65 N' is a force, not a stiffness"));
  CHECK(has(complaint_with("\"90.65 N/m\"", "\"-90.65 N/m\""),
            ":6: [rig] stiffness: '-90.65 N/m' is not a positive stiffness"));
  CHECK(has(complaint_with("\"90.65 N/m\"", "nan"), ":6: [rig] stiffness: 'nan' is not a known stiffness"));
  CHECK(has(complaint_with("\"90.65 N/m\"", "true"), ":6: [rig] stiffness: True or false is not a stiffness"));
  CHECK(has(complaint_with("\"1.5 GPa\"", "\"1.5 um\""),
            ":3: [specimen] modulus.uncertainty: '1.5 um' is a length, not a modulus"));
  CHECK(has(complaint_with("\"34.8 um\"", "\"inf\""), ":2: [specimen] diameter: 'inf' is not a finite length"));
  CHECK(
      has(complaint_with("mu0 = 0.5", "mu0 = -0.5"), ":9: [friction] mu0: '-0.5' is not a non-negative plain number"));
  CHECK(has(complaint_with("mu0 = 0.5", "mu0 = \"0.5\""),
            ":9: [friction] mu0: '0.5' is not a plain number. Write it without quotes"));
  CHECK(has(complaint_with("amplitude = 0.15", "amplitude = 1.5"),
            "[friction] amplitude: The value 1.5 is above the limit of 1"));
  CHECK(has(complaint_with("\"900 um\"", "\"900\""), ":14: [stage] program[2]: The number"));
  CHECK(has(complaint_with("\"900 um\"", "\"-900 um\""),
            ":14: [stage] program[2]: '-900 um' is not a non-negative length"));
  CHECK(has(complaint_with("\"2 um\"", "\"1e-9 um\""),
            ":15: [stage] step: The program has 2.7e+12 steps, more than the limit of 1e+07"));
  CHECK(has(complaint_with("step = \"2 um\"", "cycles = 0"),
            ":15: [stage] cycles: The number 0 is not a whole number of at least 1"));
  CHECK(has(complaint_with("step = \"2 um\"", "cycles = 1000000000000"),
            ":15: [stage] cycles: The program has 3.0e+12 turning points, more than the limit of 1e+05"));
  CHECK(has(complaint_with("step = \"2 um\"", "snaps = \"far\""),
            ":15: [stage] snaps: 'far' is not \"nearest\" or \"overshoot\""));
  CHECK(has(complaint_with("mu0 = 0.5", "mu0 = 0.5\nstatic_excess = -0.1"),
            ":10: [friction] static_excess: '-0.1' is not a non-negative plain number"));
  CHECK(has(complaint_with("until = 267", "until = 0"),
            ":20: [record] until: The number 0 is not a whole number of at least 1"));
  CHECK(has(complaint_with("until = 267", "until = 2.5"), ":20: [record] until: The number 2.5 is not a whole number"));
  CHECK(has(complaint_with("[N]\"", "[um]\""),
            ":19: [record] force: The unit 'um' measures a length, but a unit of force is needed"));
  CHECK(has(complaint_with("until = 267", "decimal = \"x\""), ":20: [record] decimal: 'x' is not \".\" or \",\""));
}

TEST_CASE("table: an unknown key or section is refused with the nearest known") {
  CHECK(complaint_with("diameter", "diamter") ==
        "data/case.toml:2: [specimen] diamter: There is no such key. Did you mean 'diameter'?");
  CHECK(has(complaint_with("diameter", "x"),
            ":2: [specimen] x: There is no such key. The keys are 'diameter', 'inner_diameter', 'wall', 'width', "
            "'height', 'modulus', 'bending_stiffness', 'material', 'strain_at_break', 'strength' and 'cracks'"));
  CHECK(
      has(complaint_with("[friction]", "[frictoin]"), ":7: frictoin: There is no such key. Did you mean 'friction'?"));
  CHECK(has(complaint_with("\"sinusoid\"", "\"sinussoid\""),
            ":8: [friction] model: 'sinussoid' is not \"constant\", \"drift\""));
  CHECK(has(complaint_with("\"sinusoid\"", "\"sinussoid\""), "Did you mean \"sinusoid\"?"));
  CHECK(has(complaint_with("\"sinusoid\"", "\"constant\""), "This key has no meaning here. Leave it out"));
  CHECK(has(complaint_with("uncertainty", "sd"), ":3: [specimen] modulus.sd: There is no such key. The keys are"));
  CHECK(has(complaint_with("model", "modle"), "Did you mean 'model'?"));
  CHECK(has(complaint_with("force", "forse"), ":19: [record] forse: There is no such key. Did you mean 'force'?"));
  CHECK(has(complaint("rig = 5"), "data/case.toml:1: [rig]: The case needs a section [rig], not the number 5"));
}

std::vector<std::string> all_said_of(std::string_view text) {
  try {
    read_case(text, "case.toml");
  } catch (const InputError& error) {
    CHECK(std::string(error.what()) == error.lines().front());
    return error.lines();
  }
  return {};
}

TEST_CASE("bad input: all that is wrong with a case is said at once, in the order of its lines") {
  constexpr std::string_view wrong = R"([rig]
spann = "1278 um"
stiffness = "90 um"
supports = "edge"
[specimen]
diametre = "34 um"
modulus = "30 GP"
[recrod]
file = "test.csv"
)";
  const std::vector<std::string> lines = all_said_of(wrong);
  const std::vector<std::string> expected{
      "case.toml:2: [rig] spann: There is no such key. Did you mean 'span'?",
      "case.toml:3: [rig] stiffness: '90 um' is a length, not a stiffness.",
      "case.toml:4: [rig] supports: 'edge' is not \"edges\" or \"rollers\". Did you mean \"edges\"?",
      "case.toml:6: [specimen] diametre: There is no such key. Did you mean 'diameter'?",
      "case.toml:7: [specimen] modulus: 'GP' is not a unit. Did you mean 'GPa'?",
      "case.toml:8: recrod: There is no such key. Did you mean 'record'?"};
  REQUIRE(lines.size() == expected.size());
  for (std::size_t i = 0; i < lines.size(); ++i) CHECK(lines[i].starts_with(expected[i]));
}

TEST_CASE("bad input: what does not belong together is said of every section at once") {
  constexpr std::string_view wrong = R"([specimen]
width = "1 mm"
[rig]
stiffness = "90 N/m"
[record]
file = "test.csv"
stage = "w_s"
deflection = "w"
force = "F"
)";
  const std::vector<std::string> lines = all_said_of(wrong);
  const std::vector<std::string> expected{"case.toml:1: [specimen] height", "case.toml:3: [rig] span",
                                          "case.toml:7: [record] stage: Two of the columns"};
  REQUIRE(lines.size() == expected.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    CAPTURE(lines[i]);
    CHECK(lines[i].starts_with(expected[i]));
  }
}

TEST_CASE("table: what is missing is asked for with an example") {
  CHECK(complaint_with("span      = \"1278 um\"\n", "") ==
        "data/case.toml:4: [rig] span: This value is missing. Add span = \"1278 um\".");
  CHECK(has(complaint_with("mu0 = 0.5\n", ""), ":7: [friction] mu0: This value is missing. Add mu0 = 0.5"));
  CHECK(has(complaint_with("model = \"sinusoid\"\n", ""), "Add model = \"sinusoid\""));
  CHECK(has(complaint_with("force = \"F_N [N]\"\n", ""),
            "Two of the columns stage, deflection and force are needed, and only stage is stated"));
  CHECK(has(complaint_with("until = 267", "deflection = \"w0_m [m]\""),
            "Two of the columns stage, deflection and force are needed, and all three are stated"));
  CHECK(has(complaint("[specimen]\nmodulus = '3 GPa'"), "[specimen] diameter: This value is missing"));
  CHECK(has(complaint("[specimen]\nwidth = '3 um'"), "Add height = "));
  CHECK(has(complaint("[friction]\nmodel = 'sinusoids'\nmu0 = 1\nwaves = [{ wavelength = '1 um' }]"),
            ":4: [friction] waves[1].amplitude: This value is missing. Add amplitude = 0.15"));
  CHECK(has(complaint("[specimen]\nbending_stiffness = '1 N m^2'\nstrength = '3 MPa'"),
            ":3: [specimen] strength: This needs a section of the specimen"));
  CHECK(has(complaint("[specimen]\ndiameter = '3 um'\nstrength = '3 MPa'\nstrain_at_break = '2 %'"),
            ":3: [specimen] strength: A specimen has either a strength or a strain_at_break, not both"));
  CHECK(has(complaint("[specimen]\ndiameter = '3 um'\nstrain_at_break = '-2 %'"), ":3: [specimen] strain_at_break"));
  CHECK(has(complaint("reduced = true\n[specimen]\ndiameter = 0.02\nstrength = 3"),
            "A reduced case has no strength. Give strain_at_break instead"));
  CHECK(has(complaint("[specimen]\ncracks = [{ loss = '3 %' }]"),
            ":2: [specimen] cracks[1].deflection: This value is missing"));
  CHECK(has(complaint_with(", uncertainty = \"1.5 GPa\"", ""),
            ":3: [specimen] modulus.uncertainty: This value is missing"));
  CHECK(has(complaint("[stage]\nprogram = ['1 um']"), "The program needs at least two stage positions"));

  const Test empty = read("");
  CHECK(std::string(missing(empty, "friction").what()) ==
        "data/case.toml: [friction]: This section is missing. Add model = \"sinusoid\", mu0 = 0.5, amplitude = 0.15 "
        "and wavelength = \"11 um\".");
  CHECK(has(missing(read("reduced = true\n[rig]"), "rig.stiffness").what(),
            "case.toml:2: [rig] stiffness: This value is missing. Add the stiffness of your load train in EI/L^3, "
            "stiffness = …, or \"inf\""));
  for (const std::string_view key : {"rig", "rig.stiffness"}) {
    const std::string asked = missing(empty, key).what();
    CHECK(has(asked, "the stiffness of your load train"));
    CHECK_FALSE(has(asked, "90.65"));  // the number of another rig
  }
}

TEST_CASE("table: what contradicts itself is refused") {
  CHECK(has(complaint_with("\"34.8 um\"", "\"1278 um\""),
            ":2: [specimen] diameter: The specimen is 1.278 mm thick, which is not less than the span of 1.278 mm. "
            "Check the units of both"));
  CHECK(has(complaint("[specimen]\nwidth = '1 um'\nheight = '2 mm'\n[rig]\nspan = '1 mm'"),
            ":3: [specimen] height: The specimen is "));
  CHECK(has(complaint_with("diameter = \"34.8 um\"", "diameter = \"34.8 um\"\nwidth = \"1 um\""),
            "either a diameter or width and height"));
  CHECK(has(complaint_with("diameter = \"34.8 um\"", "bending_stiffness = \"1 N m^2\""),
            ":3: [specimen] modulus: A specimen has either"));
  CHECK(has(complaint("[rig]\nspan = '1 mm'\nstiffness = 'inf'\n[record]\nfile = 'a'\nstage = 's'\ndeflection = 'w'"),
            ":4: [record]: The rig is infinitely stiff"));
  CHECK(has(complaint("[friction]\nmodel = 'sinusoids'\nmu0 = 1\nwaves = [{ amplitude = 0.6, wavelength = '1 um' }, { "
                      "amplitude = 0.6, wavelength = '2 um' }]"),
            "The amplitudes add up to 1.2, more than 1"));
  const std::string run = "[stage]\nfile = 'run.csv'\nstage = 's [um]'\n";
  CHECK(
      has(complaint(run + "program = ['0 um', '1 um']"),
          ":4: [stage] program: The stage has either a program or a file with stage positions, not both. Delete one"));
  CHECK(has(complaint(run + "step = '1 um'"),
            ":4: [stage] step: The stage has either a program or a file with stage positions"));
  CHECK(has(complaint(run + "step = '1 um'"), "the rows of the file are the steps"));
  CHECK(has(complaint(run + "cycles = 3"), ":4: [stage] cycles: The stage has either"));
  CHECK(has(complaint(run + "time = 't [um]'"),
            ":4: [stage] time: The unit 'um' measures a length, but a unit of time is needed"));
  CHECK(has(complaint("[stage]\nfile = 'run.csv'"), "[stage] stage: This value is missing. Add stage = "));
  CHECK(has(complaint("[stage]\nprogram = ['0 um', '1 um']\ntime = 't [s]'"),
            ":3: [stage] time: This describes a file, and no file is stated"));
  CHECK(has(complaint("[friction]\nmodel = ['constant', 'drift']"), "An array is not \"constant\", \"drift\""));
  CHECK(has(complaint("[friction]\nmodel = 'roughness'\nmu0 = 1"),
            "[friction] mu0: This key has no meaning here. Leave it out"));
}

TEST_CASE("table: what is no case file is refused as what it is") {
  CHECK(has(complaint("[rig\nspan = 3"), "data/case.toml:1: The file is no case file (TOML): Error while parsing "));
  CHECK(has(complaint("w_s,F\n1,2\n"),
            "data/case.toml:1: 'w_s,F' is neither a [section] nor key = value in plain letters"));
  CHECK(has(complaint(std::string_view("a\0b", 3)), "The file holds binary data"));
  CHECK(has(complaint("a = 1\na = 2"), "data/case.toml:2: The file is no case file (TOML)"));
  CHECK(complaint("[rig]\n# länge\nlänge = 3") ==
        "data/case.toml:3: 'länge' is neither a [section] nor key = value in plain letters.");
  CHECK(has(complaint("[rig]\nspan = \"1 um\nx = 1"), ":2: A text has no closing quote on its line"));
  CHECK(has(complaint("\na = 0x'\xc2\xb5'"), ":2: '0x'µ'' is not a number, true, false or text in quotes"));
  CHECK(has(complaint("[stage]\nprogram = [ # none\n}"), ":3: A value is missing before }"));
  CHECK(has(complaint("[rig]\nspan = 1262-05-07"), ":2: '1262-05-07' is not a number, true, false or text in quotes"));
  CHECK(has(complaint("[rig]\nspan = 1278 um"), ":2: 'um' is not a number, true, false or text in quotes"));
  CHECK(has(complaint("a = \"1\"'2'"), "A quote is in the middle of a text"));
  CHECK(has(complaint("\n[\nrig]"), ":2: The name of a section is missing after ["));
  CHECK(has(complaint("[rig]\nspan = \"\"\"1 \\\n µm\"\"\""), ":2: A text in quotes must stand on one line"));
  CHECK(read("\xEF\xBB\xBF[rig]\nspan = '3 µm' # µ").rig->span == 3e-6);
  CHECK(has(complaint("[rig]\nspan = '1 \xb5m'"), "The file is no case file (TOML)"));  // Latin-1
}

TEST_CASE("outside: files, folders and files that are not there") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "flexslip_case_file_test";
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "case.toml").string();
  std::ofstream(path) << full;
  CHECK(read_case(path).record->file == (folder / "ss14.csv").string());
  CHECK_THROWS_WITH_AS(read_case(folder.string()), (folder.string() + ": This is a directory, not a file.").c_str(),
                       InputError);
  CHECK_THROWS_AS(read_case(path + "x"), InputError);
  std::ofstream(path) << std::string(2 << 20, '#');
  CHECK_THROWS_WITH_AS(read_case(path),
                       (path + ": The file has more than 1 MiB, too much for a case file (TOML).").c_str(), InputError);
  std::filesystem::remove_all(folder);
}

TEST_CASE("identity: a value found wrong later is pointed at where it stands, or where it would") {
  const Test input = read(full);
  CHECK(std::string(wrong_value(input, "rig.span", "a is b", "c").what()) ==
        "data/case.toml:5: [rig] span: A is b. C.");
  CHECK(std::string(wrong_value(input, "specimen.width", "a is b").what()) ==
        "data/case.toml:1: [specimen] width: A is b.");
  CHECK(std::string(wrong_value(input, "friction.waves[2].phase", "a is b").what()) ==
        "data/case.toml:7: [friction] waves[2].phase: A is b.");
}

TEST_CASE("identity: the effective case is read back as the same case") {
  for (const std::string_view text :
       {full,
        std::string_view(""),
        std::string_view("reduced = true"),
        std::string_view("[specimen]\nwidth = '2 um'\nheight = '0.123456789 um'\nbending_stiffness = { value = '2 N "
                         "m^2', uncertainty = '5 %' }\n"
                         "[rig]\nspan = '1 in'\nstiffness = 'inf'\n[friction]\nmodel = 'roughness'\n"
                         "[stage]\nprogram = ['0 um', '1 um']"),
        std::string_view("[friction]\nmodel = 'table'\nfile = \"a \\\"b\\\" \\u0001.csv\"\nlength = 'S [um]'"),
        std::string_view("[friction]\nmodel = 'surface'\nmu0 = 0.5\ntrace = 'a.csv'"),
        std::string_view(
            "[friction]\nmodel = 'surface'\nmu0 = 0.5\ntrace = 'a.csv'\nheight = 'z [nm]'\ntrace_step = '0.1 "
            "um'\ntrace_begin = '0.6 mm'\ndirection = 'inwards'\nlevel = 2\ncutoff = '1 um'\nedge_radius = "
            "'0 um'"),
        std::string_view("[friction]\nmodel = 'rough'\nmu0 = 0.5\nrms = 0.1\ncorrelation_length = '5 um'\nseed = 7"),
        std::string_view("reduced = true\n[rig]\nstiffness = inf\n[friction]\nmodel = 'sinusoids'\nmu0 = 0.1\ndrift = "
                         "-0.3\nwaves = [{ amplitude = 1e-9, wavelength = 3 }]"),
        std::string_view("reduced = true\n[friction]\nmodel = 'sinusoids'\nmu0 = 0.1\nwaves = [{ amplitude = 0, "
                         "wavelength = 3 }]"),  // a required zero is written
        std::string_view("[friction]\nmodel = 'drift'\nmu0 = 0.1\ndrift = '-0.3 1/mm'\nreference = '1.3 mm'"),
        std::string_view("reduced = true\n[friction]\nmodel = 'sinusoid'\nmu0 = 0.1\namplitude = 0.2\nwavelength = "
                         "0.1\ndrift = 0\nreference = 1.123456789"),
        std::string_view("[friction]\nmodel = 'constant'\nmu0 = 0.1\ndrift = '-0.3 "
                         "1/mm'\n[record]\nfile='x'\ndeflection='a'\nforce='b'\ndecimal=','\ncontact='1 mm'"),
        std::string_view("[specimen]\ndiameter = '4 mm'\nwall = '0.3 mm'\n[rig]\nspan = '80 mm'\n[record]\nfile='x'\n"
                         "displacement='crosshead'\ndisplacement_column='1'\nforce=\"a \\\"b\\\"\"\nspecimen=3\n"
                         "calibration='222 N/V'\ndecimal='.'\nsign='reverse'\nzero='-0.12 N'\ncontact='first row'\n"
                         "failure='none'\nuntil=7"),
        std::string_view("[specimen]\nbending_stiffness = 'fit'\nmaterial = \"gl\\\"ass\"\n[rig]\nspan = '1 "
                         "mm'\nsupport_material = 'steel'\n"
                         "[record]\nfile='x'\nfirst='12 um'\nuntil={ deflection = '0.3 mm' }"),
        std::string_view("[record]\nfile='x'\nstage='s'\nforce='F'\nlength='dS [mm]'"),
        std::string_view("[specimen]\ndiameter = '30 um'\ncracks = [{ deflection = '0.16 mm', loss = '3 %' }, "
                         "{ deflection = '200 um', loss = 0.05 }]"),
        std::string_view("[specimen]\ndiameter = '30 um'\nstrain_at_break = '2 %'"),
        std::string_view("[specimen]\nwidth = '30 um'\nheight = '3 um'\nstrength = '600 MPa'"),
        std::string_view("reduced = true\n[specimen]\ncracks = [{ deflection = 0.12, loss = '3 %' }]"),
        std::string_view("[record]\nfile='x'\nsign='keep'\nzero='keep'\ncontact='find'")}) {
    const Test input = read_case(text, "case.toml");
    const std::string written = to_toml(input);
    CAPTURE(written);
    check_same(read_case(written, "case.toml"), input);
    CHECK(to_toml(read_case(written, "case.toml")) == written);
  }
  CHECK(rc::check("any lengths", [] {
    const double mantissa = std::abs(*rc::gen::arbitrary<double>()) + 1e-3;
    const double span = std::ldexp(mantissa, *rc::gen::inRange(-60, 60));
    RC_PRE(std::isfinite(span) && span > 0);
    Test input = read_case("", "case.toml");
    input.rig = RigInput{.span = span, .stiffness = span / 3};
    RC_ASSERT(read_case(to_toml(input), "case.toml").rig == input.rig);
  }));
}

TEST_CASE("table: the text of the effective case") {
  CHECK(to_toml(read_case(full, "case.toml")) == R"([specimen]
diameter = "34.8 um"
modulus = { value = "29.6 GPa", uncertainty = "1.5 GPa" }

[rig]
span = "1.278 mm"
stiffness = "90.65 N/m"

[friction]
model = "sinusoid"
mu0 = 0.5
amplitude = 0.15
wavelength = "10.9 um"
phase = 1

[stage]
program = ["0 m", "900 um", "0 m", "900 um"]
step = "2 um"

[record]
file = "ss14.csv"
stage = "w_s_m [m]"
force = "F_N [N]"
until = 267
)");
}
