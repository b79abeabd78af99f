#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/options.h"

namespace flexslip {
namespace {

// As CITATION.cff has them, which outside/cite holds. Braces keep capitals, and names that are no person's.
struct Work {
  std::string_view type, key;
  std::array<std::pair<std::string_view, std::string_view>, 6> fields;  // those that are used
};

constexpr std::array works{
    Work{"article",
         "fang2021sawtooth",
         {{{"author", "Fang, Wenqiang and Kochiyama, Sayaka and Kesari, Haneesh"},
           {"title",
            "{Sawtooth patterns in flexural force curves of structural biological materials are not signatures of "
            "toughness enhancement: Part II}"},
           {"journal", "Journal of the Mechanical Behavior of Biomedical Materials"},
           {"year", "2021"},
           {"pages", "104787"},
           {"doi", "10.1016/j.jmbbm.2021.104787"}}}},
    Work{"misc",
         "flexslip",
         {{{"author", "{The FlexSlip authors}"},
           {"title", "{FlexSlip: friction at the supports of a three-point bending test, read off its force curve}"},
           {"year", "2026"},
           {"version", FLEXSLIP_VERSION},
           {"note", "Version " FLEXSLIP_VERSION ", BSD-3-Clause"}}}},
};

void run_cite(const Output& output) {
  std::string text;
  Json all = Json::array();
  for (const Work& work : works) {
    Json entry{{"type", work.type}, {"key", work.key}};
    text += fmt::format("{}@{}{{{},\n", text.empty() ? "" : "\n", work.type, work.key);
    for (const auto& [name, value] : work.fields) {
      if (name.empty()) continue;
      text += fmt::format("  {:<7} = {{{}}},\n", name, value);
      entry["fields"][std::string(name)] = value;
    }
    text += "}\n";
    all.push_back(std::move(entry));
  }
  write_words(
      output, [&] { return all; }, [&] { return text; });
}

}  // namespace

void add_cite_command(CLI::App& app) {
  const auto [command, output] =
      add_command(app, "cite", "How to cite the program and the paper whose model it computes, in BibTeX", run_cite);
  add_output_options(command, output, "BibTeX");
  command.footer(
      "Cite the paper for the mechanics and the program for the numbers. The version of the program stands in the "
      "entry\n"
      "and in every answer (provenance in --json).\n\n"
      "Examples:\n"
      "  flexslip cite\n"
      "  flexslip cite --output flexslip.bib");
}

}  // namespace flexslip
