#include "instruments/column_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "instruments/column_flags.h"
#include "instruments/column_unit.h"
#include "io/quantity.h"
#include "io/text.h"

namespace flexslip {
namespace {

// A word of a title, in lower case, and what it says. Those that are `whole` are words of their own, the others may be
// part of one: "Standardkraft", "Prüfzeit".
struct Word {
  std::string_view text;
  ColumnRole role;
  bool whole;
};

// In the order in which they are looked for: what excludes, then what is clear, then what is not.
constexpr std::array words{
    // not the quantity itself, or of another kind
    Word{"strain", ColumnRole::other, false}, Word{"stress", ColumnRole::other, false},
    Word{"rate", ColumnRole::other, true}, Word{"speed", ColumnRole::other, false},
    Word{"velocity", ColumnRole::other, false}, Word{"geschwindigkeit", ColumnRole::other, false},
    Word{"vitesse", ColumnRole::other, false}, Word{"dehnung", ColumnRole::other, false},
    Word{"spannung", ColumnRole::other, false}, Word{"contrainte", ColumnRole::other, false},
    Word{"energy", ColumnRole::other, false}, Word{"energie", ColumnRole::other, false},
    Word{"work", ColumnRole::other, true}, Word{"arbeit", ColumnRole::other, false},
    Word{"torque", ColumnRole::other, false}, Word{"moment", ColumnRole::other, true},
    Word{"angle", ColumnRole::other, true}, Word{"winkel", ColumnRole::other, false},
    Word{"rotation", ColumnRole::other, true}, Word{"temperatur", ColumnRole::other, false},
    Word{"pressure", ColumnRole::other, false}, Word{"stiffness", ColumnRole::other, false},
    Word{"modulus", ColumnRole::other, false}, Word{"count", ColumnRole::other, true},
    Word{"cycle", ColumnRole::other, true}, Word{"command", ColumnRole::other, true},
    Word{"target", ColumnRole::other, true}, Word{"error", ColumnRole::other, true},
    Word{"ひずみ", ColumnRole::other, false}, Word{"応力", ColumnRole::other, false},
    Word{"速度", ColumnRole::other, false},
    // time
    Word{"time", ColumnRole::time, true}, Word{"timestamp", ColumnRole::time, true},
    Word{"zeit", ColumnRole::time, false}, Word{"temps", ColumnRole::time, true},
    Word{"elapsed", ColumnRole::time, true}, Word{"tiempo", ColumnRole::time, true},
    Word{"tempo", ColumnRole::time, true}, Word{"zaman", ColumnRole::time, true}, Word{"süre", ColumnRole::time, true},
    Word{"時間", ColumnRole::time, false},
    // the specimen's midpoint
    Word{"deflection", ColumnRole::deflection, false}, Word{"deflectometer", ColumnRole::deflection, false},
    Word{"durchbiegung", ColumnRole::deflection, false}, Word{"flexure", ColumnRole::deflection, true},
    Word{"flèche", ColumnRole::deflection, true}, Word{"flexión", ColumnRole::deflection, true},
    Word{"flecha", ColumnRole::deflection, true}, Word{"freccia", ColumnRole::deflection, true},
    Word{"sehim", ColumnRole::deflection, true}, Word{"たわみ", ColumnRole::deflection, false},
    // the machine's crosshead
    Word{"crosshead", ColumnRole::crosshead, false}, Word{"stroke", ColumnRole::crosshead, true},
    Word{"travers", ColumnRole::crosshead, false}, Word{"standardweg", ColumnRole::crosshead, false},
    Word{"course", ColumnRole::crosshead, true}, Word{"actuator", ColumnRole::crosshead, true},
    Word{"stage", ColumnRole::crosshead, true}, Word{"grip separation", ColumnRole::crosshead, false},
    Word{"ストローク", ColumnRole::crosshead, false}, Word{"クロスヘッド", ColumnRole::crosshead, false},
    // force
    Word{"force", ColumnRole::force, true}, Word{"load", ColumnRole::force, true},
    Word{"loadcell", ColumnRole::force, true}, Word{"kraft", ColumnRole::force, false},
    Word{"charge", ColumnRole::force, true}, Word{"carga", ColumnRole::force, true},
    Word{"fuerza", ColumnRole::force, true}, Word{"força", ColumnRole::force, true},
    Word{"forza", ColumnRole::force, true}, Word{"carico", ColumnRole::force, true},
    Word{"kuvvet", ColumnRole::force, true}, Word{"yük", ColumnRole::force, true},
    Word{"荷重", ColumnRole::force, false}, Word{"試験力", ColumnRole::force, false},
    Word{"力", ColumnRole::force, false},
    // a displacement of one or the other
    Word{"displacement", ColumnRole::displacement, false}, Word{"extension", ColumnRole::displacement, true},
    Word{"position", ColumnRole::displacement, true}, Word{"travel", ColumnRole::displacement, true},
    Word{"lvdt", ColumnRole::displacement, true}, Word{"weg", ColumnRole::displacement, false},
    Word{"verformung", ColumnRole::displacement, false}, Word{"verschiebung", ColumnRole::displacement, false},
    Word{"déplacement", ColumnRole::displacement, true}, Word{"deplacement", ColumnRole::displacement, true},
    Word{"allongement", ColumnRole::displacement, true}, Word{"desplazamiento", ColumnRole::displacement, true},
    Word{"alargamiento", ColumnRole::displacement, true}, Word{"deslocamento", ColumnRole::displacement, true},
    Word{"spostamento", ColumnRole::displacement, true}, Word{"uzama", ColumnRole::displacement, true},
    Word{"deformation", ColumnRole::displacement, true}, Word{"変位", ColumnRole::displacement, false},
    Word{"伸び", ColumnRole::displacement, false}};

bool is_word_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
}

bool has_word(std::string_view text, std::string_view word, bool whole) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if (!whole || ((at == 0 || !is_word_letter(text[at - 1])) && (end == text.size() || !is_word_letter(text[end]))))
      return true;
  }
  return false;
}

