// Errors in an input: what is wrong, where, and what to do. Thrown where input is read, caught once per front end.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace flexslip {

// The kind of an error, for programs; people read the sentences.
enum class FaultKind {
  wrong,     // the value is invalid
  missing,   // no value is given
  unknown,   // there is nothing with this name
  too_much,  // a number beyond `limit`
};

// The part of a table that is at fault. The remedy depends on it.
enum class TablePart { none, title, cell };

// The parts of a message. Parts that do not apply are empty.
// An input that is missing, and what states it.
struct MissingInput {
  std::string instruction;  // "--span \"… mm\"", "write span = \"… mm\" into [rig]"
  std::string question;     // "how far are the supports apart?"
};

struct InputFault {
  std::string file{};                // the name that the user gave
  std::size_t line{};                // 1-based; 0 without a line
  std::string field{};               // what the user would search for: "column 'F_N'", "[specimen] diameter"
  std::string problem{};             // what is wrong, a sentence without its full stop: "'12,5' is not a number"
  std::string remedy{};              // what to do, another sentence: "write decimal points, or pass --decimal ,"
  std::vector<MissingInput> asks{};  // each on its own line

  FaultKind kind = FaultKind::wrong;
  std::string key{};                 // the key of a case file: "rig.stiffness"
  std::optional<double> limit{};     // [SI, or reduced] the limit that `too_much` exceeds
  TablePart part = TablePart::none;  // title: no column has the requested title; cell: a single cell
};

// The only exception type for bad input. what() has no control characters and is composed of the
// fault: one line, and one for each input that is missing.
// Both sentences begin with a capital letter there and end with a full stop, unless they end with another mark:
//   ss14.csv:17: column 'F_N': '12,5' is not a number. Write decimal points, or pass --decimal ,
//   case.toml:4: [rig] span: This value is missing. Add span = "1278 um".
struct InputError : std::runtime_error {
  explicit InputError(InputFault what_is_wrong);
  InputError(InputFault what_is_wrong, std::vector<InputFault> also_wrong);
  InputFault fault;
  std::vector<InputFault> also;  // further errors of the same input

  // One line for each error, what() first.
  std::vector<std::string> lines() const;
};

// A collector of errors, so that one message lists all errors of an input.
class Faults {
 public:
  bool empty() const { return faults_.empty(); }

  void add(const InputError& error);

  // Runs a step and collects the InputError that it throws, if any.
  template <class Step>
  void note(Step step) {
    try {
      step();
    } catch (const InputError& error) {
      add(error);
    }
  }

  // Throws all collected errors.
  // Fails:      InputError, in the order of lines, if any error was collected.
  void raise() const;

 private:
  std::vector<InputFault> faults_;
};

// An error with its place filled in. The reader of a file does this for errors of the reader of its text.
InputError located(const InputError& error, std::string_view file, std::size_t line, std::string_view field);

// True if a flag of the call is wrong, which belongs to no file.
bool is_of_call(const InputFault& fault);

// Errors for a file that cannot be read or written, with the reason that the system gives.
InputError unreadable(std::string file, std::string_view reason);
InputError unwritable(std::string file, std::string_view reason);

// Text from a user's file for a message: in quotes, shortened, control characters and broken UTF-8 as \xNN.
std::string in_quotes(std::string_view text);

// Names for a message, each quoted: "'a', 'b' and 'c'"; a long list is shortened and ends with a count.
std::string listed(const std::vector<std::string>& names);

// Line numbers for a message, in their order: "line 3", "lines 3 to 9", "lines 3, 5, 8 and 20 more".
std::string on_lines(std::span<const std::size_t> lines);

// The candidate that the user probably meant; "" if no candidate is similar.
// Method:     optimal string alignment distance, ignoring case; similar means at most a third of the letters.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

// The remedy "did you mean 'F_N'?"; without a similar candidate, another remedy.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates, std::string otherwise = "");

}  // namespace flexslip
