#include "report/draw.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
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
#include "report/plot_script.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

std::string csv(const PlotTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.titles, ","));
  for (const auto& row : table.rows) text += fmt::format("{:.8g}\n", fmt::join(row, ","));
  return text;
}

void replace_first(std::string& text, std::string_view what, std::string_view by) {
  if (const auto at = text.find(what); at != std::string::npos) text.replace(at, what.size(), by);
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

// Says what the picture shows, and takes fonts that exist everywhere.
std::string finished_svg(std::string text, const Plot& plot) {
  replace_first(text, "<title>Gnuplot</title>", fmt::format("<title>{}</title>", html_escaped(plot.title)));
  const auto from = text.find("<desc>");
  const auto to = text.find("</desc>");
  if (from != std::string::npos && to != std::string::npos)
    text.replace(from, to - from, "<desc>" + html_escaped(plot.caption));
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

// How finely it is drawn stands in a chunk of its own, after the first one; cairo leaves it out.
std::string finished_png(std::string text) {
  constexpr std::size_t end_of_first = 8 + 25;  // the signature, and a header of 13 bytes with its length, name and sum
  const auto per_metre = static_cast<std::uint32_t>(std::lround(png_resolution / 0.0254));
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

DrawStatus draw(const Plot& plot, const std::string& folder, const std::vector<std::string>& formats) {
  const fs::path base = folder.empty() ? fs::path(".") : fs::path(folder);
  const std::string script = plot.name + ".gp";
  for (const auto& table : plot.data)
    write_text((base / fmt::format("{}-{}.csv", plot.name, table.name)).string(), csv(table));
  write_text((base / script).string(), script_of(plot));
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
    const std::string picture = fmt::format("{}.{}", plot.name, format);
    const auto drawn = read_text((drawing.path() / picture).string());
    if (!drawn) throw std::runtime_error(fmt::format("gnuplot has not drawn {}", (base / picture).string()));
    write_text((base / picture).string(), format == "svg"   ? finished_svg(*drawn, plot)
                                          : format == "pdf" ? finished_pdf(*drawn)
                                                            : finished_png(*drawn));
  }
  return DrawStatus::drawn;
}

DrawStatus draw(Plot plot, const std::string& picture) {
  const fs::path path(picture);
  const std::string format = path.extension().empty() ? "" : path.extension().string().substr(1);
  if (format != "svg" && format != "pdf" && format != "png")
    throw InputError({.file = picture,
                      .expected = "a picture whose name ends in .svg, .pdf or .png",
                      .found = in_quotes(path.extension().string())});
  plot.name = path.stem().string();
  if (std::any_of(plot.name.begin(), plot.name.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }))
    throw InputError(
        {.file = picture, .expected = "a file name without control characters", .found = in_quotes(plot.name)});
  return draw(plot, path.parent_path().string(), {format});
}

}  // namespace flexslip
