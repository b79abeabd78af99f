// The marks of a figure by their names (plot.h), so that it reads as a list of what is drawn.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "report/plot.h"

namespace flexslip::marks {

using Columns = std::vector<std::size_t>;

inline constexpr double edge =
    std::numeric_limits<double>::infinity();  // of the panel; -edge: the left or the lower one

inline Mark of_table(MarkKind kind, std::string table, Columns columns, Style style, std::string title = {}) {
  return {kind, std::move(table), std::move(columns), {}, style, std::move(title)};
}
inline Mark of_numbers(MarkKind kind, std::vector<double> at, Style style, std::string title = {}) {
  return {kind, {}, {}, std::move(at), style, std::move(title)};
}

inline Mark line(std::string table, Columns columns, Style style, std::string title = {}) {
  return of_table(MarkKind::line, std::move(table), std::move(columns), style, std::move(title));
}
inline Mark points(std::string table, Columns columns, Style style, std::string title = {}) {
  return of_table(MarkKind::points, std::move(table), std::move(columns), style, std::move(title));
}
inline Mark band(std::string table, Columns columns, Style style, std::string title = {}) {
  return of_table(MarkKind::band, std::move(table), std::move(columns), style, std::move(title));
}
inline Mark bars(std::string table, Columns columns, Style style, std::string title = {}) {
  return of_table(MarkKind::bars, std::move(table), std::move(columns), style, std::move(title));
}
inline Mark arrows(std::string table, Style style) {
  return of_table(MarkKind::arrows, std::move(table), {0, 1, 2, 3}, style);
}
inline Mark horizontal(double y, Style style, std::string title = {}) {
  return of_numbers(MarkKind::horizontal, {y}, style, std::move(title));
}
inline Mark vertical(double x, Style style, std::string title = {}) {
  return of_numbers(MarkKind::vertical, {x}, style, std::move(title));
}
inline Mark rectangle(std::vector<double> edges, Style style, std::string title = {}) {
  return of_numbers(MarkKind::rectangle, std::move(edges), style, std::move(title));
}
inline Mark label(double x, double y, std::string words) {
  return of_numbers(MarkKind::label, {x, y}, {}, std::move(words));
}
inline Mark key_line(Style style, std::string title) {
  return of_numbers(MarkKind::key_line, {}, style, std::move(title));
}
inline Mark key_points(Style style, std::string title) {
  return of_numbers(MarkKind::key_points, {}, style, std::move(title));
}
inline Mark key_fill(Style style, std::string title) {
  return of_numbers(MarkKind::key_fill, {}, style, std::move(title));
}

// The same for some rows only.
inline Mark only(Mark mark, std::vector<Condition> conditions) {
  mark.only = std::move(conditions);
  return mark;
}

// Looks.
inline Style dots(Colour colour, double size = 1.7) { return {colour, 0.5, Dash::solid, Symbol::disc, size}; }
inline Style symbols(Colour colour, Symbol symbol, double size, double width = 1) {
  return {colour, width, Dash::solid, symbol, size};
}
inline Style fill(Colour colour, double opacity) { return {.colour = colour, .opacity = opacity}; }
inline Style stroke(Colour colour, double width, Dash dash = Dash::solid) { return {colour, width, dash}; }

}  // namespace flexslip::marks

// What several figures show looks alike in all.
namespace flexslip::styles {

inline constexpr Style measured{Colour::blue, 0.5, Dash::solid, Symbol::disc, 1.7};
inline constexpr Style fit{Colour::black, 1.3};
inline constexpr Style snap{Colour::black, 1, Dash::dashed};
inline constexpr Style euler{Colour::orange, 1, Dash::long_dashed};
inline constexpr Style frictionless{Colour::orange, 1};
inline constexpr Style drop{Colour::grey, 0.6, Dash::dashed};
inline constexpr Style zero{Colour::black, 0.75};
inline constexpr Style literature{.colour = Colour::green, .opacity = 0.15};
inline constexpr Style below{Colour::silver, 2};  // a curve on which others lie
inline constexpr Style loading{Colour::blue, 1.4}, unloading{Colour::vermillion, 1.4};
inline constexpr Style suspect{Colour::vermillion, 1.4, Dash::solid, Symbol::cross, 4.5};

}  // namespace flexslip::styles
