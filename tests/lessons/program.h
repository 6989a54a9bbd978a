// Runs the program as a person would, in a home folder of its own, and reads what it leaves behind.
#pragma once

#include "haptics/record/record.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/told.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::test {
using namespace fulcrum;

/// What one run of the program gave.
struct ProgramRun {
    int exit_code = -1;
    std::string output;  ///< standard output and error together
};

/// Checks how a run ended, where that matters, and what it said and did not say.
inline void check_run(const ProgramRun& run, std::optional<int> exit_code,
                      std::initializer_list<std::string_view> says = {},
                      std::initializer_list<std::string_view> lacks = {},
                      const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    INFO(file << ":" << line << ": " << run.output);
    check_says(run.output, says, file, line);
    check_lacks(run.output, lacks, file, line);
    if (exit_code) {
        REQUIRE(run.exit_code == *exit_code);
    }
}

/// The program of this build.
[[nodiscard]] std::string program_path();

/// A folder that goes when this goes; also the HOME of every program run in it.
class Sandbox {
  public:
    /// A path inside.
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.file(name); }
    /// Runs `fulcrum ARGUMENTS` without a display; by the command `under`, if there is one.
    [[nodiscard]] ProgramRun run(const std::string& arguments, const std::string& under = "") const;
    /// Writes a file inside, with its folders.
    std::string write(const std::string& name, const std::string& text) const;

  private:
    ScratchFolder folder_;
};

/// All bytes of a file; fails the test when there is none.
[[nodiscard]] std::string bytes_of(const std::string& path);

/// The record that a run wrote; fails the test when it cannot be read.
[[nodiscard]] Record read_run(const std::string& path);

/// The first event of a kind about a body after `from_s`; its time, or -1.
[[nodiscard]] double time_of(const Record& record, RecordEventKind kind, int body,
                             double from_s = 0.0);

/// The largest force that the device was given, newtons.
[[nodiscard]] double largest_force_N(const Record& record);

/// The sample nearest after `time_s`.
[[nodiscard]] const RecordSample& sample_at(const Record& record, double time_s);

}  // namespace fulcrum::test
