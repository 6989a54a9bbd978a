// Runs the program as a person would, in a home folder of its own, and reads what it leaves behind.
#pragma once

#include "haptics/record/record.h"

#include <filesystem>
#include <string>

namespace fulcrum::test {

/// What one run of the program gave.
struct ProgramRun {
    int exit_code = -1;
    std::string output;  ///< standard output and error together
};

/// The program of this build.
[[nodiscard]] std::string program_path();

/// A folder that goes when this goes; also the HOME of every program run in it.
class Sandbox {
  public:
    Sandbox();
    Sandbox(const Sandbox&) = delete;
    Sandbox& operator=(const Sandbox&) = delete;
    ~Sandbox();

    /// A path inside.
    [[nodiscard]] std::string path(const std::string& name) const {
        return (folder_ / name).string();
    }
    /// Runs `fulcrum ARGUMENTS` without a display; by the command `under`, if there is one.
    [[nodiscard]] ProgramRun run(const std::string& arguments, const std::string& under = "") const;
    /// Writes a file inside, with its folders.
    std::string write(const std::string& name, const std::string& text) const;

  private:
    std::filesystem::path folder_;
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
