#include "report/figure.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "io/child_process.h"
#include "io/input_error.h"
#include "io/text.h"
#include "io/text_file.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

constexpr double font_size = 8;         // [pt] journals want at least 7 in print
constexpr double png_resolution = 400;  // [1/in]

// Colours that all can tell apart (Okabe and Ito), and the looks that every figure shares.
constexpr std::string_view gnuplot_style = R"(
blue = '#0072B2'; sky = '#56B4E9'; green = '#009E73'; orange = '#E69F00'; vermillion = '#D55E00'; brown = '#8C510A'; grey = '#8C8C8C'
set encoding utf8
set datafile separator comma
set datafile columnheaders
set border linewidth 0.75
set tics in scale 0.6, 0.35
set mxtics 2; set mytics 2
set minussign
set key samplen 2.2 spacing 1.15 noautotitle
)";

std::string csv(const FigureData& data) {
  std::string text = fmt::format("{}\n", fmt::join(data.titles, ","));
  for (const auto& row : data.rows) text += fmt::format("{:.8g}\n", fmt::join(row, ","));
  return text;
}

// Pixels, centimetres and the fonts of the terminals are made to agree, so that all three pictures look alike.
std::string terminals(const Figure& figure) {
  constexpr double mm_per_inch = 25.4;
  constexpr double css_resolution = 96;
  const auto pixels = [](double mm, double resolution) { return std::lround(mm / mm_per_inch * resolution); };
  const double scale = png_resolution / css_resolution;
  return fmt::format(
      "  if (format eq 'svg') {{ set terminal svg size {},{} font 'Arial,{:.2f}' linewidth 1.25 enhanced background "
      "'white' }}\n"
      "  if (format eq 'pdf') {{ set terminal pdfcairo size {:.2f}cm,{:.2f}cm font 'Arial,{:g}' fontscale 0.75 "
      "linewidth 1.9 "
      "enhanced }}\n"
      "  if (format eq 'png') {{ set terminal pngcairo size {},{} font 'Arial,{:g}' fontscale {:.3f} linewidth {:.2f} "
      "pointscale {:.2f} enhanced background 'white' }}\n",
      pixels(figure.width, css_resolution), pixels(figure.height, css_resolution), font_size * css_resolution / 72,
      figure.width / 10, figure.height / 10, font_size, pixels(figure.width, png_resolution),
      pixels(figure.height, png_resolution), font_size, 0.75 * scale, 1.25 * scale, scale);
}

std::string script_of(const Figure& figure) {
  std::string files;
  for (const auto& data : figure.data)
    files += fmt::format("{} = {}\n", data.name, in_script(fmt::format("{}-{}.csv", figure.name, data.name)));
  return fmt::format(
      "# gnuplot THIS_FILE draws the figure from the data beside it, as SVG, PDF and PNG; one of them only:\n"
      "# gnuplot -e \"formats='pdf'\" THIS_FILE\n"
      "if (!exists('formats')) formats = 'svg pdf png'\n"
      "if (!exists('folder')) folder = ''\n"
      "{}{}\ndo for [format in formats] {{\n{}  set output folder.{}.'.'.format\n{}  unset output\n}}\n",
      files, gnuplot_style, terminals(figure), in_script(figure.name), figure.script);
}

