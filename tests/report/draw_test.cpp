#include "report/draw.h"

#include <filesystem>
#include <iterator>
#include <string>

#include <doctest/doctest.h>

#include "io/input_error.h"
#include "io/text.h"
#include "io/text_file.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

using namespace flexslip;
namespace fs = std::filesystem;

namespace {

Plot line() {
  return {.name = "line",
          .title = "A <line> & more",
          .caption = "It rises.",
          .width = one_column,
          .height = 50,
          .data = {{"points", {"x", "y"}, {{0, 1}, {}, {0.1, 2}}}},
          .panels = {{.x = {"*x*"}, .y = {"*y*"}, .marks = {{Mark::line, "points", {0, 1}}}}}};
}

}  // namespace

TEST_CASE("outside: gnuplot draws all formats, and the same figure gives the same bytes") {
  const TemporaryFolder first;
  const TemporaryFolder second;
  if (!draw(line(), first.path(), {"svg", "pdf", "png"}).is_done()) return;
  CHECK(draw(line(), second.path(), {"svg", "pdf", "png"}).is_done());
  for (const std::string file : {"line.svg", "line.pdf", "line.png", "line.gp", "line-points.csv"}) {
    INFO(file);
    CHECK(!bytes_of(first.path() / file).empty());
    CHECK(bytes_of(first.path() / file) == bytes_of(second.path() / file));
  }
  CHECK(bytes_of(first.path() / "line-points.csv") == "x,y\n0,1\n\n0.1,2\n");
  const auto svg = bytes_of(first.path() / "line.svg");
  CHECK(svg.find("<title>A &lt;line&gt; &amp; more</title>") != std::string::npos);
  CHECK(svg.find("<desc>It rises.</desc>") != std::string::npos);
}

TEST_CASE("outside: a name full of quotes and commands is only a name") {
  const TemporaryFolder folder;
  const std::string name = "it's `id` \"$(id)\".svg";
  if (!draw(line(), folder.path() / name).is_done()) return;
  CHECK(fs::exists(folder.path() / name));
}

TEST_CASE("outside: a figure overwrites only its own files (contract)") {
  const TemporaryFolder folder;
  const std::string picture = folder.path() / "line.svg";
  for (const std::string file : {"line.gp", "line-points.csv"}) {
    INFO(file);
    write_text(folder.path() / file, "of the user\n");
    CHECK(message_of([&] { draw(line(), picture); }).find(file) != std::string::npos);
    CHECK(bytes_of(folder.path() / file) == "of the user\n");
    fs::remove(folder.path() / file);
  }
  if (!draw(line(), picture).is_done()) return;
  const std::string drawn = bytes_of(picture);
  CHECK(draw(line(), picture).is_done());
  CHECK(bytes_of(picture) == drawn);
}

TEST_CASE("outside: gnuplot shows any text unchanged") {
  const TemporaryFolder folder;
  for (const std::string text :
       {"'begins", "ends'", "12'' rod", "'", "''", "'''", "a'b''c'''d", "\"12\"", "'\"`id`\"'", "back\\slash'n", "\\n",
        "{brace}'", "'}", "{", "# @x $y `id`", "'# no remark", "é ü '", "%d 100 %"}) {
    INFO(text);
    Plot plot = line();
    plot.panels[0].title = as_it_is(text);
    if (!draw(plot, folder.path(), {"svg"}).is_done()) return;
    const std::string svg = bytes_of(folder.path() / "line.svg");
    std::string escaped = html_escaped(text);
    for (auto at = escaped.find("&quot;"); at != std::string::npos; at = escaped.find("&quot;"))
      escaped.replace(at, 6, "\"");
    CHECK(svg.find(">" + escaped + "</tspan></text>") != std::string::npos);
  }
}

TEST_CASE("outside: a picture that cannot be redrawn stays, without leftover files") {
  const TemporaryFolder folder;
  if (!draw(line(), folder.path(), {"svg"}).is_done()) return;
  const fs::path picture = folder.path() / "line.svg";
  const std::string before = bytes_of(picture);
  Plot broken = line();
  broken.data[0].name = broken.panels[0].marks[0].table = "no-name";
  CHECK(draw(broken, folder.path(), {"svg"}).why_not.find("line.gp") != std::string::npos);
  CHECK(bytes_of(picture) == before);
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 4);
}

TEST_CASE("limit: an unknown kind of picture is refused") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(draw(line(), folder.path() / "line.jpg"), InputError);
  CHECK_THROWS_AS(draw(line(), folder.path() / "line"), InputError);
  CHECK_THROWS_AS(draw(line(), folder.path() / "li\nne.svg"), InputError);
}

TEST_CASE("outside: a picture for print states its resolution") {
  const TemporaryFolder folder;
  if (!draw(line(), folder.path(), {"png"}).is_done()) return;
  const std::string png = bytes_of(folder.path() / "line.png");
  const auto at = png.find("pHYs");
  REQUIRE(at == 37);                                                             // right after the header
  CHECK(png.substr(at + 4, 9) == std::string("\0\0\x3d\x84\0\0\x3d\x84\1", 9));  // 400 dpi: 15748 a metre
}
