#include <array>
#include <string>

#include <fmt/format.h>

#include "answers/surface_fields.h"
#include "case/surface_study.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "report/answer_documents.h"
#include "report/figures.h"

namespace flexslip {
namespace {

constexpr std::array flags_of_traces{
    ReadingFlag{"position COLUMN", "Column of positions, by name or number"},
    ReadingFlag{"height COLUMN", "Column of heights, by name or number"},
    ReadingFlag{"position-unit UNIT", "Unit of positions"}, ReadingFlag{"height-unit UNIT", "Unit of heights"},
    ReadingFlag{"step LENGTH", "Distance between heights, for a file without positions"}};

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
  write_words(
      request.output, [&] { return surface_fields()(study, {}); }, [&] { return in_text(document_of(study)); });
  if (!request.figure.empty()) draw_for(request.output, surface_figure(study), request.figure);
  if (study.texture.drowned) throw CalculationFailed(fmt::format("{}: {}", study.file.source, surface_in_short(study)));
}

}  // namespace

void add_surface_command(CLI::App& app) {
  const auto [command, request] = add_command(
      app, "surface", "What a height profile says about its surface: slope, waves, resolution, predicted friction",
      run_surface);
  add_option(command, "trace TRACE", request.file,
             "Height profile from a microscope, a profilometer or an edge in an image; - is standard input")
      ->required();
  add_option(command, "--level DEGREE", request.choice.level,
             "Degree of the polynomial to subtract: 0 removes the mean, 1 the tilt, 2 the bow")
      ->check(count_between(0, max_degree))
      ->capture_default_str();
  add_option(command, "--cutoff LENGTH", request.choice.cutoff,
             "Remove shorter waves with the Gaussian filter of ISO 16610-21");
  add_option(command, "--edge-radius LENGTH", request.choice.edge_radius,
             "Radius of the support's edge that is drawn over the surface");
  add_option(command, "--friction NUMBER", request.choice.friction,
             "Friction of the flat surface, from which to predict friction along the trace");
  add_repeated(
      command, "--wavelength LENGTH", request.choice.wavelengths,
      "Tell whether the trace can show waves of this length; may be repeated. Without it, of the waves it shows");
  add_option(command, "--amplitude LENGTH", request.choice.amplitude,
             "Tell so for waves of this amplitude, half of crest to trough");
  add_option(command, "--pixel LENGTH", request.choice.pixel,
             "Smallest difference between heights; without it, the number of which all heights are multiples");
  add_option(command, "--noise LENGTH", request.choice.noise,
             "Standard deviation of the noise of a height; without it, found from the floor of the spectrum");
  add_option(command, "--shortest LENGTH", request.choice.shortest,
             "Shortest wavelength to include in rms height and slope");
  add_option(command, "--longest LENGTH", request.choice.longest,
             "Longest wavelength to include; without it, a quarter of the trace");
  add_option(command, "--tapers COUNT", request.choice.tapers,
             "Number of tapers of the spectrum: more make it smoother and coarser")
      ->check(count_between(min_tapers, max_tapers))
      ->capture_default_str();
  add_reading_flags(command, request.trace, flags_of_traces, "How the trace is read");
  add_reading_flags(command, request.trace, flags_of_files, "How the trace is read");
  command.get_option("--step")->excludes("--position");
  add_output_file(command, "--profile", request.profile,
                  "Write heights, the path of the edge, slopes and friction to this CSV file");
  add_output_file(command, "--spectrum", request.spectrum, "Write the power spectral density to this CSV file");
  add_figure_option(command, request.figure);
  add_output_options(command, request.output);
  command.footer(
      "Reads text exports of Gwyddion, tables of position and height with their units, and heights alone with --step.\n"
      "Height and slope hold for a stated band of wavelengths. Each has a 95 % interval and excludes the noise that "
      "the\n"
      "spectrum shows. The exit code is 1 if noise hides the surface at all wavelengths.\n\n"
      "Examples:\n"
      "  flexslip surface examples/surface/trace.csv --wavelength \"10.9 um\" --amplitude \"0.11 um\"\n"
      "  flexslip surface examples/surface/trace.csv --friction 0.58 --edge-radius \"1 um\" --figure surface.svg");
}

}  // namespace flexslip
