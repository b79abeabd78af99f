// One table of a case file, read key by key: what a key holds, or an InputError that says what it should.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <toml++/toml.h>

#include "case/case_file.h"
#include "case/case_keys.h"
#include "io/quantity.h"

namespace flexslip {

// Words that a key may hold, and what each stands for.
template <class Value, std::size_t count>
using Words = std::array<std::pair<std::string_view, Value>, count>;

// A node as a message says it: "'12 mm'", "the number 12", "a table".
std::string kind_of_node(const toml::node& node);

class Keys {
 public:
  // The path of the table, "specimen", or "" for the whole file. Table and case must outlive this.
  Keys(const toml::table& table, std::string path, const Case& input);

  std::string key(std::string_view name) const;  // as in Case::lines

  // Refuses all keys but these. To be called first: a key misspelt should not be reported as one that is missing.
  void only(const std::vector<std::string>& known) const;
  void only_described() const;  // all but those of the section in case_keys.h

  std::size_t size() const { return table_.size(); }
  const toml::node* find(std::string_view name) const { return table_.get(name); }
  bool has(std::string_view name) const { return find(name) != nullptr; }
  bool is_word(std::string_view name, std::string_view word) const;
  bool is_in_unit(std::string_view name, std::string_view symbol) const;  // a quantity that ends with it

  // All below refuse a key that is not there, unless they are optional. What a key holds, and within which range, stands in case_keys.h, unless
  // it is said here.
  const toml::node& need(std::string_view name) const;
  double quantity(std::string_view name, const Kind& kind, Range range) const;
  double quantity(std::string_view name) const;
  std::optional<double> optional_quantity(std::string_view name) const;
  double share(std::string_view name) const;  // [1] positive: a number, or text in percent
  std::uint64_t whole_number(std::string_view name, std::int64_t least) const;
  std::uint64_t whole_number(std::string_view name) const;
  std::string text(std::string_view name) const;
  std::variant<std::string, std::size_t> name_or_number(std::string_view name) const;
  std::string word(std::string_view name) const;  // one of the words that it may be
  StatedStiffness estimate(std::string_view name) const;
  // The tables in an array of them, such as waves = [{ … }, { … }], with no keys but those known.
  std::vector<Keys> tables(std::string_view name, const std::vector<std::string>& known) const;

  // The title of a column; its unit may also stand in the file it is in.
  std::string column(std::string_view name) const;

  // A path, relative to the folder of the case file, as one relative to the working directory.
  std::string path(std::string_view name) const;

  template <class Value, std::size_t count>
  std::optional<Value> optional_choice(std::string_view name, const Words<Value, count>& words) const {
    if (!has(name)) return std::nullopt;
    std::vector<std::string_view> known;
    for (const auto& [word, value] : words) {
      if (is_word(name, word)) return value;
      known.push_back(word);
    }
    refuse_word(name, known);
  }

  // A quantity that stands at `key`, which need not be one of this table.
  double value(const toml::node& node, const std::string& key, const Kind& kind, Range range) const;

  [[noreturn]] void refuse(std::string_view name, std::string expected, std::string found,
                           std::string remedy = "") const;

 private:
  const CaseKey& described(std::string_view name) const;
  double at_most(double value, std::string_view name) const;  // refuses what is beyond the limit of its key
  [[noreturn]] void refuse_word(std::string_view name, const std::vector<std::string_view>& known) const;
  InputError placed(const InputError& error, const std::string& key) const;
  double uncertainty(double value_of_it, const Kind& kind) const;

  const toml::table& table_;
  std::string path_;
  const Case& input_;
};

}  // namespace flexslip
