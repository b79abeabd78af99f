#include "report/campaign_surface_words.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "io/quantity.h"
#include "surface/texture.h"

namespace flexslip {

std::string surfaces_in_words(const Campaign& campaign) {
  std::vector<double> heights, wavelengths;
  for (const auto& test : campaign.tests) {
    if (!test.summary || test.summary->suspect || !test.summary->wave_claimed || !test.summary->surface_height)
      continue;
    heights.push_back(test.summary->surface_height->value);
    wavelengths.push_back(test.summary->wavelength->value);
  }
  if (heights.empty()) return "";
  const auto length = [](double value) { return readable(value, kind::length); };
  const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
  const double mean = std::accumulate(heights.begin(), heights.end(), 0.0) / static_cast<double>(heights.size());
  // The least wave wants the finest pixel, the longest the widest field.
  const WantedImage wanted = wanted_image(*std::max_element(wavelengths.begin(), wavelengths.end()), 2 * *least);
  return fmt::format(
      "A surface could explain the waves of friction that are claimed by its slopes: waves {} high (half of crest to "
      "trough; {} to {}) would do. By the paper's rule, ten pixels from crest to trough and ten waves in the field, "
      "images with pixels of {} show those of the mean height, and pixels of {} in fields of {} would settle it for "
      "every test; flexslip surface tells what a trace resolves, and fit --surface whether it fits.",
      length(mean), length(*least), length(*most), length(wanted_image(1, 2 * mean).pixel), length(wanted.pixel),
      length(wanted.field));
}

}  // namespace flexslip
