// The files of one call, of the program or of the library's Python: no output may replace what a call reads, or another of its outputs.
//
// Outputs are announced where a command takes their names, before anything is read; inputs where their names are read and where
// they are opened, so that no command can forget one. Files are the same whatever way their path is spelled, and by symbolic and
// hard links. Devices and pipes are in nobody's way.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

namespace flexslip {

// Not an InputError, as it is no fault of one test of a campaign, to be listed beside the answers of the others.
struct OutputClash : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class CallFiles {
 public:
  // Each is announced with the option that names it.
  // Fails:      OutputClash, for an output that another option writes. Nothing has been written then.
  void writes(const std::filesystem::path& file, const std::string& option);

  // Files of a folder whose names begin and end so, as many as there will be.
  void writes_like(const std::filesystem::path& folder, std::string begin, std::string end, const std::string& option);

  // Anything in a folder and those below it.
  void writes_below(const std::filesystem::path& folder, const std::string& option);

  // No input may lie in a folder or below it; outputs may.
  void keeps_inputs_out_of(const std::filesystem::path& folder, const std::string& option);

  // "-" is standard input. May be called by several threads at once, when all outputs are announced.
  // Fails:      OutputClash, if it is an output. Nothing has been written then.
  void reads(const std::filesystem::path& file) const;

 private:
  enum class Kind { one, alike, all_below, no_input_below };
  struct Claim {
    Kind kind;
    std::string option;
    std::filesystem::path given;   // file or folder, as the user named it
    std::filesystem::path folder;  // that the files lie in, without links
    std::string begin{}, end{};    // of their names; of one file, begin is the name
    std::map<std::pair<dev_t, ino_t>, std::filesystem::path> there{};
  };

  static bool covers(const Claim& claim, const std::filesystem::path& file);
  static std::optional<std::filesystem::path> same_in(const Claim& claim, const std::filesystem::path& file);
  void add(Claim claim);

  std::vector<Claim> claims_{};
};

// Those of the program's call. Until an output is announced, nothing is refused.
CallFiles& files_of_this_call();

// A call among others of one process, which may run at the same time: as long as it lasts, none of them reads what it writes.
class CallUnderWay {
 public:
  explicit CallUnderWay(CallFiles files);
  ~CallUnderWay();
  CallUnderWay(const CallUnderWay&) = delete;
  CallUnderWay& operator=(const CallUnderWay&) = delete;

 private:
  CallFiles files_;
};

// An input. Fails: as CallFiles::reads, for the program's call and every call under way.
void announce_input(const std::filesystem::path& file);

}  // namespace flexslip
