#include "dialogue/english/sorted_lines.h"

#include <algorithm>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace fulcrum::dialogue {

Expected<SortedLines> SortedLines::open(const std::string& path, std::string_view package) {
    const auto missing = [&] {
        return fail(concat(
            {"the word list ", path, " cannot be read; install the Debian package ", package}));
    };
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        return missing();
    }
    struct stat status {};
    const bool known = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
    const auto size = known ? static_cast<std::size_t>(status.st_size) : 0;
    void* memory = size == 0 ? MAP_FAILED : ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    ::close(file);
    if (memory == MAP_FAILED) {
        return missing();
    }
    return SortedLines(std::string_view(static_cast<const char*>(memory), size));
}

SortedLines::SortedLines(SortedLines&& other) noexcept : text_(std::exchange(other.text_, {})) {}

SortedLines& SortedLines::operator=(SortedLines&& other) noexcept {
    std::swap(text_, other.text_);
    return *this;
}

SortedLines::~SortedLines() {
    if (!text_.empty()) {
        ::munmap(const_cast<char*>(text_.data()), text_.size());
    }
}

std::size_t SortedLines::find(std::string_view prefix, bool behind) const {
    std::size_t low = 0;
    std::size_t high = text_.size();
    while (low < high) {
        // The line that the middle lies in.
        const std::size_t middle = low + (high - low) / 2;
        const std::size_t before = text_.substr(0, middle).rfind('\n');
        const std::size_t start = before == std::string_view::npos ? 0 : std::max(low, before + 1);
        const std::size_t end = std::min(text_.find('\n', middle), text_.size() - 1) + 1;
        const int order = text_.substr(start, prefix.size()).compare(prefix);
        if (order < 0 || (behind && order == 0)) {
            low = end;
        } else {
            high = start;
        }
    }
    return low;
}

std::string_view SortedLines::starting_with(std::string_view prefix) const {
    const std::size_t first = find(prefix, false);
    return text_.substr(first, find(prefix, true) - first);
}

}  // namespace fulcrum::dialogue
