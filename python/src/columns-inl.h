// Rows as columns; part of plain.h.

#include <map>

#include <pybind11/numpy.h>

namespace flexslip::python {

template <class Row, class Rows>
pybind11::dict columns_of_rows(const Fields<Row>& fields, const Rows& rows, const Frame& frame) {
  namespace py = pybind11;
  py::dict columns;
  const auto count = static_cast<py::ssize_t>(rows.size());
  const auto hear_signals = [](std::size_t row) {
    constexpr std::size_t apart = 1 << 15;
    if (row % apart == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
  };
  for (const Field& field : fields) {
    const py::str name(field.what.name.data(), field.what.name.size());
    if (field.what.shape == Shape::number) {
      py::array_t<double> values(count);
      double* const at = values.mutable_data();
      std::size_t i = 0;
      for (const Row& row : rows) {
        hear_signals(i);
        const Json value = field.of(&row, frame);
        at[i++] = value.is_null() ? NAN : value.get<double>();
      }
      columns[name] = std::move(values);
      continue;
    }
    py::list values(count);
    std::map<std::string, py::object, std::less<>> known;  // a few words occur many times
    std::size_t i = 0;
    for (const Row& row : rows) {
      hear_signals(i);
      const Json value = field.of(&row, frame);
      if (!value.is_string()) {
        values[i++] = plain(value);
        continue;
      }
      const auto& word = value.get_ref<const std::string&>();
      auto at = known.find(word);
      if (at == known.end()) at = known.emplace(word, py::str(word)).first;
      values[i++] = at->second;
    }
    columns[name] = std::move(values);
  }
  return py::dict(py::arg("rows") = count, py::arg("columns") = columns, py::arg("absent") = py::dict());
}

}  // namespace flexslip::python
