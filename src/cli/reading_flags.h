// Flags that say how a file of readings or of heights is read.
#pragma once

#include <array>
#include <span>
#include <string>

#include <CLI/CLI.hpp>

#include "instruments/export.h"

namespace flexslip {

struct ReadingFlag {
  const char *name, *meaning, *type;
};

// Those of any file.
inline constexpr std::array flags_of_files{
    ReadingFlag{"sheet", "Sheet of a workbook (.xlsx), by name or number", "SHEET"},
    ReadingFlag{"encoding", "Encoding of the text: utf-8, utf-16le, utf-16be, cp1252 or shift-jis", "NAME"},
    ReadingFlag{"separator", "Separator between cells: , ; tab or space", "MARK"},
    ReadingFlag{"decimal", "Decimal mark: . or ,", "MARK"},
    ReadingFlag{"thousands", "Thousands separator: . , space ' or none", "MARK"}};

// Gives a command flags whose words are kept by their names. The words must stay where they are.
inline void add_reading_flags(CLI::App& command, ReadingWords& words, std::span<const ReadingFlag> flags,
                              const std::string& group) {
  for (const auto& [name, meaning, type] : flags)
    command.add_option(std::string("--") + name, words[name], meaning)->type_name(type)->group(group);
}

}  // namespace flexslip
