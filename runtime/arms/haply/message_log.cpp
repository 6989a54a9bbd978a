#include "runtime/arms/haply/message_log.h"

#include "haptics/base/clock.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fulcrum::runtime {

Expected<MessageLog> MessageLog::open(const std::string& path, std::size_t most_bytes) {
    MessageLog log;
    // A pipe or another's link would hold up who writes, or write elsewhere.
    const int file =
        ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC,
               S_IRUSR | S_IWUSR);
    struct stat found {};
    if (file >= 0 && (::fstat(file, &found) != 0 || !S_ISREG(found.st_mode))) {
        ::close(file);
        return fail("the arm's messages are kept in a file alone", path,
                    "name a file in a folder of yours");
    }
    log.file_.reset(file >= 0 ? ::fdopen(file, "a") : nullptr);
    if (!log.file_) {
        return fail(std::string("the arm's messages cannot be kept there: ") + std::strerror(errno),
                    path, "name a file in a folder of yours");
    }
    log.begun_s_ = monotonic_now_s();
    log.left_ = most_bytes;
    return log;
}

void MessageLog::write(char way, std::string_view text) {
    if (!file_) {
        return;
    }
    std::array<char, 32> head{};
    (void)std::snprintf(head.data(), head.size(), "%.6f %c ", monotonic_now_s() - begun_s_, way);
    line_ = head.data();
    line_ += text;
    std::ranges::replace_if(
        line_, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    line_ += '\n';
    // The first line that does not fit is the last: a file with holes would mislead.
    if (line_.size() > left_ ||
        std::fwrite(line_.data(), 1, line_.size(), file_.get()) != line_.size()) {
        file_.reset();
        return;
    }
    left_ -= line_.size();
}

}  // namespace fulcrum::runtime
