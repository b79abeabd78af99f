#include "instruments/column_words.h"

#include <algorithm>
#include <array>
#include <optional>

#include "io/quantity.h"
#include "io/text.h"

namespace flexslip {
namespace {

// Words of titles, in lower case, and their meaning. Parts may be inside a word: "Standardkraft",
// "Prüfzeit". Whole words may be numbered: "Load 2", "Force1", "LVDT30mm".
struct Meaning {
  ColumnRole role;
  std::vector<std::string_view> whole, parts;
};

// In search order: exclusions, then clear words, then ambiguous ones.
const std::vector<Meaning>& meanings() {
  static const std::vector<Meaning> all{
      // a derived quantity, or another kind
      {ColumnRole::other,
       {"rate", "work", "moment", "angle", "rotation", "count", "cycle", "command", "cmd", "target", "setpoint",
        "consigne", "error", "err", "drive", "drv"},
       {"preload",    "vorkraft",  "friction", "reibung",         "frottement", "demand",  "strain",
        "stress",     "speed",     "velocity", "geschwindigkeit", "vitesse",    "dehnung", "spannung",
        "contrainte", "energy",    "energie",  "arbeit",          "torque",     "winkel",  "temperatur",
        "pressure",   "stiffness", "modulus",  "sollwert",        "ひずみ",     "応力",    "速度"}},
      {ColumnRole::time,
       {"time", "timestamp", "temps", "elapsed", "tiempo", "tempo", "zaman", "süre", "czas", "tijd", "čas", "tid"},
       {"zeit", "時間", "时间", "시간"}},
      // at the specimen's midpoint
      {ColumnRole::deflection,
       {"defl", "flèche", "flexión", "flecha", "freccia", "sehim"},
       {"deflection", "deflectometer", "durchbiegung", "たわみ", "挠度"}},
      // at the machine's crosshead
      {ColumnRole::crosshead,
       {"stroke", "course", "actuator", "stage"},
       {"crosshead", "travers", "standardweg", "standard travel", "grip separation", "ストローク", "クロスヘッド"}},
      {ColumnRole::force,
       {"force", "load", "loadcell", "charge", "carga", "fuerza", "força", "forza", "carico", "kuvvet", "yük", "last",
        "kracht", "síla", "siła", "obciążenie"},
       {"kraft", "荷重", "試験力", "力", "载荷", "하중"}},
      // either
      {ColumnRole::displacement,
       {"extension",    "position",     "travel", "lvdt",        "disp",           "displ",     "déplacement",
        "deplacement",  "dépl",         "depl",   "allongement", "desplazamiento", "desplaz",   "despl",
        "alargamiento", "deslocamento", "desloc", "spostamento", "spost",          "uzama",     "deformation",
        "elongation",   "extensometer", "depth",  "distance",    "corsa",          "recorrido", "przemieszczenie",
        "verplaatsing", "förskjutning"},
       {"displacement", "weg", "verformung", "verschiebung", "変位", "伸び", "位移", "变形", "변위"}},
      // "Flexure" alone; before other words it only says what kind of test it is
      {ColumnRole::deflection, {"flexure"}, {}},
  };
  return all;
}

constexpr std::array roles{RoleWords{"time", "--time", "--time-unit", "s", &kind::time},
                           RoleWords{"displacement", "--displacement", "--displacement-unit", "mm", &kind::length},
                           RoleWords{"crosshead", "--crosshead", "--displacement-unit", "mm", &kind::length},
                           RoleWords{"deflection", "--deflection", "--displacement-unit", "mm", &kind::length},
                           RoleWords{"force", "--force", "--force-unit", "N", &kind::force},
                           RoleWords{"other", "--displacement", "--displacement-unit", "mm", nullptr}};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80; }

bool has_word(std::string_view text, std::string_view word, bool whole) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !(is_letter(text[at - 1]) || is_digit(text[at - 1]));
    if (!whole || (begins && (end == text.size() || !is_letter(text[end])))) return true;
  }
  return false;
}

bool has_any(std::string_view text, const Meaning& of) {
  const auto has = [&](bool whole) {
    return [text, whole](std::string_view word) { return has_word(text, word, whole); };
  };
  return std::any_of(of.whole.begin(), of.whole.end(), has(true)) ||
         std::any_of(of.parts.begin(), of.parts.end(), has(false));
}

// Symbols of the paper and of tables written by hand. Their unit must match.
struct Symbol {
  std::string_view text;
  ColumnRole role;
};
constexpr std::array symbols{
    Symbol{"t", ColumnRole::time},        Symbol{"f", ColumnRole::force},          Symbol{"p", ColumnRole::force},
    Symbol{"w_s", ColumnRole::crosshead}, Symbol{"ws", ColumnRole::crosshead},     Symbol{"w0", ColumnRole::deflection},
    Symbol{"w", ColumnRole::deflection},  Symbol{"delta", ColumnRole::deflection}, Symbol{"δ", ColumnRole::deflection}};