void replace_first(std::string& text, std::string_view what, std::string_view by) {
  if (const auto at = text.find(what); at != std::string::npos) text.replace(at, what.size(), by);
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

// Says what the picture shows, and takes fonts that exist everywhere.
std::string finished_svg(std::string text, const Figure& figure) {
  replace_first(text, "<title>Gnuplot</title>", fmt::format("<title>{}</title>", html_escaped(figure.title)));
  const auto from = text.find("<desc>");
  const auto to = text.find("</desc>");
  if (from != std::string::npos && to != std::string::npos)
    text.replace(from, to - from, "<desc>" + html_escaped(figure.description));
  replace_all(text, "<text>", "<text xml:space=\"preserve\">");
  replace_all(text, "font-family=\"Arial\"", "font-family=\"Arial, Helvetica, sans-serif\"");
  return text;
}

// The date of the drawing would make every PDF another.
std::string finished_pdf(std::string text) {
  const std::string key = "/CreationDate (D:";
  const auto at = text.find(key);
  if (at == std::string::npos) return text;
  const char* asked = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t seconds = asked ? std::strtoll(asked, nullptr, 10) : 0;
  std::tm date{};
  gmtime_r(&seconds, &date);
  const std::string day = fmt::format("{:04}{:02}{:02}{:02}{:02}{:02}", date.tm_year + 1900, date.tm_mon + 1,
                                      date.tm_mday, date.tm_hour, date.tm_min, date.tm_sec);
  if (day.size() == 14) text.replace(at + key.size(), day.size(), day);  // no other length: the file holds offsets
  return text;
}

// Where gnuplot draws: it would cut short or spoil a picture that is there.
class DrawingFolder {
 public:
  DrawingFolder() {
    std::string name = fs::absolute(fs::temp_directory_path() / "flexslip-XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw InputError({.file = fs::temp_directory_path().string(),
                        .expected = "a folder that can be written to",
                        .found = std::generic_category().message(errno)});
    path_ = name;
  }
  ~DrawingFolder() {
    std::error_code gone;
    fs::remove_all(path_, gone);
  }
  DrawingFolder(const DrawingFolder&) = delete;
  DrawingFolder& operator=(const DrawingFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

double tick_within(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  return (value >= 5 * decade ? 5 : value >= 2 * decade ? 2 : 1) * decade;
}

double rounded_up(double value) {
  const double step = std::pow(10, std::floor(std::log10(value))) / 2;
  return step * std::ceil(value / step);
}

std::string logarithmic_tics(double a, double b) {
  const auto [low, high] = std::minmax(a, b);
  std::string tics;
  for (int decade = static_cast<int>(std::floor(std::log10(low))); decade <= std::log10(high); ++decade)
    for (const double digit : {1, 2, 3, 4, 6, 8})
      if (const double tic = digit * std::pow(10, decade); tic >= low && tic <= high)
        tics += fmt::format("{}{:g}", tics.empty() ? "" : ",", tic);
  return tics;
}

std::vector<std::vector<double>> thinned(const std::vector<std::vector<double>>& rows, double width, double height) {
  constexpr double finest = 0.003;  // of the figure: half a millimetre
  std::vector<std::vector<double>> kept;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == rows.size() || rows[i].empty() || rows[i - 1].empty() || rows[i + 1].empty();
    if (is_end || std::hypot((rows[i][0] - kept.back()[0]) / width, (rows[i][1] - kept.back()[1]) / height) > finest)
      kept.push_back(rows[i]);
  }
  return kept;
}

std::string in_script(std::string_view text) {
  if (text.find('\'') == std::string_view::npos) return fmt::format("'{}'", text);
  // A doubled ' is misread between braces (gnuplot 5.4). Between " all that means something goes by its number.
  std::string out = "\"";
  for (const char c : text)
    out +=
        std::string_view("'\"\\`").find(c) == std::string_view::npos ? std::string(1, c) : fmt::format("\\{:03o}", c);
  return out + '"';
}

PlotUnit plot_unit(double magnitude, const Kind& kind, bool reduced, std::string_view reduced_unit) {
  if (reduced) return {std::string(reduced_unit), 1};
  const std::string_view unit = best_unit(magnitude, kind);
  return {typeset(unit), from_si(1, parse_unit(unit))};
}

std::string axis_label(std::string_view words, std::string_view symbol, const PlotUnit& unit) {
  // SVG drops plain spaces beside a change of font.
  return fmt::format("{}\u00a0{}{}", words, symbol, unit.unit.empty() ? "" : fmt::format("\u00a0({})", unit.unit));
}

std::string drawn_in_label(const PlotUnit& unit) {
  return fmt::format("Length drawn in over one support\u00a0({})", unit.unit);
}

DrawStatus draw(const Figure& figure, const std::string& folder, const std::vector<std::string>& formats) {
  const fs::path base = folder.empty() ? fs::path(".") : fs::path(folder);
  const std::string script = figure.name + ".gp";
  for (const auto& data : figure.data)
    write_text((base / fmt::format("{}-{}.csv", figure.name, data.name)).string(), csv(data));
  write_text((base / script).string(), script_of(figure));
  const DrawingFolder drawing;
  const auto result = run_child(
      {"gnuplot", "-e",
       fmt::format("formats='{}'; folder={}", fmt::join(formats, " "), in_script((drawing.path() / "").string())),
       "./" + script},
      base.string());
  if (result.status == ChildStatus::not_found) return DrawStatus::no_gnuplot;
  if (result.exit_code != 0)
    throw std::runtime_error(fmt::format("gnuplot could not draw {}: {}", (base / script).string(), result.output));
  for (const auto& format : formats) {
    const std::string picture = fmt::format("{}.{}", figure.name, format);
    const auto drawn = read_text((drawing.path() / picture).string());
    if (!drawn) throw std::runtime_error(fmt::format("gnuplot has not drawn {}", (base / picture).string()));
    write_text((base / picture).string(), format == "svg"   ? finished_svg(*drawn, figure)
                                          : format == "pdf" ? finished_pdf(*drawn)
                                                            : *drawn);
  }
  return DrawStatus::drawn;
}

DrawStatus draw(Figure figure, const std::string& picture) {
  const fs::path path(picture);
  const std::string format = path.extension().empty() ? "" : path.extension().string().substr(1);
  if (format != "svg" && format != "pdf" && format != "png")
    throw InputError({.file = picture,
                      .expected = "a picture whose name ends in .svg, .pdf or .png",
                      .found = in_quotes(path.extension().string())});
  figure.name = path.stem().string();
  if (std::any_of(figure.name.begin(), figure.name.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }))
    throw InputError(
        {.file = picture, .expected = "a file name without control characters", .found = in_quotes(figure.name)});
  return draw(figure, path.parent_path().string(), {format});
}

}  // namespace flexslip
