#include "report/draw.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "data/names.h"
#include "io/durable_file.h"
#include "io/input_error.h"
#include "io/text.h"
#include "io/text_file.h"
#include "platform/child_process.h"
#include "platform/files.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

// [1/in], [1/in], [mm]
constexpr double png_resolution = 400, css_resolution = 96, mm_per_inch = 25.4;

// Text as a quoted word of a script.
std::string in_script(std::string_view text) {
  if (text.find('\'') == std::string_view::npos) return fmt::format("'{}'", text);
  // gnuplot 5.4 misreads a doubled ' between braces. Between double quotes, special characters are
  // written as numbers.
  std::string out = "\"";
  for (const char c : text)
    out +=
        std::string_view("'\"\\`").find(c) == std::string_view::npos ? std::string(1, c) : fmt::format("\\{:03o}", c);
  return out + '"';
}

// Markup as gnuplot's enhanced text, in quotes.
std::string quoted(const std::string& markup) {
  const std::vector<TextPiece> pieces = text_pieces(markup);
  std::string out;
  for (const TextPiece& piece : pieces) {
    const std::string_view text = piece.text;
    out += std::array{"", "{/:Italic ", "_{", "^{"}[piece.style];
    for (std::size_t i = 0; i < text.size(); ++i) {
      // SVG omits plain spaces next to a change of font.
      const bool is_at_font_change =
          (i == 0 && &piece != &pieces.front()) || (i + 1 == text.size() && &piece != &pieces.back());
      if (std::string_view("\\{}^_@&~").find(text[i]) != std::string_view::npos) out += '\\';
      out += text[i] == ' ' && is_at_font_change ? std::string("\u00a0") : std::string(1, text[i]);
    }
    if (piece.style != TextPiece::plain) out += '}';
  }
  return in_script(out);
}

// Makes pixels, centimetres and fonts of the terminals agree, so that all pictures look alike. `up`
// corrects the position of numbers below an axis in SVG.
std::string terminals(const Plot& plot) {
  constexpr double scale = png_resolution / css_resolution;
  const auto pixels = [](double mm, double resolution) { return std::lround(mm / mm_per_inch * resolution); };
  return fmt::format(
      "  up = 0\n"
      "  if (format eq 'svg') {{ up = 0.2; set terminal svg size {},{} font 'Arial,{:.2f}' linewidth 1.25 enhanced "
      "background 'white' }}\n"
      "  if (format eq 'pdf') {{ set terminal pdfcairo size {:.2f}cm,{:.2f}cm font 'Arial,{:g}' fontscale 0.75 "
      "linewidth 1.9 dashlength 1.6 enhanced }}\n"
      "  if (format eq 'png') {{ set terminal pngcairo size {},{} font 'Arial,{:g}' fontscale {:.3f} linewidth {:.2f} "
      "pointscale {:.2f} dashlength 1.6 enhanced background 'white' }}\n",
      pixels(plot.width, css_resolution), pixels(plot.height, css_resolution), font_size * css_resolution / 72,
      plot.width / 10, plot.height / 10, font_size, pixels(plot.width, png_resolution),
      pixels(plot.height, png_resolution), font_size, scale, 1.25 * scale, scale);
}

std::string line_look(const Style& style) {
  return fmt::format("lw {:g} dt {} lc rgb '{}'", style.width,
                     name_in_order<Dash::dotted>(style.dash, {"solid", "(6,4)", "(14,7)", "(2,3)"}), style.colour);
}

// Several looks are drawn on top of each other.
std::vector<std::string> point_looks(const Style& style) {
  constexpr double size_of_gnuplot = 6;  // [pt] at pointsize 1
  const auto look = [&](Symbol symbol, Colour colour) {
    return fmt::format("pt {} ps {:.3g} lw {:g} lc rgb '{}'",
                       name_in_order<Symbol::cross>(symbol, {"7", "7", "6", "5", "9", "11", "3", "2"}),
                       style.size / size_of_gnuplot, style.width, colour);
  };
  if (style.symbol != Symbol::circle) return {look(style.symbol, style.colour)};
  return {look(Symbol::disc, colours::white), look(Symbol::circle, style.colour)};
}

std::string fill_look(const Style& style) {
  return fmt::format("rgb '{}' fs {} noborder", style.colour,
                     style.opacity < 1 ? fmt::format("transparent solid {:g}", style.opacity) : "solid");
}

