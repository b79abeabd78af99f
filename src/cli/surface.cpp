#include <array>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "answers/surface_fields.h"
#include "case/surface_study.h"
#include "cli/case_flags.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "cli/reading_flags.h"
#include "io/text_file.h"
#include "report/figures.h"
#include "report/surface_document.h"

namespace flexslip {
namespace {

constexpr std::array flags_of_traces{
    ReadingFlag{"position", "Column of positions, by name or number", "COLUMN"},
    ReadingFlag{"height", "Column of heights, by name or number", "COLUMN"},
    ReadingFlag{"position-unit", "Unit of positions", "UNIT"}, ReadingFlag{"height-unit", "Unit of heights", "UNIT"},
    ReadingFlag{"step", "Distance between heights, for a file without positions", "LENGTH"}};

struct SurfaceRequest {
  std::string file;
  ReadingWords trace;
  SurfaceChoice choice;
  std::string profile, spectrum, figure;
  Output output;
};

void run_surface(const SurfaceRequest& request) {
  const SurfaceOptions options = options_of(request.choice);
  const SurfaceStudy study = study_surface(read_trace(request.file, trace_options_of(request.trace)), options);
  if (!request.profile.empty()) write_csv(request.profile, trace_fields(), points_of(study), {});
  if (!request.spectrum.empty()) write_csv(request.spectrum, spectrum_fields(), spectrum_points_of(study), {});
  if (!request.figure.empty()) draw_for(request.output, surface_figure(study), request.figure);
  if (request.output.json)
    write_json(request.output.path, surface_fields()(study, {}));
  else
    write_text(request.output.path, in_text(document_of(study)));
  if (study.texture.drowned) throw CalculationFailed(fmt::format("{}: {}", study.file.source, surface_in_short(study)));
}

}  // namespace

void add_surface_command(CLI::App& app) {
  const auto request = std::make_shared<SurfaceRequest>();
  CLI::App* command = app.add_subcommand(
      "surface", "What a height profile says about its surface: slope, waves, resolution, predicted friction");
  command
      ->add_option("trace", request->file,
                   "Height profile from a microscope, a profilometer or an edge in an image; - is standard input")
      ->type_name("TRACE")
      ->required();
  const auto length = [&](const char* name, std::string& value, const char* help) {
    command->add_option(name, value, help)->type_name("LENGTH");
  };
  command
      ->add_option("--level", request->choice.level,
                   "Degree of the polynomial to subtract: 0 removes the mean, 1 the tilt, 2 the bow")
      ->type_name("DEGREE")
      ->check(CLI::Range(0, static_cast<int>(max_degree)).description(""))
      ->capture_default_str();
  length("--cutoff", request->choice.cutoff, "Remove shorter waves with the Gaussian filter of ISO 16610-21");
  length("--edge-radius", request->choice.edge_radius, "Radius of the support's edge that is drawn over the surface");
  command
      ->add_option("--friction", request->choice.friction,
                   "Friction of the flat surface, from which to predict friction along the trace")
      ->type_name("NUMBER");
  command
      ->add_option(
          "--wavelength", request->choice.wavelengths,
          "Tell whether the trace can show waves of this length; may be repeated. Without it, of the waves it shows")
      ->type_name("LENGTH")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  length("--amplitude", request->choice.amplitude, "Tell so for waves of this amplitude, half of crest to trough");
  length("--pixel", request->choice.pixel,
         "Smallest difference between heights; without it, the number of which all heights are multiples");
  length("--noise", request->choice.noise,
         "Standard deviation of the noise of a height; without it, found from the floor of the spectrum");
  length("--shortest", request->choice.shortest, "Shortest wavelength to include in rms height and slope");
  length("--longest", request->choice.longest, "Longest wavelength to include; without it, a quarter of the trace");
  command
      ->add_option("--tapers", request->choice.tapers,
                   "Number of tapers of the spectrum: more make it smoother and coarser")
      ->type_name("COUNT")
      ->check(CLI::Range(static_cast<int>(least_tapers), static_cast<int>(most_tapers)).description(""))
      ->capture_default_str();
  add_reading_flags(*command, request->trace, flags_of_traces, "How the trace is read");
  add_reading_flags(*command, request->trace, flags_of_files, "How the trace is read");
  command->get_option("--step")->excludes("--position");
  add_output_file(*command, "--profile", request->profile,
                  "Write heights, the path of the edge, slopes and friction to this CSV file");
  add_output_file(*command, "--spectrum", request->spectrum, "Write the power spectral density to this CSV file");
  add_figure_option(*command, request->figure);
  add_output_options(*command, request->output);
  command->get_option("--json")->description("Write JSON instead of text");
  command->footer(
      "Reads text exports of Gwyddion, tables of position and height with their units, and heights alone with --step.\n"
      "Height and slope hold for a stated band of wavelengths. Each has a 95 % interval and excludes the noise that "
      "the\n"
      "spectrum shows. The exit code is 1 if noise hides the surface at all wavelengths.\n\n"
      "Examples:\n"
      "  flexslip surface examples/surface/trace.csv --wavelength \"10.9 um\" --amplitude \"0.11 um\"\n"
      "  flexslip surface examples/surface/trace.csv --friction 0.58 --edge-radius \"1 um\" --figure surface.svg");
  command->callback([request] { run_surface(*request); });
}

}  // namespace flexslip
