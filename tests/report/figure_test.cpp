#include "report/figure.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "io/input_error.h"

using namespace flexslip;
namespace fs = std::filesystem;

namespace {

struct Folder {
  Folder() : path((fs::temp_directory_path() / "flexslip-figure-XXXXXX").string()) {
    CHECK(mkdtemp(path.data()) != nullptr);
  }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string path;
};

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Figure line() {
  return {.name = "line",
          .title = "A <line> & more",
          .description = "It rises.",
          .width = one_column,
          .height = 50,
          .data = {{"points", {"x", "y"}, {{0, 1}, {}, {0.1, 2}}}},
          .script = "  plot points using 1:2 with lines\n"};
}

}  // namespace

TEST_CASE("outside: gnuplot draws all formats, and the same figure gives the same bytes") {
  const Folder first;
  const Folder second;
  if (draw(line(), first.path, {"svg", "pdf", "png"}) == DrawStatus::no_gnuplot) return;
  CHECK(draw(line(), second.path, {"svg", "pdf", "png"}) == DrawStatus::drawn);
  for (const std::string file : {"line.svg", "line.pdf", "line.png", "line.gp", "line-points.csv"}) {
    INFO(file);
    CHECK(!text_of(fs::path(first.path) / file).empty());
    CHECK(text_of(fs::path(first.path) / file) == text_of(fs::path(second.path) / file));
  }
  CHECK(text_of(fs::path(first.path) / "line-points.csv") == "x,y\n0,1\n\n0.1,2\n");
  const auto svg = text_of(fs::path(first.path) / "line.svg");
  CHECK(svg.find("<title>A &lt;line&gt; &amp; more</title>") != std::string::npos);
  CHECK(svg.find("<desc>It rises.</desc>") != std::string::npos);
}

TEST_CASE("outside: a name full of quotes and commands is only a name") {
  const Folder folder;
  const std::string name = "it's `id` \"$(id)\".svg";
  if (draw(line(), folder.path + "/" + name) == DrawStatus::no_gnuplot) return;
  CHECK(fs::exists(fs::path(folder.path) / name));
}

TEST_CASE("outside: gnuplot shows a text as it is, whatever it holds") {
  const Folder folder;
  for (const std::string text :
       {"'begins", "ends'", "12'' rod", "'", "''", "'''", "a'b''c'''d", "\"12\"", "'\"`id`\"'", "back\\slash'n", "\\n",
        "{brace}'", "'}", "{", "# @x $y `id`", "'# no remark", "é ü '", "%d 100 %"}) {
    INFO(text);
    Figure figure = line();
    figure.script = fmt::format("  set label 4 {} at graph 0,1.06 left noenhanced\n{}", in_script(text), line().script);
    if (draw(figure, folder.path, {"svg"}) == DrawStatus::no_gnuplot) return;
    CHECK(text_of(fs::path(folder.path) / "line.svg").find(">" + text + "</text>") != std::string::npos);
  }
}

TEST_CASE("outside: a picture that cannot be drawn again stays, and nothing lies about") {
  const Folder folder;
  if (draw(line(), folder.path, {"svg"}) == DrawStatus::no_gnuplot) return;
  const fs::path picture = fs::path(folder.path) / "line.svg";
  const std::string before = text_of(picture);
  Figure broken = line();
  broken.script += "  plot nonsense\n";
  CHECK_THROWS_AS(draw(broken, folder.path, {"svg"}), std::runtime_error);
  CHECK(text_of(picture) == before);
  CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 3);
}

TEST_CASE("limit: no picture of that kind") {
  const Folder folder;
  CHECK_THROWS_AS(draw(line(), folder.path + "/line.jpg"), InputError);
  CHECK_THROWS_AS(draw(line(), folder.path + "/line"), InputError);
  CHECK_THROWS_AS(draw(line(), folder.path + "/li\nne.svg"), InputError);
}

TEST_CASE("identity: an axis shows a quantity in the unit that reads best") {
  const auto force = plot_unit(0.012, kind::force, false, "EI/L²");
  CHECK(force.unit == "mN");
  CHECK(force.factor * 0.012 == doctest::Approx(12).epsilon(1e-15));  // one rounding each
  CHECK(axis_label("Force", "{/:Italic F}", force) == "Force\u00a0{/:Italic F}\u00a0(mN)");
  CHECK(plot_unit(0.012, kind::force, true, "EI/L²").factor == 1);
}

TEST_CASE("axes, by hand: they end at a round number, not below the greatest value") {
  CHECK(rounded_up(1) == 1);
  CHECK(rounded_up(1.01) == 1.5);
  CHECK(rounded_up(9.6) == 10);
  CHECK(rounded_up(96) == 100);
  CHECK(rounded_up(0.0213) == doctest::Approx(0.025));
}