// A selection of consecutive rows in gnuplot's syntax; "" if the rows are not consecutive. Empty
// rows divide a table into blocks; a selection across blocks must contain whole blocks.
std::string row_selection(const PlotTable& table, const std::vector<Condition>& only) {
  struct Place {
    std::size_t block, row;
  };
  std::vector<Place> meant;
  std::vector<std::size_t> rows_of_block{0};
  bool are_single = true;
  for (const auto& row : table.rows) {
    if (row.empty()) {
      are_single = are_single && rows_of_block.back() > 0;  // several empty rows count as one
      rows_of_block.push_back(0);
      continue;
    }
    if (std::all_of(only.begin(), only.end(), [&](const Condition& each) { return row[each.column] == each.value; }))
      meant.push_back({rows_of_block.size() - 1, rows_of_block.back()});
    ++rows_of_block.back();
  }
  if (meant.empty() || !are_single) return "";
  const Place from = meant.front(), to = meant.back();
  if (from.block == to.block && to.row - from.row + 1 == meant.size())
    return fmt::format(" every ::{}:{}:{}:{}", from.row, from.block, to.row, to.block);
  std::size_t rows = 0;
  for (std::size_t block = from.block; block <= to.block; ++block) rows += rows_of_block[block];
  return rows == meant.size() ? fmt::format(" every :::{}::{}", from.block, to.block) : "";
}

// The arguments of `plot`. Columns are named instead of computed where possible, because gnuplot
// sets a signal handler for every number that it computes.
std::string plotted(const Mark& mark, const Plot& plot) {
  const Style& style = mark.style;
  const bool is_own = mark.table.empty();
  std::vector<std::string> c;
  for (const std::size_t column : mark.columns) c.push_back(fmt::format("${}", column + 1));
  for (const double number : mark.at) c.push_back(fmt::format("{:.8g}", number));
  std::string from = is_own ? "$one" : mark.table;
  if (!mark.only.empty()) {
    const auto table = std::find_if(plot.data.begin(), plot.data.end(),
                                    [&](const PlotTable& each) { return each.name == mark.table; });
    const std::string rows = row_selection(*table, mark.only);
    std::string chosen;
    for (const Condition& condition : mark.only)
      chosen += fmt::format("{}${} == {:g}", chosen.empty() ? "" : " && ", condition.column + 1, condition.value);
    if (rows.empty()) c[0] = fmt::format("{} ? {} : NaN", chosen, c[0]);
    from += rows;
  }
  std::string out;
  const auto add = [&](const std::vector<std::string>& columns, const std::string& with) {
    std::vector<std::string> used;
    for (const std::string& column : columns) {
      const bool is_named = column.front() == '$' && column.find_first_not_of("0123456789", 1) == std::string::npos;
      used.push_back(is_named ? column.substr(1) : "(" + column + ")");
    }
    out += fmt::format("{}{} using {} with {} notitle", out.empty() ? "" : ", \\\n       ", from, fmt::join(used, ":"),
                       with);
  };
  const auto vector = [&](std::string_view heads, const std::string& x, const std::string& y, const std::string& to_x,
                          const std::string& to_y) {
    add({x, y, fmt::format("({})-({})", to_x, x), fmt::format("({})-({})", to_y, y)},
        fmt::format("vectors {} {}", heads, line_look(style)));
  };
  // low x, high x, low y, high y
  const auto box = [&](const std::vector<std::string>& ends, const std::string& with) {
    add({fmt::format("({}+{})/2", ends[0], ends[1]), fmt::format("({}+{})/2", ends[2], ends[3]), ends[0], ends[1],
         ends[2], ends[3]},
        "boxxyerror " + with);
  };
  switch (mark.kind) {
    case Mark::line:
      if (is_own)
        vector("nohead", c[0], c[1], c[2], c[3]);
      else
        add(c, "lines " + line_look(style));
      if (style.symbol == Symbol::none) break;
      [[fallthrough]];
    case Mark::points:
      for (const std::string& look : point_looks(style)) add(c, "points " + look);
      break;
    case Mark::band:
      add(c, "filledcurves lc " + fill_look(style));
      break;
    case Mark::area:
      if (is_own)
        box({c[0], c[2], c[1], c[3]}, "lc " + fill_look(style));
      else
        add(c, "filledcurves closed lc " + fill_look(style));
      break;
    case Mark::bars:
      vector("nohead", c[0], c[1], c[0], c[2]);
      break;
    case Mark::spans:
      vector("nohead", c[0], c[2], c[1], c[2]);
      break;
    case Mark::arrows:
      vector("head filled size screen 0.013,20", c[0], c[1], c[2], c[3]);
      break;
    case Mark::pixels:
      add({fmt::format("({}+{})/2", c[0], c[1]), fmt::format("({}+{})/2", c[2], c[3]), c[0], c[1], c[2], c[3], c[4]},
          "boxxyerror fs solid border lw 0.5 lc palette");
      break;
    case Mark::label:
      break;
  }
  return out;
}

