#include "report/document.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "io/text.h"
#include "report/plain_text.h"

namespace flexslip {
namespace {

constexpr std::string_view indent = "   ";

// Of standard input nothing is known.
std::string bytes_of(const InputFile& file) { return file.sha256.empty() ? "" : fmt::format("{}", file.bytes); }

struct AsText {
  std::string operator()(const std::string& words) const { return wrapped(words, indent, indent); }
  std::string operator()(const Bullets& list) const {
    std::string out;
    for (const auto& item : list.items) out += wrapped(item, indent, " - ");
    return out;
  }
  std::string operator()(const PrintedTable& table) const { return laid_out(table); }
  std::string operator()(const std::vector<ParameterRow>& rows) const {
    const auto cells = [](const ParameterRow& row) {
      return std::array{row.name, row.value, row.interval.empty() ? "" : fmt::format("[{}]", row.interval), row.remark};
    };
    std::array<std::size_t, 4> widths{};
    for (const auto& row : rows)
      for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], width_of(cells(row)[i]));
    std::string out;
    for (const auto& row : rows) {
      std::string line = " ";
      for (std::size_t i = 0; i < widths.size(); ++i) line += "  " + padded_right(cells(row)[i], widths[i]);
      out += line.erase(line.find_last_not_of(' ') + 1) + '\n';
    }
    return out;
  }
  std::string operator()(const std::vector<PreparationRow>& rows) const {
    Bullets list;
    for (const auto& row : rows) list.items.push_back(step_in_words(row));
    return (*this)(list);
  }
  std::string operator()(const Files& of) const {
    PrintedTable table{{"File", "Bytes", "SHA-256"}, {}};
    for (const auto& file : of.files) table.rows.push_back({printable(file.name), bytes_of(file), file.sha256});
    return laid_out(table);
  }
  std::string operator()(const Picture&) const { return ""; }
  std::string operator()(const Verbatim&) const { return ""; }
};

struct AsHtml {
  const std::function<std::string(const Plot&)>& figure;

  std::string operator()(const std::string& words) const { return paragraph(words); }
  std::string operator()(const Bullets& list) const {
    std::string out = "<ul>\n";
    for (const auto& item : list.items) out += fmt::format("<li>{}</li>\n", typeset_minus(html_escaped(item)));
    return out + "</ul>\n";
  }
  // A long one is folded.
  std::string operator()(const PrintedTable& table) const {
    constexpr std::size_t most_open = 12;
    return table.rows.size() <= most_open
               ? html_table(table)
               : fmt::format("<details><summary>A table of {} rows</summary>\n{}</details>\n", table.rows.size(),
                             html_table(table));
  }
  std::string operator()(const std::vector<ParameterRow>& rows) const {
    std::string out =
        "<div class=\"scroll\"><table "
        "class=\"parameters\">\n<thead><tr><th></th><th>Parameter</th><th>Value</th><th>95 "
        "% interval</th><th></th></tr></thead>\n<tbody>\n";
    for (const auto& row : rows)
      out += fmt::format(
          "<tr><td>{}</td><td><code>{}</code>, {}</td><td class=\"value\">{}</td><td class=\"value\">{}</td><td "
          "class=\"remark\">{}</td></tr>\n",
          html_escaped(row.symbol), html_escaped(row.name), html_escaped(row.meaning),
          typeset_minus(html_escaped(row.value)), typeset_minus(html_escaped(row.interval)),
          typeset_minus(html_escaped(row.remark)));
    return out + "</tbody></table></div>\n";
  }
  std::string operator()(const std::vector<PreparationRow>& rows) const {
    std::string out =
        "<div class=\"scroll\"><table class=\"parameters\">\n<thead><tr><th>Step</th><th>What was "
        "done</th><th>Value</th><th>Rows</th><th>To change this</th></tr></thead>\n<tbody>\n";
    for (const auto& row : rows)
      out += fmt::format(
          "<tr><td>{}</td><td>{}</td><td class=\"value\">{}</td><td "
          "class=\"value\">{}</td><td><code>{}</code></td></tr>\n",
          html_escaped(row.name), typeset_minus(html_escaped(row.done)), typeset_minus(html_escaped(row.value)),
          html_escaped(row.rows), html_escaped(row.otherwise));
    return out + "</tbody></table></div>\n";
  }
  std::string operator()(const Files& of) const {
    std::string out =
        "<div class=\"scroll\"><table><thead><tr><th>File</th><th>Bytes</th><th>SHA-256</th></tr></thead><tbody>\n";
    for (const auto& file : of.files)
      out += fmt::format("<tr><td>{}</td><td>{}</td><td><code>{}</code></td></tr>\n", html_escaped(file.name),
                         bytes_of(file), file.sha256);
    return out + "</tbody></table></div>\n";
  }
  std::string operator()(const Picture& picture) const { return figure(picture.plot()); }
  std::string operator()(const Verbatim& lines) const {
    return fmt::format("<pre>{}</pre>\n", html_escaped(lines.text));
  }
};

}  // namespace

Chapter& Chapter::say(const std::string& words) {
  if (!words.empty()) blocks.emplace_back(words);
  return *this;
}

Chapter& Chapter::say(const std::vector<std::string>& paragraphs) {
  for (const auto& words : paragraphs) say(words);
  return *this;
}

Chapter& Chapter::show(PrintedTable table) {
  if (!table.rows.empty()) blocks.emplace_back(std::move(table));
  return *this;
}

Chapter& Chapter::show(Block block) {
  blocks.push_back(std::move(block));
  return *this;
}

std::string in_text(const std::vector<Chapter>& chapters) {
  std::string out;
  for (const Chapter& chapter : chapters) {
    if (!chapter.title.empty()) out += fmt::format("\n[[{}]]\n", chapter.title);
    for (const Block& block : chapter.blocks) out += std::visit(AsText(), block);
  }
  return out;
}

std::string in_html(const std::vector<Chapter>& chapters, const std::function<std::string(const Plot&)>& figure) {
  std::string out;
  for (const Chapter& each : chapters) {
    if (!each.title.empty()) out += section(each.title);
    for (const Block& block : each.blocks) out += std::visit(AsHtml{figure}, block);
  }
  return out;
}

}  // namespace flexslip
