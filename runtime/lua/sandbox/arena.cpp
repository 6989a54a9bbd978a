#include "runtime/lua/sandbox/arena.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <sys/mman.h>

namespace fulcrum::runtime {
namespace {

// Low addresses, 256 MiB apart: no position-independent program, stack or library lies there, nor
// do the shadows of the sanitizers.
constexpr std::uintptr_t kFirstAddress = 0x1000'0000;
constexpr std::uintptr_t kAddressStep = 0x1000'0000;

std::size_t pages_for(std::size_t bytes) {
    return (bytes + kArenaPageBytes - 1) / kArenaPageBytes;
}

std::size_t size_class_of(std::size_t bytes) {
    return (bytes + kArenaGrainBytes - 1) / kArenaGrainBytes;
}

void* map_at(std::uintptr_t address, std::size_t bytes, int more_flags) {
    // The address is a wish made of a number: there is no object there yet.
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    return mmap(reinterpret_cast<void*>(address), bytes, PROT_READ | PROT_WRITE,
                MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | more_flags, -1, 0);
}

}  // namespace

Arena::Arena(std::size_t capacity_bytes, int slot) : n_pages_(pages_for(capacity_bytes)) {
    const std::uintptr_t wish = kFirstAddress + static_cast<std::uintptr_t>(slot) * kAddressStep;
    void* mapped = map_at(wish, n_pages_ * kArenaPageBytes, MAP_FIXED_NOREPLACE);
    if (mapped == MAP_FAILED) {
        mapped = map_at(0, n_pages_ * kArenaPageBytes, 0);
    }
    if (mapped == MAP_FAILED) {
        throw std::bad_alloc();
    }
    base_ = static_cast<std::byte*>(mapped);
    at_fixed_address_ = reinterpret_cast<std::uintptr_t>(mapped) == wish;
    taken_.assign(n_pages_, false);
}

Arena::~Arena() {
    munmap(base_, n_pages_ * kArenaPageBytes);
}

void* Arena::reallocate(void* block, std::size_t old_bytes, std::size_t new_bytes) noexcept {
    if (block == nullptr) {
        return new_bytes == 0 ? nullptr : allocate(new_bytes);
    }
    if (new_bytes == 0) {
        release(block, old_bytes);
        return nullptr;
    }
    // The same piece, or the same run of pages made longer, needs no copy.
    const bool both_small = old_bytes <= kLargestSmallBytes && new_bytes <= kLargestSmallBytes;
    const bool both_large = old_bytes > kLargestSmallBytes && new_bytes > kLargestSmallBytes;
    if ((both_small && size_class_of(old_bytes) == size_class_of(new_bytes)) ||
        (both_large && grow_in_place(block, pages_for(old_bytes), pages_for(new_bytes)))) {
        used_bytes_ += new_bytes - old_bytes;
        return block;
    }
    void* moved = allocate(new_bytes);
    if (moved == nullptr) {
        return nullptr;
    }
    std::memcpy(moved, block, std::min(old_bytes, new_bytes));
    release(block, old_bytes);
    return moved;
}

void* Arena::allocate(std::size_t bytes) noexcept {
    void* block = nullptr;
    if (bytes <= kLargestSmallBytes) {
        block = allocate_small(size_class_of(bytes));
    } else if (const std::size_t first = find_free_run(pages_for(bytes)); first != kNone) {
        mark(first, pages_for(bytes), true);
        block = page(first);
    }
    if (block == nullptr) {
        ++n_refused_;
        return nullptr;
    }
    used_bytes_ += bytes;
    return block;
}

void Arena::release(void* block, std::size_t bytes) noexcept {
    used_bytes_ -= bytes;
    if (bytes <= kLargestSmallBytes) {
        FreeBlock*& head = free_[size_class_of(bytes)];
        head = new (block) FreeBlock{head};
        return;
    }
    const auto offset = static_cast<std::size_t>(static_cast<std::byte*>(block) - base_);
    mark(offset / kArenaPageBytes, pages_for(bytes), false);
}

void* Arena::allocate_small(std::size_t size_class) noexcept {
    FreeBlock*& head = free_[size_class];
    if (head == nullptr) {
        // Cut a fresh page; the list is built backwards so that blocks are given out in rising
        // order.
        const std::size_t first = find_free_run(1);
        if (first == kNone) {
            return nullptr;
        }
        mark(first, 1, true);
        const std::size_t piece_bytes = size_class * kArenaGrainBytes;
        for (std::size_t i = kArenaPageBytes / piece_bytes; i-- > 0;) {
            head = new (page(first) + i * piece_bytes) FreeBlock{head};
        }
    }
    FreeBlock* block = head;
    if (block != nullptr) {
        head = block->next;
    }
    return block;
}

std::size_t Arena::find_free_run(std::size_t n_pages) const noexcept {
    std::size_t run = 0;
    for (std::size_t i = lowest_free_page_; i < n_pages_; ++i) {
        run = taken_[i] ? 0 : run + 1;
        if (run == n_pages) {
            return i + 1 - n_pages;
        }
    }
    return kNone;
}

bool Arena::grow_in_place(void* block, std::size_t old_pages, std::size_t new_pages) noexcept {
    const std::size_t first =
        static_cast<std::size_t>(static_cast<std::byte*>(block) - base_) / kArenaPageBytes;
    if (first + new_pages > n_pages_) {
        return false;
    }
    for (std::size_t i = old_pages; i < new_pages; ++i) {
        if (taken_[first + i]) {
            return false;
        }
    }
    if (new_pages > old_pages) {
        mark(first + old_pages, new_pages - old_pages, true);
    } else {
        mark(first + new_pages, old_pages - new_pages, false);
    }
    return true;
}

void Arena::mark(std::size_t first_page, std::size_t n_pages, bool taken) noexcept {
    for (std::size_t i = first_page; i < first_page + n_pages; ++i) {
        taken_[i] = taken;
    }
    if (!taken) {
        lowest_free_page_ = std::min(lowest_free_page_, first_page);
    } else if (first_page == lowest_free_page_) {
        while (lowest_free_page_ < n_pages_ && taken_[lowest_free_page_]) {
            ++lowest_free_page_;
        }
    }
}

}  // namespace fulcrum::runtime