// "" without words.
std::string set_label(const Text& text, const Plot& plot) {
  if (text.words.empty()) return "";
  return fmt::format("  set label {} at screen {:.5f},{:.5f} {}{} front{}\n", quoted(text.words), text.x / plot.width,
                     text.y / plot.height, name_in_order<Text::right>(text.anchor, {"left", "center", "right"}),
                     text.upright ? " rotate by 90" : "", text.boxed ? " boxed" : "");
}

// gnuplot treats the text of a tick as a format.
std::string tick_words(std::string_view words) {
  std::string out;
  for (const char character : words) out += character == '%' ? "%%" : std::string(1, character);
  return out;
}

std::string set_axis(std::string_view name, const Axis& axis, const Plot& plot) {
  std::string ticks;
  for (const Tick& tick : axis.ticks)
    ticks += fmt::format("{}{} {:.10g}{}", ticks.empty() ? "" : ", ",
                         quoted(axis.has_numbers ? tick_words(tick.text) : ""), tick.at, tick.text.empty() ? " 1" : "");
  // Rounding would hide a tick at the end of a logarithmic axis.
  const double beyond = axis.logarithmic ? 1 + 1e-7 : 1;
  return fmt::format("  {}set logscale {}; set {}range [{:.10g}:{:.10g}] noextend\n  set {}tics ({}){}\n",
                     axis.logarithmic ? "" : "un", name, name, axis.from / beyond, axis.to * beyond, name, ticks,
                     name != "x"          ? ""
                     : axis.names.empty() ? " norotate offset 0,up"
                                          : " rotate by 90 right") +
         set_label(axis.title, plot);
}

// The samples of a key and their text.
std::string set_key(const Panel& panel, const Plot& plot) {
  std::string out;
  std::size_t entry = 0;
  for (const Mark& mark : panel.marks) {
    if (mark.title.empty()) continue;
    const double left = panel.key_left + panel.key_width * static_cast<double>(entry / panel.key_rows),
                 y = panel.key_top - key_height * (static_cast<double>(entry % panel.key_rows) + 0.5);
    const auto screen = [&](double x, double lift) {
      return fmt::format("screen {:.5f},{:.5f}", (left + x) / plot.width, (y + lift) / plot.height);
    };
    constexpr double sample = 6, words = 7.2, half_a_fill = 0.9;  // [mm]
    if (mark.kind == Mark::area || mark.kind == Mark::band)
      out += fmt::format("  set object rectangle from {} to {} front fc {}\n", screen(0, -half_a_fill),
                         screen(sample, half_a_fill), fill_look(mark.style));
    else if (mark.kind != Mark::points)
      out += fmt::format("  set arrow from {} to {} nohead front {}\n", screen(0, 0), screen(sample, 0),
                         line_look(mark.style));
    if (mark.style.symbol != Symbol::none)
      for (const std::string& look : point_looks(mark.style))
        out += fmt::format("  set label '' at {} point {} front\n", screen(sample / 2, 0), look);
    out += set_label({mark.title, left + words, y, Text::left}, plot);
    ++entry;
  }
  return out;
}

constexpr std::string_view script_begins =
    "# gnuplot THIS_FILE draws the figure from the data next to it, as SVG, PDF and PNG; one of them only:\n";

