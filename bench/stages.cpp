// What the stages of a fit take, which is where their shares come from: bench/stages CASE... prints a line of CSV for each stage of each case:
// the share of the whole that is told at its beginning, and the shares of the effort and of the processor time that were spent by then [1].
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "case/case_file.h"
#include "case/fitted.h"
#include "numerics/progress.h"

namespace flexslip {
namespace {

struct Entered {
  std::string stage;
  double told;  // [1]
  std::uint64_t effort;
  std::clock_t time;
};

int run(int count, char** arguments) {
  std::printf("case,stage,told,effort,time,states,ms\n");
  for (int i = 1; i < count; ++i) {
    const Test asked = read_case(arguments[i]);
    fit_test(asked, {});  // the first builds tables for all
    std::vector<Entered> entered;
    const std::uint64_t first = effort_spent.spent();
    const std::clock_t begin = std::clock();
    const auto now = [&](const Reached& reached) {
      return Entered{std::string(reached.stage), reached.share, effort_spent.spent() - first, std::clock() - begin};
    };
    {
      const Watch watch([&](const Reached& reached) {
        if (entered.empty() || entered.back().stage != reached.stage) entered.push_back(now(reached));
      });
      fit_test(asked, {});
    }
    const Entered end = now({"end", 1});
    entered.push_back(end);
    for (const Entered& each : entered)
      std::printf("%s,%s,%.3f,%.3f,%.3f,%llu,%.1f\n", arguments[i], each.stage.c_str(), each.told,
                  static_cast<double>(each.effort) / static_cast<double>(end.effort),
                  static_cast<double>(each.time) / static_cast<double>(end.time),
                  static_cast<unsigned long long>(each.effort), 1e3 * static_cast<double>(each.time) / CLOCKS_PER_SEC);
  }
  return 0;
}

}  // namespace
}  // namespace flexslip

int main(int count, char** arguments) { return flexslip::run(count, arguments); }
