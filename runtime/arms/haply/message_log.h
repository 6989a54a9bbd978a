// Messages as they came, one a line behind the time, until the file is full: so that who owns an arm can send what it told.
//
// Thread: one at a time. Cost: what the system takes to buffer a line; nothing where there is no file.
#pragma once

#include "haptics/base/error.h"

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

class MessageLog {
  public:
    static constexpr std::size_t kMostBytes = 32U << 20U;  ///< half a minute of an arm at 1 kHz

    MessageLog() = default;  ///< writes nothing
    /// Refuses a file that cannot be written; one that is there is written behind.
    [[nodiscard]] static Expected<MessageLog> open(const std::string& path,
                                                   std::size_t most_bytes = kMostBytes);

    /// `way` is '<' for what came and '>' for what was sent. A line's ends within the text become blanks.
    void write(char way, std::string_view text);

  private:
    struct CloseFile {
        void operator()(std::FILE* file) const noexcept { (void)std::fclose(file); }
    };
    std::unique_ptr<std::FILE, CloseFile> file_;
    double begun_s_ = 0.0;
    std::size_t left_ = 0;
    std::string line_;
};

}  // namespace fulcrum::runtime
