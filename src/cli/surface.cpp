#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "answers/surface_fields.h"
#include "case/surface_study.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "cli/trace_flags.h"
#include "io/input_error.h"
#include "io/quantity.h"
#include "io/text_file.h"
#include "report/surface_figure.h"
#include "report/surface_words.h"

namespace flexslip {
namespace {

struct SurfaceFlags {
  std::string file;
  TraceFlags trace;
  std::string cutoff, edge_radius, friction, pixel, amplitude, shortest, longest, noise;
  std::vector<std::string> wavelengths;
  std::size_t level = 1, tapers = TextureOptions{}.tapers;
  std::string profile, spectrum, figure;
  Output output;
};

SurfaceOptions options_of(const SurfaceFlags& flags) {
  const auto quantity = [](const std::string& text, std::string_view flag, const Kind& kind, Range range) {
    try {
      return parse_quantity(text, kind, range);
    } catch (const InputError& error) {
      throw located(error, "", 0, flag);
    }
  };
  const auto length = [&](const std::string& text, std::string_view flag,
                          Range range = Range::positive) -> std::optional<double> {
    if (text.empty()) return std::nullopt;
    return quantity(text, flag, kind::length, range);
  };
  SurfaceOptions options;
  options.level = flags.level;
  options.cutoff = length(flags.cutoff, "--cutoff");
  options.edge_radius = length(flags.edge_radius, "--edge-radius", Range::non_negative).value_or(0);
  if (!flags.friction.empty()) options.friction = quantity(flags.friction, "--friction", kind::number, Range::positive);
  options.pixel = length(flags.pixel, "--pixel");
  options.amplitude = length(flags.amplitude, "--amplitude");
  for (const std::string& text : flags.wavelengths) options.wavelengths.push_back(*length(text, "--wavelength"));
  options.texture.tapers = flags.tapers;
  options.texture.shortest = length(flags.shortest, "--shortest");
  options.texture.longest = length(flags.longest, "--longest");
  options.texture.noise = length(flags.noise, "--noise", Range::non_negative);
  return options;
}

void run_surface(const SurfaceFlags& flags) {
  const SurfaceOptions options = options_of(flags);
  const SurfaceStudy study = study_surface(read_trace(flags.file, options_of(flags.trace)), options);
  if (!flags.profile.empty()) write_csv(flags.profile, trace_fields(), points_of(study), {});
  if (!flags.spectrum.empty()) write_csv(flags.spectrum, spectrum_fields(), spectrum_points_of(study), {});
  if (!flags.figure.empty()) draw_for(flags.output, surface_figure(study), flags.figure);
  if (flags.output.json)
    write_json(flags.output.path, surface_fields()(study, {}));
  else
    write_text(flags.output.path, surface_text(study));
  if (study.texture.drowned) throw CalculationFailed(fmt::format("{}: {}", study.file.source, surface_in_short(study)));
}

}  // namespace

void add_surface_command(CLI::App& app) {
  const auto flags = std::make_shared<SurfaceFlags>();
  CLI::App* command = app.add_subcommand(
      "surface", "What a height profile says of its surface: slope, waves, what it resolves, the friction it predicts");
  command
      ->add_option("trace", flags->file,
                   "Height profile of a microscope, a profilometer or an edge in an image; - is standard input")
      ->type_name("TRACE")
      ->required();
  const auto length = [&](const char* name, std::string& value, const char* help) {
    command->add_option(name, value, help)->type_name("LENGTH");
  };
  command
      ->add_option("--level", flags->level, "Degree of the polynomial to take off: 0 the mean, 1 the tilt, 2 the bow")
      ->type_name("DEGREE")
      ->check(CLI::Range(0, static_cast<int>(most_degree)).description(""))
      ->capture_default_str();
  length("--cutoff", flags->cutoff, "Take shorter waves out, by the Gaussian filter of ISO 16610-21");
  length("--edge-radius", flags->edge_radius, "Radius of the support's edge that is drawn over the surface");
  command->add_option("--friction", flags->friction, "Predict the friction, from this one of the flat surface")
      ->type_name("NUMBER");
  command
      ->add_option("--wavelength", flags->wavelengths,
                   "Can the trace show waves of this length? May be repeated; without it, of those it shows")
      ->type_name("LENGTH")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  length("--amplitude", flags->amplitude, "Of this height, half of crest to trough?");
  length("--pixel", flags->pixel, "Least difference of heights that is told; without it, what all are multiples of");
  length("--noise", flags->noise, "Standard deviation of a height; without it, found by the floor of the spectrum");
  length("--shortest", flags->shortest, "Shortest wavelength that height and slope are told of");
  length("--longest", flags->longest, "Longest; without it, a quarter of the trace");
  command->add_option("--tapers", flags->tapers, "Tapers of the spectrum: more are smoother and coarser")
      ->type_name("COUNT")
      ->check(CLI::Range(2, 30).description(""))
      ->capture_default_str();
  add_trace_options(*command, flags->trace);
  add_output_file(*command, "--profile", flags->profile,
                  "Write heights, the path of the edge, slopes and friction to this CSV file");
  add_output_file(*command, "--spectrum", flags->spectrum, "Write the power spectral density to this CSV file");
  add_figure_option(*command, flags->figure);
  add_output_options(*command, flags->output);
  command->get_option("--json")->description("Write JSON instead of text");
  command->footer(
      "Reads text exports of Gwyddion, tables of position and height with their units, and heights alone with --step.\n"
      "Height and slope are told of a stated band of wavelengths, each with its 95 % interval, without the noise that\n"
      "the spectrum shows. The exit code is 1 if noise hides the surface at all of them.\n\n"
      "Examples:\n"
      "  flexslip surface examples/surface/trace.csv --wavelength \"10.9 um\" --amplitude \"0.11 um\"\n"
      "  flexslip surface examples/surface/trace.csv --friction 0.58 --edge-radius \"1 um\" --figure surface.svg");
  command->callback([flags] { run_surface(*flags); });
}

}  // namespace flexslip