std::string script_of(const Plot& plot) {
  std::string out(script_begins);
  out +=
      "# gnuplot -e \"formats='pdf'\" THIS_FILE\n"
      "if (!exists('formats')) formats = 'svg pdf png'\n"
      "if (!exists('folder')) folder = ''\n";
  for (const PlotTable& table : plot.data)
    out += fmt::format("{} = {}\n", table.name, in_script(fmt::format("{}-{}.csv", plot.name, table.name)));
  std::string stops;
  for (const auto& [at, colour] : palette) stops += fmt::format("{}{} '{}'", stops.empty() ? "" : ", ", at, colour);
  out += fmt::format(
      "set palette defined ({})\nset encoding utf8\nset datafile separator comma\nset datafile columnheaders\nset "
      "border linewidth 0.75\nset tics front in scale 0.6, 0.35\nset style textbox opaque noborder margins 0.6, "
      "0.6\nunset key\n"
      "$one << EOD\nof numbers in the script\n1\nEOD\ndo for [format in formats] {{\n{}  set output "
      "folder.{}.'.'.format\n  set multiplot\n",
      stops, terminals(plot), in_script(plot.name));
  for (const Text& text : plot.texts) out += set_label(text, plot);
  for (const Panel& panel : plot.panels) {
    out += fmt::format(
        "  # Panel {}\n  set lmargin at screen {:.5f}; set rmargin at screen {:.5f}; set bmargin at screen {:.5f}; set "
        "tmargin at screen {:.5f}\n",
        &panel - plot.panels.data() + 1, panel.left / plot.width, (panel.left + panel.width) / plot.width,
        panel.bottom / plot.height, (panel.bottom + panel.height) / plot.height);
    out += set_axis("x", panel.x, plot) + set_axis("y", panel.y, plot) + set_key(panel, plot);
    for (const Text& text : panel.texts) out += set_label(text, plot);
    std::string marks;
    for (const Mark& mark : panel.marks) {
      if (mark.table.empty() && mark.at.empty()) continue;
      if (mark.kind == Mark::pixels)
        out += set_axis("cb", panel.colour, plot) +
               fmt::format("  set colorbox user origin screen {:.5f},{:.5f} size screen {:.5f},{:.5f}\n",
                           (panel.left + panel.width + colour_bar) / plot.width, panel.bottom / plot.height,
                           colour_bar / plot.width, panel.height / plot.height);
      marks += (marks.empty() ? "" : ", \\\n       ") + plotted(mark, plot);
    }
    out += fmt::format("  plot {}\n  unset label; unset arrow; unset object\n", marks.empty() ? "NaN notitle" : marks);
  }
  return out + "  unset multiplot\n  unset output\n}\n";
}

std::string csv(const PlotTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.titles, ","));
  for (const auto& row : table.rows) text += fmt::format("{:.8g}\n", fmt::join(row, ","));
  return text;
}

// Adds the title of the picture, and replaces fonts by generally available ones.
std::string finished_svg(std::string text, const Plot& plot) {
  text = replaced(text, "<title>Gnuplot</title>", "<title>" + html_escaped(plot.title) + "</title>");
  const auto from = text.find("<desc>");
  const auto to = text.find("</desc>");
  if (from != std::string::npos && to != std::string::npos)
    text.replace(from, to - from, "<desc>" + html_escaped(plot.caption));
  text = replaced(text, "<text>", "<text xml:space=\"preserve\">");
  return replaced(text, "font-family=\"Arial\"", "font-family=\"Arial, Helvetica, sans-serif\"");
}

// Removes the date of the drawing, which differs in every PDF.
std::string finished_pdf(std::string text) {
  const std::string key = "/CreationDate (D:";
  const auto at = text.find(key);
  if (at == std::string::npos) return text;
  const std::tm date = calendar_date(date_of_source(0));
  const std::string day = fmt::format("{:04}{:02}{:02}{:02}{:02}{:02}", date.tm_year + 1900, date.tm_mon + 1,
                                      date.tm_mday, date.tm_hour, date.tm_min, date.tm_sec);
  if (day.size() == 14)
    // the length must stay, because the file contains offsets
    text.replace(at + key.size(), day.size(), day);
  return text;
}

// Adds a chunk with the resolution after the first one; cairo does not write it.
std::string finished_png(std::string text) {
  // the signature, and a header of 13 bytes with its length, name and sum
  constexpr std::size_t end_of_first = 8 + 25;
  const auto per_metre = static_cast<std::uint32_t>(std::lround(png_resolution / mm_per_inch * 1000));
  const auto big_endian = [](std::uint32_t number) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((number >> shift) & 0xff);
    return bytes;
  };
  const std::string chunk = "pHYs" + big_endian(per_metre) + big_endian(per_metre) + '\1';
  std::uint32_t sum = 0xffffffff;  // CRC-32
  for (const char c : chunk) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1) != 0 ? 0xedb88320 : 0);
  }
  if (text.size() > end_of_first) text.insert(end_of_first, big_endian(9) + chunk + big_endian(~sum));
  return text;
}

