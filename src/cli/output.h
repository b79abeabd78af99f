// Output of a command to files and the terminal, progress messages, and interruption.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "numerics/progress.h"
#include "report/answer_documents.h"
#include "report/draw.h"
#include "result/table.h"

namespace flexslip {

struct Output {
  std::string path = "-";  // file of the results; "-" is standard output
  bool json = false;
  bool quiet = false;
  CsvMarks csv{};  // of every CSV file that the command writes
};

// Writes an answer in JSON or as text, or a table of rows.
// Fails:      InputError if it cannot be written.
void write_words(const Output& output, const std::function<Json()>& all, const std::function<std::string()>& words);
template <class Answer, class Row>
void write_rows(const Output& output, const Fields<Answer>& all, const Answer& answer, const Fields<Row>& columns,
                const std::vector<Row>& rows, const Frame& frame) {
  if (output.json)
    write_json(output.path, all(answer, frame));
  else
    write_csv(output.path, columns, rows, frame, output.csv);
}

// Draws a figure, after the answer is written. If drawing fails, a remark says why only the script
// and the data exist.
void draw_for(const Output& output, const Plot& plot, const std::string& path);
// Remarks on the pictures of a report that could not be drawn.
void note_pictures(const Output& output, const Drawing& drawing);

// The width of the terminal, and colours unless NO_COLOR is set. Fixed for results written to a
// file.
ScreenStyle screen_style(const Output& output);

// A remark on standard error: an assumption, an omission or an interruption.
void note(const Output& output, std::string_view remark);

// Ctrl-C and SIGTERM as a request to stop that keeps finished results.

inline constexpr int exit_interrupted = 130;  // for either signal

// While it exists, the first request sets interrupted(), and a second one ends the program.
class WhileInterruptible {
 public:
  WhileInterruptible();
  ~WhileInterruptible();
  WhileInterruptible(const WhileInterruptible&) = delete;
  WhileInterruptible& operator=(const WhileInterruptible&) = delete;

 private:
  using Handler = void (*)(int);
  Handler on_interrupt_, on_terminate_;  // previous handlers
};

const std::atomic<bool>& interrupted();

// Progress on standard error. A terminal shows one line, from half a second on, and erases it at
// the end. A log gets a line a minute. Quiet output shows nothing.

// Reports the finished share of the work. Thread-safe and cheap.
using ProgressFunction = std::function<void(std::uint64_t done, std::uint64_t all)>;

// "1200 of 5000 designs, 12 s left". Empty if the output is quiet.
ProgressFunction progress_of(const std::string& what, const Output& output);

// While it exists, a terminal shows the stage of this thread's work: "Fitting, 43 %: friction with
// a wave".
std::unique_ptr<Watch> shown_stages(const std::string& what, const Output& output);

// Text as one word of a shell command.

// Unchanged if that is safe, otherwise in single quotes.
std::string shell_word(std::string_view text);

}  // namespace flexslip