bool has_any(std::string_view text, std::span<const Word> of) {
  return std::any_of(of.begin(), of.end(), [&](const Word& word) { return has_word(text, word.text, word.whole); });
}

// Symbols that the paper and people who write columns by hand use, told by their unit as well.
struct Symbol {
  std::string_view text;
  ColumnRole role;
};
constexpr std::array symbols{
    Symbol{"t", ColumnRole::time},        Symbol{"f", ColumnRole::force},          Symbol{"p", ColumnRole::force},
    Symbol{"w_s", ColumnRole::crosshead}, Symbol{"ws", ColumnRole::crosshead},     Symbol{"w0", ColumnRole::deflection},
    Symbol{"w", ColumnRole::deflection},  Symbol{"delta", ColumnRole::deflection}, Symbol{"δ", ColumnRole::deflection}};

// A unit behind a name, if it is of the kind that the name means, or a length, force or pressure behind an underscore.
std::optional<TitleParts> suffixed(std::string_view title, std::string_view mark) {
  const std::size_t at = title.rfind(mark);
  if (at == std::string_view::npos || at == 0 || at + mark.size() >= title.size()) return std::nullopt;
  const std::string_view name = trimmed(title.substr(0, at));
  std::string_view suffix = title.substr(at + mark.size());
  const ColumnRole role = role_of(name);
  if (suffix == "S" && role == ColumnRole::time) suffix = "s";
  const std::optional<Unit> unit = machine_unit(suffix);
  if (name.empty() || !unit) return std::nullopt;
  const std::optional<Dimension> wanted = dimension_of(role);
  const bool measurable = unit->dimension == kind::length.dimension || unit->dimension == kind::force.dimension ||
                          unit->dimension == kind::pressure.dimension;
  if (wanted ? unit->dimension != *wanted : mark != "_" || !measurable) return std::nullopt;
  return TitleParts{std::string(name), std::string(suffix)};
}

std::vector<std::string_view> tokens_of(std::string_view line) {
  std::vector<std::string_view> tokens;
  for (std::size_t at = line.find_first_not_of(" \t"); at != std::string_view::npos;) {
    const std::size_t end = line.find_first_of(" \t", at);
    tokens.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(" \t", std::min(end, line.size()));
  }
  return tokens;
}

