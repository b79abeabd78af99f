#include "report/campaign_surface_words.h"

#include <fmt/format.h>

#include "io/quantity.h"
#include "surface/resolution.h"

namespace flexslip {

std::string surfaces_in_words(const Campaign& campaign) {
  const CategorySpread& all = campaign.categories.back().without_suspects;
  if (all.surface_height.count == 0) return "";
  const auto length = [](double value) { return readable(value, kind::length); };
  // The least wave wants the finest pixel, the longest the widest field.
  const WantedImage wanted = wanted_image(all.wavelength.max, 2 * all.surface_height.min);
  return fmt::format(
      "A surface could explain these waves of friction by its slopes: waves {} high (half of crest to trough; {} to "
      "{}) "
      "would do. By the paper's rule, ten pixels from crest to trough and ten waves in the field, images with pixels "
      "of {} "
      "show those of the mean height, and pixels of {} in fields of {} would settle it for every test; flexslip "
      "surface "
      "tells what a trace resolves, and fit --surface whether it fits.",
      length(all.surface_height.mean), length(all.surface_height.min), length(all.surface_height.max),
      length(wanted_image(1, 2 * all.surface_height.mean).pixel), length(wanted.pixel), length(wanted.field));
}

}  // namespace flexslip
