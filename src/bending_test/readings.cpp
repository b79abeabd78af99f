#include "bending_test/readings.h"

#include <algorithm>
#include <cmath>

#include "bending_test/history.h"

namespace flexslip {

namespace {

constexpr double rounding_of_step = 1e-9;    // a last step as short as that is none
constexpr double rounding_of_force = 1e-11;  // what is read off a polynomial is rounded

}  // namespace

ReadingPositions::ReadingPositions(double travel, double step)
    : travel_(travel), step_(step), last_(std::ceil(travel / step - rounding_of_step)) {}

double ReadingPositions::first_beyond(double stage) const {
  double i = std::clamp(std::floor(stage / step_) + 1, 0.0, last_ + 1);
  while (i > 0 && position(i - 1) > stage) --i;
  while (i <= last_ && position(i) <= stage) ++i;
  return i;
}

void ForceFalls::read(double F) {
  if (F < last_ - rounding_of_force * last_) {
    if (!falling_) top_ = last_;
    falling_ = true;
  } else if (F > last_ + rounding_of_force * last_) {
    end();
  } else {
    return;
  }
  last_ = F;
}

void ForceFalls::end() {
  if (!falling_) return;
  falling_ = false;
  ++count_;
  sum_ += top_ - last_;
  largest_ = std::max(largest_, top_ - last_);
}

std::vector<RecordedForce> record_of(const BendingTest& test, double travel, double step) {
  constexpr double most = 20000;
  constexpr int points_of_stretch = 60;
  const auto path = [&] {
    if (step == 0 || travel / step > most)
      return follow_continuously(test, std::vector{travel}, points_of_stretch).path;
    const ReadingPositions readings(travel, step);
    std::vector<double> stages;
    stages.reserve(static_cast<std::size_t>(readings.count()));
    for (int i = 1; i < readings.count(); ++i) stages.push_back(readings.position(i));
    return follow_in_steps(test, stages).path;
  }();
  std::vector<RecordedForce> record{{0, 0}};
  record.reserve(path.size() + 1);
  for (const auto& point : path) record.push_back({point.stage, point.F});
  return record;
}

}  // namespace flexslip