// Tokens joined into titles, each of which ends with a token that `ends` says ends one.
template <class Ends>
std::vector<std::string> joined(const std::vector<std::string_view>& tokens, const Ends& ends) {
  std::vector<std::string> titles;
  bool open = false;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (open)
      titles.back().append(" ").append(tokens[i]);
    else
      titles.emplace_back(tokens[i]);
    open = !ends(i);
  }
  return titles;
}

bool is_bracketed(std::string_view text) { return without_brackets(text).size() < text.size(); }

}  // namespace

ColumnRole role_of(std::string_view name) {
  const std::string text = folded(trimmed(name));
  for (const Symbol& symbol : symbols)
    if (symbol.text == text) return symbol.role;
  // An exclusion wins over all; of the others the first found.
  for (const Word& word : words)
    if (has_word(text, word.text, word.whole)) return word.role;
  return ColumnRole::other;
}

bool names_specimens(std::string_view name) {
  static constexpr std::array<Word, 9> of{{{"setname", ColumnRole::other, true},
                                           {"specimen", ColumnRole::other, true},
                                           {"sample", ColumnRole::other, true},
                                           {"probe", ColumnRole::other, true},
                                           {"prüfkörper", ColumnRole::other, false},
                                           {"éprouvette", ColumnRole::other, true},
                                           {"probeta", ColumnRole::other, true},
                                           {"provino", ColumnRole::other, true},
                                           {"試験片", ColumnRole::other, false}}};
  return has_any(folded(name), of);
}

TitleParts title_parts(std::string_view title) {
  const std::string_view body = trimmed(title);
  if (body.ends_with(']')) {
    const std::size_t open = body.rfind('[');
    const std::string_view name = open == std::string_view::npos ? "" : trimmed(body.substr(0, open));
    if (!name.empty()) return {std::string(name), std::string(without_brackets(body.substr(open)))};
  }
  for (std::size_t open = body.find_first_of("(["); open != std::string_view::npos;
       open = body.find_first_of("([", open + 1)) {
    const std::size_t close = body.find(body[open] == '(' ? ')' : ']', open);
    if (close == std::string_view::npos) break;
    const std::string_view unit = trimmed(body.substr(open + 1, close - open - 1));
    if (!names_a_unit(unit) || unit == "1") continue;  // "Force (1)" is the first of several
    const std::string_view before = trimmed(body.substr(0, open));
    const std::string_view after = trimmed(body.substr(close + 1));
    if (before.empty() && after.empty()) continue;
    const std::string_view between = before.empty() || after.empty() ? "" : " ";
    return {std::string(before).append(between).append(after), std::string(unit)};
  }
  for (const std::string_view mark : {"_", " "})
    if (const auto parts = suffixed(body, mark)) return *parts;
  return {std::string(body), ""};
}

std::vector<std::string> split_titles(std::string_view line, std::size_t columns) {
  std::vector<std::string> by_gap;
  for (std::string_view rest = trimmed(line); !rest.empty();) {
    const std::size_t end = std::min(rest.find("  "), rest.find('\t'));
    by_gap.emplace_back(trimmed(rest.substr(0, end)));
    rest = end == std::string_view::npos ? std::string_view{} : trimmed(rest.substr(end));
  }
  if (by_gap.size() == columns) return by_gap;
  const std::vector<std::string_view> tokens = tokens_of(line);
  const auto before_bracket = [&](std::size_t i) { return i + 1 < tokens.size() && is_bracketed(tokens[i + 1]); };
  std::vector<std::string> titles = joined(tokens, [&](std::size_t i) { return !before_bracket(i); });
  if (titles.size() == columns) return titles;
  titles = joined(tokens, [&](std::size_t i) {
    return !before_bracket(i) && (is_bracketed(tokens[i]) || role_of(tokens[i]) != ColumnRole::other);
  });
  if (titles.size() == columns) return titles;
  return {};
}

}  // namespace flexslip
