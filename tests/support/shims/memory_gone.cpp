// Stands before the heap of the program itself, not of its lesson's process: after $MEMORY_GONE_AFTER allocations there is none any more.
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t n, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
}

namespace {

std::atomic<long> left{0};
bool is_counting = false;

__attribute__((constructor)) void begin() {
    const char* const after = std::getenv("MEMORY_GONE_AFTER");
    is_counting = after != nullptr && std::strcmp(program_invocation_short_name, "fulcrum") == 0;
    left = is_counting ? std::atol(after) : 0;
}

bool is_gone() {
    if (!is_counting || left.fetch_sub(1) > 0) {
        return false;
    }
    errno = ENOMEM;
    return true;
}

}  // namespace

extern "C" {
void* malloc(std::size_t size) {
    return is_gone() ? nullptr : __libc_malloc(size);
}
void* calloc(std::size_t n, std::size_t size) {
    return is_gone() ? nullptr : __libc_calloc(n, size);
}
void* realloc(void* block, std::size_t size) {
    return is_gone() ? nullptr : __libc_realloc(block, size);
}
}
