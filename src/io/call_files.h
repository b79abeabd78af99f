// The input and output files of one call, of the program or of Python. No output may overwrite an input or an output.
//
// A command announces its outputs before it reads anything. Inputs are announced where they are opened, so that no
// command can forget one. Different spellings of a path, symbolic links and hard links count as the same file.
// Devices and pipes never clash.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "platform/files.h"

namespace flexslip {

// A clash of files. It is no InputError, which a campaign would list as the failure of one test.
struct OutputClash : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class CallFiles {
 public:
  // Announces an output, with the option that names it.
  // Fails:      OutputClash, for an output that another option writes. Nothing has been written then.
  void writes(const std::filesystem::path& file, const std::string& option);

  // Announces all files of a folder whose names have this beginning and end.
  void writes_like(const std::filesystem::path& folder, std::string begin, std::string end, const std::string& option);

  // Announces all files in a folder and in its subfolders.
  void writes_below(const std::filesystem::path& folder, const std::string& option);

  // Forbids inputs in a folder and its subfolders; outputs are allowed.
  void keeps_inputs_out_of(const std::filesystem::path& folder, const std::string& option);

  // Announces an input; "-" is standard input. Thread-safe once all outputs are announced.
  // Fails:      OutputClash, if it is an output. Nothing has been written then.
  void reads(const std::filesystem::path& file) const;

 private:
  enum class Kind { one, alike, all_below, no_input_below };
  struct Claim {
    Kind kind;
    std::string option;
    std::filesystem::path given;   // file or folder, as the user named it
    std::filesystem::path folder;  // the folder of the files, links resolved
    std::string begin{}, end{};    // of the names of the files; for one file, begin is its name
    std::map<FileIdentity, std::filesystem::path> there{};
  };

  static bool covers(const Claim& claim, const std::filesystem::path& file);
  static std::optional<std::filesystem::path> same_in(const Claim& claim, const std::filesystem::path& file);
  void add(Claim claim);

  std::vector<Claim> claims_{};
};

// The files of the program's call. Nothing is refused before an output is announced.
CallFiles& files_of_this_call();

// One of several simultaneous calls in a process. While it exists, no other call can read its outputs.
class CallUnderWay {
 public:
  explicit CallUnderWay(CallFiles files);
  ~CallUnderWay();
  CallUnderWay(const CallUnderWay&) = delete;
  CallUnderWay& operator=(const CallUnderWay&) = delete;

 private:
  CallFiles files_;
};

// Announces an input to the program's call and to every call under way.
// Fails:      as CallFiles::reads.
void announce_input(const std::filesystem::path& file);

}  // namespace flexslip