// The temporary folder in which gnuplot draws, so that a failure leaves existing pictures intact.
class DrawingFolder {
 public:
  // Fails: std::system_error.
  DrawingFolder() {
    const fs::path temporary = fs::absolute(fs::temp_directory_path());
    static std::atomic<unsigned> made;
    do path_ = temporary / fmt::format("flexslip-{}-{}", name_of_process(), made++);
    while (!fs::create_directory(path_));  // otherwise left by a program that was killed
    fs::permissions(path_, fs::perms::owner_all);
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

std::string last_line(std::string_view text) {
  const auto end = text.find_last_not_of(" \r\n\t");
  if (end == std::string_view::npos) return "";
  text = text.substr(0, end + 1);
  return std::string(text.substr(text.find_last_of("\r\n") + 1));
}

}  // namespace

namespace {

std::string data_file(const Plot& plot, const PlotTable& table) {
  return fmt::format("{}-{}.csv", plot.name, table.name);
}

// Refuses to overwrite files that do not belong to a figure of this name, which has a script.
void require_own_files(const Plot& plot, const fs::path& base) {
  const std::string script = plot.name + ".gp";
  const auto found = read_text((base / script).string());
  if (found && found->starts_with(script_begins)) return;
  std::vector<std::string> files{script};
  for (const PlotTable& table : plot.data) files.push_back(data_file(plot, table));
  for (const std::string& file : files)
    if (fs::exists(base / file))
      throw InputError({.file = (base / file).string(),
                        .problem = "The data of the figure go into a file of this name, and there is another",
                        .remedy = "give the figure another name"});
}

}  // namespace

Drawing draw(const Plot& plot, const std::string& folder, const std::vector<std::string>& formats) {
  const fs::path base = folder.empty() ? fs::path(".") : fs::path(folder);
  const std::string script = plot.name + ".gp";
  for (const auto& table : plot.data) write_text((base / data_file(plot, table)).string(), csv(table));
  write_text((base / script).string(), script_of(laid_out(plot)));
  std::vector<std::string> pictures;
  try {
    const DrawingFolder drawing;
    constexpr std::chrono::seconds limit{20};
    // -d and the variable exclude the user's settings.
    const auto result = run_child(
        {"gnuplot", "-d", "-e",
         fmt::format("formats='{}'; folder={}", fmt::join(formats, " "), in_script((drawing.path() / "").string())),
         "./" + script},
        {.folder = base.string(), .limit = limit, .unset_variables = {"GNUTERM"}});
    if (result.status == ChildStatus::not_found) return {"gnuplot is not installed"};
    if (result.status == ChildStatus::too_long)
      return {fmt::format("gnuplot did not finish {} within {} s", script, limit.count())};
    if (result.exit_code != 0)
      return {fmt::format("gnuplot could not draw {} (exit code {}): {}", script, result.exit_code,
                          last_line(result.output))};
    for (const auto& format : formats) {
      const auto drawn = read_text((drawing.path() / fmt::format("{}.{}", plot.name, format)).string());
      if (!drawn || drawn->empty() || (format == "svg" && drawn->find("<svg") == std::string::npos))
        return {fmt::format("gnuplot wrote no {} of {}", format, script)};
      pictures.push_back(format == "svg"   ? finished_svg(*drawn, plot)
                         : format == "pdf" ? finished_pdf(*drawn)
                                           : finished_png(*drawn));
    }
  } catch (const std::runtime_error& error) {
    return {fmt::format("gnuplot could not be run: {}", error.what())};
  }
  for (std::size_t i = 0; i < formats.size(); ++i)
    write_text((base / fmt::format("{}.{}", plot.name, formats[i])).string(), pictures[i]);
  return {};
}

Drawing draw(Plot plot, const std::string& picture) {
  const fs::path path(picture);
  const std::string format = path.extension().empty() ? "" : path.extension().string().substr(1);
  if (format != "svg" && format != "pdf" && format != "png")
    throw InputError({.file = picture,
                      .problem = fmt::format("A picture ends in .svg, .pdf or .png, not in {}",
                                             in_quotes(path.extension().string()))});
  plot.name = path.stem().string();
  if (std::any_of(plot.name.begin(), plot.name.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }))
    throw InputError(
        {.file = picture, .problem = fmt::format("The file name {} holds control characters", in_quotes(plot.name))});
  require_own_files(plot, path.parent_path());
  return draw(plot, path.parent_path().string(), {format});
}

}  // namespace flexslip
