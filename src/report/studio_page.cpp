#include "report/studio_page.h"

#include <array>
#include <cstdint>
#include <iterator>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "case/fitted.h"
#include "io/input_error.h"
#include "io/text_file.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view page_name = "flexslip-studio.html";
// The element of a page of this version that contains its tests.
constexpr std::string_view place_begins =
    "<script type=\"application/json\" id=\"given\" data-version=\"" FLEXSLIP_VERSION "\">";
constexpr std::string_view nothing_given = "[]";

std::string content_of(const std::string& file) {
  constexpr std::size_t largest = 300'000'000;  // [bytes] limit of a text in browsers
  const auto in = open_to_read(file);
  std::string bytes;
  std::array<char, 65536> piece{};
  while (in->read(piece.data(), piece.size()), in->gcount() > 0) {
    bytes.append(piece.data(), static_cast<std::size_t>(in->gcount()));
    if (bytes.size() > largest)
      throw InputError({.file = file,
                        .problem = "The file has more than 300 MB",
                        .remedy = "open the studio without it, and fit it with flexslip fit"});
  }
  return bytes;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(4 * (bytes.size() / 3 + 1));
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t j = 0; j < 3; ++j)
      three = three << 8U | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j) text += i + j <= bytes.size() ? letters[three >> (18 - 6 * j) & 63U] : '=';
  }
  return text;
}

fs::path normal(const fs::path& path) { return fs::absolute(path).lexically_normal(); }

// Names of files on the page, made unique.
class Names {
 public:
  std::string of(const std::string& file) {
    const fs::path path(file);
    std::string name = path.filename().string();
    for (int i = 2; !taken_.insert(name).second; ++i)
      name = fmt::format("{}-{}{}", path.stem().string(), i, path.extension().string());
    return name;
  }

 private:
  std::set<std::string> taken_{};
};

}  // namespace

std::optional<fs::path> built_studio_page() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  const fs::path folder = program.parent_path();
  for (const fs::path& place : {folder, folder.parent_path() / "share" / "flexslip", folder.parent_path() / "studio"})
    if (fs::is_regular_file(place / page_name, error) &&
        content_of((place / page_name).string()).find(place_begins) != std::string::npos)
      return place / page_name;
  return std::nullopt;
}

GivenTest with_its_files(Test input, const std::string& test) {
  GivenTest given{test + "/case.toml", {}};
  Names names;
  static_cast<void>(names.of("case.toml"));
  for (std::string* file : files_of(input)) {
    std::string bytes = content_of(*file);
    *file = names.of(*file);
    given.files.push_back({test + "/" + *file, std::move(bytes)});
  }
  given.files.push_back({given.open, to_toml(input)});
  return given;
}

GivenTest with_its_files(const std::string& file) {
  if (file == "-") throw InputError({.problem = "Standard input cannot be put into the page", .remedy = "name a file"});
  const fs::path path = normal(file);
  if (!file.ends_with(".toml")) return {path.filename().string(), {{path.filename().string(), content_of(file)}}};
  const std::string test = name_of_test(file);
  Test input = read_case(file);
  GivenTest given{test + "/" + path.filename().string(), {{test + "/" + path.filename().string(), case_text(file)}}};
  for (const std::string* named : files_of(input)) {
    const fs::path beside = normal(*named);
    if (beside.parent_path() != path.parent_path()) return with_its_files(std::move(input), test);
    given.files.push_back({test + "/" + beside.filename().string(), content_of(*named)});
  }
  return given;
}

void write_studio_page(const std::string& path, const fs::path& built, const std::vector<GivenTest>& tests) {
  std::string page = content_of(built.string());
  const std::size_t place = page.find(fmt::format("{}{}<", place_begins, nothing_given));
  if (place == std::string::npos)
    throw InputError({.file = built.string(),
                      .problem = "This is not the studio's page, or it has tests inside",
                      .remedy = "build it with tools/build-studio"});
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const GivenTest& test : tests) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const GivenFile& file : test.files) files.push_back({{"name", file.name}, {"data", base64(file.bytes)}});
    all.push_back({{"open", test.open}, {"files", std::move(files)}});
  }
  std::string text = all.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  page.replace(place + place_begins.size(), nothing_given.size(), text);
  write_text(path, page);
}

}  // namespace flexslip
