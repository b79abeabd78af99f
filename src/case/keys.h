// One table of a case file, read by its keys: what a key holds, or an InputError that says what it should.
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

// A node as a message says it: "'12 mm'", "the number 12", "a table".
std::string kind_of_node(const toml::node& node);

class Keys {
 public:
  // The path of the table, "specimen", or "" for the whole file. Table and test must outlive this.
  Keys(const toml::table& table, std::string path, const Test& test);

  std::string key(std::string_view name) const;  // as in Test::lines
  std::size_t size() const { return table_.size(); }
  const toml::node* find(std::string_view name) const { return table_.get(name); }
  bool has(std::string_view name) const { return find(name) != nullptr; }

  // Reads all into the members of a part that the keys are (case_keys.h).
  // Fails:      InputError, of all at once, for keys that are no member of it and values that the keys do not hold, or for required keys that are not
  //             there: one misspelt should not be reported as missing, too.
  void read(const TestPart& part) const;

  // Refuses all keys but these.
  void only(const std::vector<std::string>& known) const;

  // All below refuse a key that is not there.
  const toml::node& need(std::string_view name) const;
  double quantity(std::string_view name, const Kind& kind, Range range) const;
  double share(std::string_view name, Range range) const;  // a number, or text in percent
  bool is_percent(std::string_view name) const;
  std::uint64_t whole_number(std::string_view name, std::int64_t min) const;
  std::size_t word(std::string_view name, const std::vector<std::string_view>& known) const;  // which of them

  // A quantity that stands at `key`, which need not be one of this table.
  double value(const toml::node& node, const std::string& key, const Kind& kind, Range range) const;

  [[noreturn]] void refuse(std::string_view name, std::string problem, std::string remedy = "") const;

 private:
  const toml::table& table_;
  std::string path_;
  const Test& test_;
};

}  // namespace flexslip
