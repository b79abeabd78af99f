// A figure as JSON, for whoever else draws it: with its layout, but for the data, which are long.
#pragma once

#include "report/plot.h"
#include "result/table.h"

namespace flexslip {

// {"name", "title", "caption", "width", "height", "columns", "palette", "x_label", "y_label", "panels": [{"title", "left", "bottom",
// "width", "height", "key_rows", "key_left", "key_bottom", "x", "y", "colour": {"label", "from", "to", "logarithmic", "shown", "numbers", "ticks", "texts"}, "marks": [{"kind",
// "table", "columns", "at", "only", "title", "style"}]}]}. Places are shares of the figure; columns have the titles of the table; what is infinite is null.
Json json_of(const Plot& plot);

// All of it: beside that "data": {table: {title: [numbers]}}, where null interrupts a line.
Json json_with_data(const Plot& plot);

}  // namespace flexslip
