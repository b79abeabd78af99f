// The marks of a figure by their names (plot.h), so that it reads as a list of what is drawn; and how they look.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "report/plot.h"

namespace flexslip::marks {

inline constexpr double edge =
    std::numeric_limits<double>::infinity();  // of the panel; -edge: the left or the lower one

struct OfTable {
  MarkKind kind;
  Mark operator()(std::string table, std::vector<std::size_t> columns, Style style, std::string title = {}) const {
    return {kind, std::move(table), std::move(columns), {}, style, std::move(title)};
  }
};
inline constexpr OfTable line{MarkKind::line}, points{MarkKind::points}, band{MarkKind::band}, area{MarkKind::area},
    bars{MarkKind::bars}, spans{MarkKind::spans}, arrows{MarkKind::arrows}, pixels{MarkKind::pixels};

struct OfNumbers {
  MarkKind kind;
  Mark operator()(std::vector<double> at, Style style, std::string title = {}) const {
    return {kind, {}, {}, std::move(at), style, std::move(title)};
  }
};
inline constexpr OfNumbers horizontal{MarkKind::horizontal}, vertical{MarkKind::vertical},
    rectangle{MarkKind::rectangle};
inline Mark label(double x, double y, std::string words) {
  return {MarkKind::label, {}, {}, {x, y}, {}, std::move(words)};
}

struct OfKey {
  MarkKind kind;
  Mark operator()(Style style, std::string title) const { return {kind, {}, {}, {}, style, std::move(title)}; }
};
inline constexpr OfKey key_line{MarkKind::key_line}, key_points{MarkKind::key_points}, key_fill{MarkKind::key_fill};

// The same mark of some rows only.
inline Mark only(Mark mark, std::vector<Condition> conditions) {
  mark.only = std::move(conditions);
  return mark;
}

}  // namespace flexslip::marks

namespace flexslip::styles {

inline Style stroke(Colour colour, double width, Dash dash = Dash::solid) { return {colour, width, dash}; }
inline Style fill(Colour colour, double opacity) { return {.colour = colour, .opacity = opacity}; }
inline Style dots(Colour colour, double size = 1.7) { return {colour, 0.5, Dash::solid, Symbol::disc, size}; }
inline Style symbols(Colour colour, Symbol symbol, double size, double width = 1) {
  return {colour, width, Dash::solid, symbol, size};
}

// What several figures show looks alike in all.
inline constexpr Style measured{Colour::blue, 0.5, Dash::solid, Symbol::disc, 1.7};
inline constexpr Style fit{Colour::black, 1.3}, snap{Colour::black, 1, Dash::dashed}, zero{Colour::black, 0.75};
inline constexpr Style euler{Colour::orange, 1, Dash::long_dashed}, frictionless{Colour::orange, 1};
inline constexpr Style drop{Colour::grey, 0.6, Dash::dashed};
inline constexpr Style literature{.colour = Colour::green, .opacity = 0.15};
inline constexpr Style below{Colour::silver, 2};  // a curve on which others lie
inline constexpr Style loading{Colour::blue, 1.4}, unloading{Colour::vermillion, 1.4};
inline constexpr Style suspect{Colour::vermillion, 1.4, Dash::solid, Symbol::cross, 4.5};

}  // namespace flexslip::styles
