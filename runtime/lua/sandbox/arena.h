// The memory of one Lua state: a fixed-size arena at a fixed address, so that a lesson can't take
// more than it may and that two runs of it place every object alike (the order of `pairs` over
// objects depends on their addresses).
//
// Small blocks (<= kLargestSmallBytes) come from pages cut into equal pieces, with one free list a
// size; large ones are runs of whole pages, first fit. A page once cut stays cut.
//
// Thread: one. Cost: small O(1); large O(pages / 64).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fulcrum::runtime {

inline constexpr std::size_t kArenaPageBytes = 4096;
inline constexpr std::size_t kLargestSmallBytes = 1024;
inline constexpr std::size_t kArenaGrainBytes =
    16;  ///< every block is a multiple of this, and so aligned

class Arena {
  public:
    /// Maps `capacity_bytes` (rounded up to pages) at one of a few fixed addresses, `slot` 0 to 2;
    /// elsewhere when that one is taken. Throws std::bad_alloc when the kernel has no room.
    Arena(std::size_t capacity_bytes, int slot);
    Arena(const Arena&) = delete;
    Arena& operator=(const Arena&) = delete;
    ~Arena();

    /// Lua's one function of memory: grows, shrinks, makes or frees a block whose old size Lua
    /// knows. Null when full.
    [[nodiscard]] void* reallocate(void* block, std::size_t old_bytes,
                                   std::size_t new_bytes) noexcept;

    [[nodiscard]] std::size_t used_bytes() const noexcept { return used_bytes_; }
    [[nodiscard]] std::size_t capacity_bytes() const noexcept { return n_pages_ * kArenaPageBytes; }
    /// How often a block was asked for and there was no room.
    [[nodiscard]] std::uint64_t n_refused() const noexcept { return n_refused_; }
    /// True when the arena lies at its fixed address.
    [[nodiscard]] bool is_at_fixed_address() const noexcept { return at_fixed_address_; }

  private:
    struct FreeBlock {
        FreeBlock* next;
    };
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    [[nodiscard]] void* allocate(std::size_t bytes) noexcept;
    void release(void* block, std::size_t bytes) noexcept;
    [[nodiscard]] void* allocate_small(std::size_t size_class) noexcept;
    [[nodiscard]] std::size_t find_free_run(std::size_t n_pages) const noexcept;
    [[nodiscard]] bool grow_in_place(void* block, std::size_t old_pages,
                                     std::size_t new_pages) noexcept;
    void mark(std::size_t first_page, std::size_t n_pages, bool taken) noexcept;
    [[nodiscard]] std::byte* page(std::size_t index) const noexcept {
        return base_ + index * kArenaPageBytes;
    }

    std::byte* base_ = nullptr;
    std::size_t n_pages_ = 0;
    std::size_t lowest_free_page_ = 0;  ///< no page below it is free
    std::size_t used_bytes_ = 0;
    std::uint64_t n_refused_ = 0;
    bool at_fixed_address_ = false;
    std::vector<bool> taken_;
    std::array<FreeBlock*, kLargestSmallBytes / kArenaGrainBytes + 1> free_{};
};

}  // namespace fulcrum::runtime
