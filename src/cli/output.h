// What a command writes, to a file or the terminal, the progress it shows there, and how it is interrupted.
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
  std::string path = "-";  // of the results; "-" is standard output
  bool json = false;
  bool quiet = false;
};

// Writes an answer: all of it as JSON, or else in words; or as a table of rows.
// Fails:      InputError if it cannot be written.
void write_words(const Output& output, const std::function<Json()>& all, const std::function<std::string()>& words);
template <class Answer, class Row>
void write_rows(const Output& output, const Fields<Answer>& all, const Answer& answer, const Fields<Row>& columns,
                const std::vector<Row>& rows, const Frame& frame) {
  if (output.json)
    write_json(output.path, all(answer, frame));
  else
    write_csv(output.path, columns, rows, frame);
}

// Draws a figure; if that fails, a remark says why only its script and data are there. To be called after the answer is written.
void draw_for(const Output& output, const Plot& plot, const std::string& path);
// Likewise of the pictures of a report.
void note_pictures(const Output& output, const Drawing& drawing);

// As wide as the terminal, and in colour on one, unless NO_COLOR is set; of results that go into a file, as a file has them.
ScreenStyle screen_style(const Output& output);

// A remark on standard error: what was assumed, left out or cut short.
void note(const Output& output, std::string_view remark);

// Ctrl-C and SIGTERM as a request to stop, so that what is done is kept.

inline constexpr int exit_interrupted = 130;  // whichever of the two it was

// While one of these lives, a first request sets interrupted(), and a second one ends the program.
class WhileInterruptible {
 public:
  WhileInterruptible();
  ~WhileInterruptible();
  WhileInterruptible(const WhileInterruptible&) = delete;
  WhileInterruptible& operator=(const WhileInterruptible&) = delete;

 private:
  using Handler = void (*)(int);
  Handler on_interrupt_, on_terminate_;  // as they were
};

const std::atomic<bool>& interrupted();

// How far a work is, on standard error: on a terminal one line, written over and over from half a second on and erased at the end; in a log a line a
// minute. Nothing if the output is quiet.

// How much of a work is done. May be called on any thread, as often as one likes.
using ProgressFunction = std::function<void(std::uint64_t done, std::uint64_t all)>;

// "1200 of 5000 designs, 12 s left". Empty if the output is quiet.
ProgressFunction progress_of(const std::string& what, const Output& output);

// While it lives, what the work of this thread has reached: "Fitting, 43 %: friction with a wave"; on a terminal alone.
std::unique_ptr<Watch> shown_stages(const std::string& what, const Output& output);

// Text as one word of a shell's command line.

// As it is, if no shell would read it otherwise; else in single quotes.
std::string shell_word(std::string_view text);

}  // namespace flexslip