// A unit after a name, if its kind matches the name; after an underscore also any length, force or
// pressure.
std::optional<ColumnTitle> suffixed(std::string_view title, std::string_view mark) {
  const std::size_t at = title.rfind(mark);
  if (at == std::string_view::npos || at == 0 || at + mark.size() >= title.size()) return std::nullopt;
  const std::string_view name = trimmed(title.substr(0, at));
  std::string_view suffix = title.substr(at + mark.size());
  const ColumnRole role = role_of(name);
  if (suffix == "S" && role == ColumnRole::time) suffix = "s";
  const std::optional<Unit> unit = machine_unit(suffix);
  const Kind* wanted = words_for(role).kind;
  const bool is_meant = mark == "_" && wanted != nullptr && !meant_units(suffix, *wanted).empty();
  if (!name.empty() && is_meant) return ColumnTitle{std::string(name), std::string(suffix)};
  if (name.empty() || !unit) return std::nullopt;
  const bool measurable = unit->dimension == kind::length.dimension || unit->dimension == kind::force.dimension ||
                          unit->dimension == kind::pressure.dimension;
  if (wanted != nullptr ? unit->dimension != wanted->dimension : mark != "_" || !measurable) return std::nullopt;
  return ColumnTitle{std::string(name), std::string(suffix)};
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

// Joins tokens into titles. Each title ends with a token for which `ends` is true.
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

// Groups of `size` columns with titles, after the first `shared` columns with titles. Other columns
// can follow after a gap, such as a table of results.
std::vector<ColumnGroup> groups_of(std::span<const std::string> titles, std::span<const std::size_t> titled,
                                   std::size_t shared, std::size_t size) {
  std::size_t alike = shared + size;
  while (alike < titled.size() && titles[titled[alike]] == titles[titled[alike - size]]) ++alike;
  const bool is_whole = (alike - shared) % size == 0 && alike >= shared + 2 * size;
  if (!is_whole || (alike < titled.size() && titled[alike] == titled[alike - 1] + 1)) return {};
  titled = titled.first(alike);
  std::vector<ColumnGroup> groups;
  for (std::size_t begin = shared; begin < titled.size(); begin += size) {
    groups.push_back({titled[begin], {titled.begin(), titled.begin() + static_cast<std::ptrdiff_t>(shared)}});
    for (std::size_t i = begin; i < begin + size; ++i) groups.back().columns.push_back(titled[i]);
  }
  return groups;
}

bool is_bracketed(std::string_view text) { return without_brackets(text).size() < text.size(); }

}  // namespace

const RoleWords& words_for(ColumnRole role) { return roles.at(static_cast<std::size_t>(role)); }

bool is_displacement(ColumnRole role) {
  return role == ColumnRole::displacement || role == ColumnRole::crosshead || role == ColumnRole::deflection;
}

ColumnRole role_of(std::string_view name) {
  const std::string text = folded(trimmed(name));
  for (const Symbol& symbol : symbols)
    if (symbol.text == text) return symbol.role;
  for (const Meaning& meaning : meanings())
    if (has_any(text, meaning)) return meaning.role;
  return ColumnRole::other;
}

bool names_other_quantity(std::string_view name) { return has_any(folded(trimmed(name)), meanings().front()); }

bool names_specimens(std::string_view name) {
  static const Meaning specimens{ColumnRole::other,
                                 {"setname", "specimen", "sample", "probe", "éprouvette", "probeta", "provino"},
                                 {"prüfkörper", "試験片"}};
  return has_any(folded(name), specimens);
}

ColumnTitle title_parts(std::string_view title) {
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
    if (!names_a_unit(unit) || unit == "1") continue;  // "Force (1)" is the first of several forces
    const std::string_view before = trimmed(body.substr(0, open));
    const std::string_view after = trimmed(body.substr(close + 1));
    if (before.empty() && after.empty()) continue;
    const std::string_view between = before.empty() || after.empty() ? "" : " ";
    return {std::string(before).append(between).append(after), std::string(unit)};
  }
  for (const std::string_view mark : {"_", " "})
    if (const auto parts = suffixed(body, mark)) return *parts;
  // "Force (KN)": an invalid unit, but meant as one.
  if (const std::size_t open = body.ends_with(')') ? body.rfind('(') : 0; open != 0 && open != std::string_view::npos) {
    const std::string_view name = trimmed(body.substr(0, open)), unit = without_brackets(body.substr(open));
    const Kind* kind = words_for(role_of(name)).kind;
    if (kind != nullptr && !meant_units(unit, *kind).empty()) return {std::string(name), std::string(unit)};
  }
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

std::vector<std::string> titles_by_units(std::string_view line) {
  const std::vector<std::string_view> tokens = tokens_of(line);
  if (tokens.empty() || !is_bracketed(tokens.back())) return {};
  return joined(tokens, [&](std::size_t i) { return is_bracketed(tokens[i]); });
}

std::vector<ColumnGroup> side_by_side(std::span<const std::string> titles) {
  std::vector<std::size_t> titled;
  for (std::size_t i = 0; i < titles.size(); ++i)
    if (!titles[i].empty()) titled.push_back(i);
  for (const std::size_t shared : {std::size_t{0}, std::size_t{1}})
    for (std::size_t size = 2; shared + 2 * size <= titled.size(); ++size) {
      const auto own = std::span(titled).subspan(shared, size);
      const bool has_force = std::any_of(own.begin(), own.end(), [&](std::size_t column) {
        return role_of(title_parts(titles[column]).name) == ColumnRole::force;
      });
      if (!has_force) continue;
      const std::vector<ColumnGroup> groups = groups_of(titles, titled, shared, size);
      if (!groups.empty()) return groups;
    }
  return {};
}

}  // namespace flexslip
