// The reader of one table of a case file. A wrong value is an InputError that names the right type.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "case/case_file.h"
#include "case/case_keys.h"
#include "io/quantity.h"

namespace flexslip {

// A node in a message: "'12 mm'", "the number 12", "a table".
std::string kind_of_node(const toml::node& node);

class Keys {
 public:
  // `path`: of the table, "specimen", or "" for the whole file. Table and test must outlive the
  // reader.
  Keys(const toml::table& table, std::string path, const Test& test);

  std::string key(std::string_view name) const;  // as in Test::lines
  std::size_t size() const { return table_.size(); }
  const toml::node* find(std::string_view name) const { return table_.get(name); }
  bool has(std::string_view name) const { return find(name) != nullptr; }

  // Reads all keys into their members of a part (case_keys.h).
  // Fails:      InputError with all unknown keys and wrong values at once; otherwise for missing
  //             required keys, because a misspelt key would also be reported as missing.
  void read(const TestPart& part) const;

  // Refuses all other keys.
  void only(const std::vector<std::string>& known) const;

  // The functions below refuse a missing key.
  const toml::node& need(std::string_view name) const;
  double quantity(std::string_view name, const Kind& kind, Range range) const;
  double share(std::string_view name, Range range) const;  // a number, or text in percent
  bool is_percent(std::string_view name) const;
  std::uint64_t whole_number(std::string_view name, std::int64_t min) const;
  std::size_t word(std::string_view name, const std::vector<std::string_view>& known) const;  // index of the word

  // A quantity at `key`, which may be outside this table.
  double value(const toml::node& node, const std::string& key, const Kind& kind, Range range) const;

  [[noreturn]] void refuse(std::string_view name, std::string problem, std::string remedy = "") const;

 private:
  const toml::table& table_;
  std::string path_;
  const Test& test_;
};

}  // namespace flexslip
