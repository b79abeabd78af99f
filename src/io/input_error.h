// What is wrong with an input, where it stands, and how to mend it. Thrown at the edge, caught once per front end.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace flexslip {

// What a program may want to know; a person reads the words.
enum class FaultKind {
  wrong,     // it is there, and not as it should be
  missing,   // it is not there
  unknown,   // it is there, and nothing has this name
  too_much,  // a number beyond `limit`
};

// Of a table, what is at fault: what to advise depends on it.
enum class TablePart { none, title, cell };

// The parts of the message; those that do not apply stay empty.
struct InputFault {
  std::string file{};      // as the user named it
  std::size_t line{};      // 1-based; 0 where there is no line to point at
  std::string field{};     // what the user would search for: "column 'F_N'", "[specimen] diameter"
  std::string expected{};  // "a number"
  std::string found{};     // "'12,5'"
  std::string remedy{};    // "write decimal points, or pass --decimal ,"
  std::string problem{};   // said instead of expected and found where these make no sentence: "is missing"

  FaultKind kind = FaultKind::wrong;
  std::string key{};                 // of a case file: "rig.stiffness"
  std::optional<double> limit{};     // SI, or reduced
  TablePart part = TablePart::none;  // title: no column has the one asked for; cell: one cell alone
};

// The one exception type for bad input. what() is one line made of the fault, without control characters:
//   ss14.csv:17: column 'F_N': expected a number, found '12,5'; write decimal points, or pass --decimal ,
//   case.toml:4: [rig] span is missing; add span = "1278 um"
struct InputError : std::runtime_error {
  explicit InputError(InputFault what_is_wrong);
  InputError(InputFault what_is_wrong, std::vector<InputFault> also_wrong);
  InputFault fault;
  std::vector<InputFault> also;  // what was found to be wrong besides

  // A line for each, what() first.
  std::vector<std::string> lines() const;
};

// All that is wrong with an input, so that it can be mended at once.
class Faults {
 public:
  bool empty() const { return faults_.empty(); }

  void add(const InputError& error);

  // Takes a step, and notes the InputError in which it ends.
  template <class Step>
  void note(Step step) {
    try {
      step();
    } catch (const InputError& error) {
      add(error);
    }
  }

  // Fails:      InputError, in the order of lines, if there are any.
  void raise() const;

 private:
  std::vector<InputFault> faults_;
};

// The same error with its place filled in: what a reader of text throws, told by the reader of the file it stands in.
InputError located(const InputError& error, std::string_view file, std::size_t line, std::string_view field);

// Is it a flag of the call that is wrong, which stands in no file?
bool is_of_call(const InputFault& fault);

// A file that the system does not let us read or write, and the reason that it gives.
InputError unreadable(std::string file, std::string reason);
InputError unwritable(std::string file, std::string reason);

// Text from a user's file made fit for a message: in quotes, control characters and broken UTF-8 as \xNN, clipped.
std::string in_quotes(std::string_view text);

// Names for a message, each quoted: "'a', 'b' and 'c'"; a long list is clipped and says how many more there are.
std::string listed(const std::vector<std::string>& names);

// Lines for a message, in their order: "line 3", "lines 3 to 9", "lines 3, 5, 8 and 20 more".
std::string on_lines(std::span<const std::size_t> lines);

// The candidate the user probably meant, "" if none is near.
// Method:     optimal string alignment distance, letters of either case alike; near is at most a third of the letters.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

// A remedy that names it: "did you mean 'F_N'?"; where none is near, another remedy.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates, std::string otherwise = "");

}  // namespace flexslip
