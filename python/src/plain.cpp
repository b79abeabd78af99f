#include "plain.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <variant>

#include <pybind11/numpy.h>

#include "data/names.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;

// File names may be invalid UTF-8.
py::str text(std::string_view words) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(words.data(), static_cast<py::ssize_t>(words.size()), "replace"));
}

// Floats or nulls become an array of floats, whole numbers an array of integers; anything else a
// list.
py::object numbers(const std::vector<const Json*>& values, bool as_numbers) {
  const auto all = [&](auto holds) { return std::all_of(values.begin(), values.end(), holds); };
  const auto count = static_cast<py::ssize_t>(values.size());
  if (!values.empty() && all([](const Json* value) { return value->is_number_integer(); })) {
    py::array_t<std::int64_t> out(count);
    std::transform(values.begin(), values.end(), out.mutable_data(),
                   [](const Json* value) { return value->get<std::int64_t>(); });
    return out;
  }
  if (as_numbers && all([](const Json* value) { return value->is_number_float() || value->is_null(); })) {
    py::array_t<double> out(count);
    std::transform(values.begin(), values.end(), out.mutable_data(),
                   [](const Json* value) { return value->is_null() ? NAN : value->get<double>(); });
    return out;
  }
  py::list out;
  for (const Json* value : values) out.append(plain(*value));
  return out;
}

py::dict columns(const Json& json, const std::vector<Description>& entries) {
  py::dict by_name, absent;
  for (const Description& entry : entries) {
    static const Json null;
    std::vector<const Json*> values;
    py::list rows_without;
    for (std::size_t row = 0; row < json.size(); ++row) {
      const auto at = json[row].find(std::string(entry.name));
      values.push_back(at == json[row].end() ? &null : &*at);
      if (at == json[row].end()) rows_without.append(row);
    }
    if (!rows_without.empty()) absent[text(entry.name)] = rows_without;
    const bool is_number = entry.shape == Shape::number;
    if (is_number || entry.shape == Shape::count) {
      by_name[text(entry.name)] = numbers(values, is_number);
      continue;
    }
    py::list out;
    for (const Json* value : values) {
      out.append(plain(*value, entry));
    }
    by_name[text(entry.name)] = out;
  }
  return py::dict(py::arg("rows") = json.size(), py::arg("columns") = by_name, py::arg("absent") = absent);
}

std::string_view name_of(Shape shape) {
  return name_in_order<Shape::any>(shape, {"number", "count", "yes_no", "words", "quantity", "numbers", "estimate",
                                           "group", "list", "by_name", "words_by_name", "any"});
}

bool has_unit(Shape shape) {
  return shape == Shape::number || shape == Shape::quantity || shape == Shape::numbers || shape == Shape::estimate;
}

Json json_of(const py::handle& data) {
  if (data.is_none()) return {};
  if (py::isinstance<py::bool_>(data)) return data.cast<bool>();
  if (py::isinstance<py::int_>(data)) return data.cast<std::int64_t>();
  if (py::isinstance<py::float_>(data)) return data.cast<double>();
  if (py::isinstance<py::str>(data)) return data.cast<std::string>();
  if (py::isinstance<py::dict>(data)) {
    Json out = Json::object();
    for (const auto& [name, value] : data.cast<py::dict>()) out[name.cast<std::string>()] = json_of(value);
    return out;
  }
  Json out = Json::array();
  for (const py::handle value : data) out.push_back(json_of(value));
  return out;
}

}  // namespace

py::object plain(const Json& json) {
  switch (json.type()) {
    case Json::value_t::boolean:
      return py::bool_(json.get<bool>());
    case Json::value_t::number_integer:
      return py::int_(json.get<std::int64_t>());
    case Json::value_t::number_unsigned:
      return py::int_(json.get<std::uint64_t>());
    case Json::value_t::number_float:
      return py::float_(json.get<double>());
    case Json::value_t::string:
      return text(json.get_ref<const std::string&>());
    case Json::value_t::array: {
      py::list out;
      for (const Json& value : json) out.append(plain(value));
      return out;
    }
    case Json::value_t::object: {
      py::dict out;
      for (const auto& [name, value] : json.items()) out[text(name)] = plain(value);
      return out;
    }
    default:
      return py::none();
  }
}

py::object plain(const Json& value, const Description& entry) {
  if (value.is_null()) return py::none();
  switch (entry.shape) {
    case Shape::numbers: {
      std::vector<const Json*> values;
      for (const Json& each : value) values.push_back(&each);
      return numbers(values, true);
    }
    case Shape::group:
      return plain(value, entry.entries);
    case Shape::list:
      return columns(value, entry.entries);
    case Shape::by_name: {
      py::dict out;
      for (const auto& [name, part] : value.items()) out[text(name)] = plain(part, entry.entries);
      return out;
    }
    default:
      return plain(value);
  }
}

py::object plain(const Json& json, const std::vector<Description>& entries) {
  if (!json.is_object()) return plain(json);
  py::dict out;
  for (const auto& [name, value] : json.items()) {
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [&name = name](const Description& each) { return each.name == name; });
    out[text(name)] = entry == entries.end() ? plain(value) : plain(value, *entry);
  }
  return out;
}

std::string dumped(const py::handle& data) {
  return json_of(data).dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

ReadingWords reading_words(const py::dict& given) {
  ReadingWords words;
  for (const auto& [key, value] : given) {
    std::string name = py::cast<std::string>(key);
    std::replace(name.begin(), name.end(), '_', '-');
    words.emplace(std::move(name), py::cast<std::string>(py::str(value)));
  }
  return words;
}

py::dict plain(const ResultTable& table) {
  py::dict by_name;
  const auto count = static_cast<py::ssize_t>(table.rows.size());
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    const py::str name = text(table.columns[column].name);
    if (table.columns[column].has_numbers) {
      py::array_t<double> values(count);
      double* at = values.mutable_data();
      for (const auto& row : table.rows) {
        const double* value = std::get_if<double>(&row[column]);
        *at++ = value ? *value : NAN;
      }
      by_name[name] = values;
      continue;
    }
    py::list values;
    for (const auto& row : table.rows) {
      const std::string* words = std::get_if<std::string>(&row[column]);
      if (words)
        values.append(text(*words));
      else
        values.append(py::none());
    }
    by_name[name] = values;
  }
  return py::dict(py::arg("rows") = count, py::arg("columns") = by_name, py::arg("absent") = py::dict());
}

py::list plain(const std::vector<Description>& entries) {
  py::list out;
  for (const Description& entry : entries) {
    const bool with_unit = has_unit(entry.shape);
    out.append(py::dict(py::arg("name") = text(entry.name), py::arg("title") = text(entry.title),
                        py::arg("shape") = text(name_of(entry.shape)),
                        py::arg("unit") = with_unit ? text(unit_of(entry.kind, false)) : text(""),
                        py::arg("reduced_unit") = with_unit ? text(unit_of(entry.kind, true)) : text(""),
                        py::arg("meaning") = text(entry.meaning), py::arg("entries") = plain(entry.entries),
                        py::arg("may_be_missing") = entry.may_be_missing, py::arg("is_several") = entry.is_several));
  }
  return out;
}

}  // namespace flexslip::python
