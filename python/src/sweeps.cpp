#include <algorithm>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "answers/design_fields.h"
#include "design/design_result.h"
#include "design/sweep_parts.h"
#include "design/sweep_plan.h"
#include "design/sweep_run.h"
#include "interruptible.h"
#include "parts.h"
#include "plain.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;

struct Sweep {
  SweepPlan plan;
  ToldSweep told;
};

// HDF5 need not be built for several threads at once.
std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

// As the command does it, so that either goes on with what the other has kept.
std::shared_ptr<Sweep> run(const SweepPlan& plan, const std::string& path, unsigned threads, bool keep_parts) {
  return interruptible([&](const std::atomic<bool>& stop) -> std::shared_ptr<Sweep> {
    const auto is_there = [&, digest = digest_of_sweep(plan)] {
      const std::lock_guard lock(one_at_a_time());
      return finds_sweep(path, digest);
    };
    const ToldSweep as_it_is{.status = "done", .file = path, .rows = plan.rows};
    if (is_there()) return std::make_shared<Sweep>(Sweep{plan, as_it_is});
    require_space(plan, path, {});
    const SweepParts parts(parts_folder_of(path), plan);
    const SweepRun computed = run_sweep(parts, RowComputer(plan), {.threads = threads, .shard = {}, .stop = &stop});
    if (computed.status == SweepStatus::stopped) return nullptr;            // the signal says the rest
    if (is_there()) return std::make_shared<Sweep>(Sweep{plan, as_it_is});  // another run beside this was faster
    const SweepMerge merge = [&] {
      const std::lock_guard lock(one_at_a_time());
      return merge_sweep({&parts, 1}, path, {.stop = &stop});
    }();
    if (merge.status == MergeStatus::stopped) return nullptr;
    ToldSweep told = as_it_is;
    if (merge.status == MergeStatus::incomplete) told.status = "incomplete";
    told.counts = merge.counts;
    told.faults = faults_of(merge, plan);
    if (merge.status == MergeStatus::done && !keep_parts) parts.remove_all();
    return std::make_shared<Sweep>(Sweep{plan, std::move(told)});
  });
}

// The designs of its file: {"rows", "columns", "absent"} as of plain.h, and of each column its unit and meaning.
py::dict designs(const Sweep& sweep) {
  py::dict columns;
  py::list entries;
  const auto described = columns_of(sweep.plan);
  for (std::size_t i = 0; i < described.size(); ++i) {
    const SweepColumn& column = described[i];
    const std::vector<double> values = [&] {
      const py::gil_scoped_release unlocked;
      const std::lock_guard lock(one_at_a_time());
      return hdf5_column(*sweep.told.file, column.path);
    }();
    const std::string name = column.path.substr(column.path.rfind('/') + 1);
    const bool is_status = i == status_column(sweep.plan);
    if (is_status) {
      py::list words;
      for (const double status : values)
        words.append(std::string(result_status_words.at(static_cast<std::size_t>(status))));
      columns[py::str(name)] = words;
    } else if (column.stored_as == StoredAs::uint32) {
      py::array_t<std::int64_t> counts(static_cast<py::ssize_t>(values.size()));
      std::transform(values.begin(), values.end(), counts.mutable_data(),
                     [](double count) { return static_cast<std::int64_t>(count); });
      columns[py::str(name)] = counts;
    } else {
      columns[py::str(name)] = py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
    }
    const std::string shape = is_status ? "words" : column.stored_as == StoredAs::uint32 ? "count" : "number";
    const std::string unit = is_status ? "" : column.units;
    entries.append(py::dict(py::arg("name") = name, py::arg("title") = "", py::arg("shape") = shape,
                            py::arg("unit") = unit, py::arg("reduced_unit") = unit,
                            py::arg("meaning") = column.description, py::arg("entries") = py::list(),
                            py::arg("may_be_missing") = false, py::arg("is_several") = false));
  }
  return py::dict(py::arg("table") = py::dict(py::arg("rows") = sweep.plan.rows, py::arg("columns") = columns,
                                              py::arg("absent") = py::dict()),
                  py::arg("entries") = entries);
}

}  // namespace

void add_sweeps(py::module_& module) {
  py::class_<Sweep, std::shared_ptr<Sweep>>(module, "Sweep")
      .def("told",
           [](const Sweep& sweep) { return plain(sweep_fields()(sweep.told, {}), sweep_fields().descriptions()); })
      .def("designs", designs);
  module.def("sweep", [](const std::string& text, const std::string& source, const std::vector<std::string>& changes,
                         const std::string& path, unsigned threads, bool keep_parts) {
    return run(read_sweep(text, source, changes), path, threads, keep_parts);
  });
}

}  // namespace flexslip::python
