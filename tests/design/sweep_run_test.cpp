#include "design/sweep_run.h"

#include <atomic>
#include <filesystem>

#include <doctest/doctest.h>

#include "design/sweep_parts.h"
#include "io/durable_file.h"
#include "io/text_file.h"
#include "tests/design/some_sweep.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace flexslip {
namespace {

std::string merged(const std::vector<SweepParts>& folders, const std::filesystem::path& path) {
  const SweepMerge merge = merge_sweep(folders, path.string(), {});
  CHECK(merge.status == MergeStatus::done);
  return bytes_of(path);
}

TEST_CASE("identity: the file is the same for any threads, shards, folders and history") {
  const TemporaryFolder folder;
  const auto plan = some_sweep(5000);
  const SweepParts whole(folder.path() / "whole", plan);
  CHECK(run_sweep(whole, some_outcomes, {}).rows_computed == 5000);
  const std::string bytes = merged({whole}, folder.path() / "whole.h5");
  CHECK(bytes.size() > 5000);

  const SweepParts two(folder.path() / "two", plan);
  run_sweep(two, some_outcomes, {.threads = 2});
  CHECK(merged({two}, folder.path() / "two.h5") == bytes);

  const SweepParts here(folder.path() / "here", plan), there(folder.path() / "there", plan);
  for (std::uint64_t i = 7; i >= 1; --i)
    run_sweep(i % 2 == 0 ? here : there, some_outcomes, {.threads = 2, .shard = {i, 7}});
  CHECK(merged({here, there}, folder.path() / "shards.h5") == bytes);
}

TEST_CASE("identity: shards share out all chunks, none twice, evenly") {
  const TemporaryFolder folder;
  const auto plan = some_sweep(5000);
  const SweepParts parts(folder.path() / "parts", plan);
  std::uint64_t rows = 0;
  for (std::uint64_t i = 1; i <= 6; ++i) {
    const auto run = run_sweep(parts, some_outcomes, {.shard = {i, 6}});
    CHECK(run.rows_found == 0);
    CHECK(run.rows_computed + 2 * rows_in_chunk(plan) > 5000 / 6);
    CHECK(run.rows_computed < 5000 / 6 + 2 * rows_in_chunk(plan));
    rows += run.rows_computed;
  }
  CHECK(rows == 5000);
  CHECK(run_sweep(parts, some_outcomes, {}).rows_found == 5000);
  CHECK(run_sweep(parts, some_outcomes, {.shard = {900, 1000}}).rows_computed == 0);  // more shards than chunks
  CHECK(run_sweep(parts, some_outcomes, {.shard = {2, ~std::uint64_t{0}}}).rows_found == rows_in_chunk(plan));
  CHECK(message_of([&] { run_sweep(parts, some_outcomes, {.shard = {3, 2}}); }) == "no shard 3 of 2");
}

TEST_CASE("identity: parts missing and damaged are named, and they alone are computed again") {
  const TemporaryFolder folder;
  const auto plan = some_sweep(1000);
  const SweepParts parts(folder.path() / "parts", plan);
  run_sweep(parts, some_outcomes, {});
  const std::string bytes = merged({parts}, folder.path() / "before.h5");
  parts.remove(3);
  folder.file(parts.file_of(5), "torn");
  const SweepMerge merge = merge_sweep(std::vector{parts}, (folder.path() / "after.h5").string(), {});
  REQUIRE(merge.status == MergeStatus::incomplete);
  REQUIRE(merge.faults.size() == 2);
  CHECK((merge.faults[0].chunk == 3 && merge.faults[0].state == PartState::missing));
  CHECK((merge.faults[1].chunk == 5 && merge.faults[1].state == PartState::damaged));
  CHECK(merge.faults[1].file == parts.file_of(5).string());
  CHECK(!std::filesystem::exists(folder.path() / "after.h5"));
  for (const auto& file : std::filesystem::directory_iterator(folder.path()))  // nothing half written
    CHECK(file.path().string().find("unfinished") == std::string::npos);

  std::atomic<std::uint64_t> computed = 0;
  const auto run = run_sweep(parts,
                             [&](std::span<const double> inputs) {
                               ++computed;
                               return some_outcomes(inputs);
                             },
                             {.threads = 2});
  CHECK(computed == 2 * rows_in_chunk(plan));
  CHECK(run.damaged == std::vector<std::uint64_t>{5});
  CHECK(merged({parts}, folder.path() / "after.h5") == bytes);
}

TEST_CASE("identity: stopped at any row, a sweep keeps the chunks that are done, and goes on from there") {
  const TemporaryFolder folder;
  const auto plan = some_sweep(640);
  const SweepParts whole(folder.path() / "whole", plan);
  run_sweep(whole, some_outcomes, {});
  const SweepParts parts(folder.path() / "parts", plan);
  std::uint64_t kept = 0;
  for (const std::uint64_t rows : {10U, 64U, 100U, 200U}) {
    std::atomic<bool> stop = false;
    const auto run =
        run_sweep(parts, some_outcomes,
                  {.stop = &stop, .progress = [&](std::uint64_t done, std::uint64_t) { stop = done >= rows; }});
    CHECK(run.status == SweepStatus::stopped);
    CHECK(run.rows_found == kept);
    CHECK(run.rows_computed == rows / 64 * 64);
    kept += run.rows_computed;
  }
  CHECK(run_sweep(parts, some_outcomes, {}).rows_computed == 640 - kept);
  CHECK(merged({parts}, folder.path() / "a.h5") == merged({whole}, folder.path() / "b.h5"));
}

TEST_CASE("identity: a merge that is stopped leaves nothing, and the parts as they are") {
  const TemporaryFolder folder;
  const SweepParts parts(folder.path() / "parts", some_sweep(640));
  run_sweep(parts, some_outcomes, {});
  std::atomic<bool> stop = false;
  const auto merge =
      merge_sweep(std::vector{parts}, (folder.path() / "map.h5").string(),
                  {.stop = &stop, .progress = [&](std::uint64_t done, std::uint64_t) { stop = done > 300; }});
  CHECK(merge.status == MergeStatus::stopped);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
  CHECK(run_sweep(parts, some_outcomes, {}).rows_found == 640);
}

TEST_CASE("identity: a merge does not touch what another one is writing, and replaces what a killed one left") {
  const TemporaryFolder folder;
  const SweepParts parts(folder.path() / "parts", some_sweep(640));
  run_sweep(parts, some_outcomes, {});
  const std::string path = (folder.path() / "map.h5").string();
  {
    const UnfinishedFile writing(path);
    folder.file("map.h5.unfinished", "half");
    CHECK(message_of([&] {
            merge_sweep({&parts, 1}, path, {});
          }).find("is being written by another program") != std::string::npos);
    CHECK(bytes_of(writing.name()) == "half");
  }
  CHECK(!std::filesystem::exists(folder.path() / "map.h5.unfinished"));
  folder.file("map.h5.unfinished", "what a merge left that was killed");
  CHECK(merge_sweep({&parts, 1}, path, {}).status == MergeStatus::done);
}

TEST_CASE("table: a sweep that the disk has no room for is refused with both sizes") {
  const TemporaryFolder folder;
  const std::string output = (folder.path() / "map.h5").string();
  CHECK(message_of([&] { require_space(some_sweep(1000), output, {}); }) == "");
  const std::string message = message_of([&] { require_space(some_sweep(1'000'000'000'000), output, {}); });
  CHECK(message.find("1000000000000 designs") != std::string::npos);
  CHECK(message.find("304 TB") != std::string::npos);  // 19 columns of 8 bytes, twice
  CHECK(message.find("free in") != std::string::npos);
  CHECK(message.find("fewer points") != std::string::npos);
}

TEST_CASE("limit: what a part and a file take on the disk is what they are said to take, at most") {
  const TemporaryFolder folder;
  const auto plan = some_sweep(100'000);
  const SweepParts parts(folder.path() / "parts", plan);
  run_sweep(parts, some_outcomes, {.threads = 2});
  double bytes = 0;
  for (const auto& file : std::filesystem::directory_iterator(parts.folder()))
    bytes += static_cast<double>(file.file_size());
  CHECK(bytes < bytes_of_parts(plan));
  CHECK(bytes > 0.8 * bytes_of_parts(plan));
  CHECK(static_cast<double>(merged({parts}, folder.path() / "a.h5").size()) < bytes_of_sweep_file(plan));
}

}  // namespace
}  // namespace flexslip
