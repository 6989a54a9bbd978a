// A program that runs beside this one and is spoken to in lines, both ways, without waiting.
//
//   send(line) -> [queue] -> its standard input            its standard output -> [part of a line] -> take()
// More is read only when no whole line is left, so that one that says too much waits, as at a pipe, and fills no memory here.
// A program that ends, says a line that is too long or takes nothing for too long is ended and told as trouble, once; after that
// nothing comes.
//
// Thread: one. Cost: some system calls; at most a line's length is read.
#pragma once

#include "haptics/base/error.h"
#include "runtime/files/start_program.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// The words that run a user's own line in a shell.
[[nodiscard]] std::vector<std::string> shell_line(const std::string& line);

class LineProgram {
  public:
    /// `words` and `kept` as for StartedProgram. An error when the system cannot start it.
    [[nodiscard]] static Expected<std::unique_ptr<LineProgram>> start(
        const std::vector<std::string>& words, const std::vector<std::string>& kept = {});
    LineProgram(const LineProgram&) = delete;
    LineProgram& operator=(const LineProgram&) = delete;
    ~LineProgram();

    /// A line without its end.
    void send(std::string_view line);
    /// The next whole line, if it has come.
    [[nodiscard]] std::optional<std::string> take();
    /// The same, waiting at most so long.
    [[nodiscard]] std::optional<std::string> wait(double patience_s);
    /// Ends it; `why` goes on from "the program x": "says too much".
    void end(const std::string& why);
    /// Ends its input and waits at most so long for it to end by itself, then ends it.
    void finish(double patience_s);
    /// Why it says nothing any more, or empty.
    [[nodiscard]] const std::string& trouble() const { return trouble_; }

    static constexpr std::size_t kMostQueued_bytes = 16'000'000;
    static constexpr std::size_t kLongestLine_bytes = 1'000'000;  ///< without its end

  private:
    explicit LineProgram(std::string name) : name_(std::move(name)) {}
    [[nodiscard]] std::optional<std::string> whole_line();
    void write_some();
    void read_some();

    std::string name_;
    StartedProgram program_;
    int socket_ = -1;
    std::string to_write_;
    std::string read_;
    std::string trouble_;
};

}  // namespace fulcrum::runtime
