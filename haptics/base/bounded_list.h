// A list that never grows beyond what was reserved for it at load: a step may fill it.
//
// Thread: that of its owner. Cost: adding is a copy; no allocation after construction.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fulcrum {

template <class T>
class BoundedList {
  public:
    explicit BoundedList(int capacity)
        : items_(capacity > 0 ? static_cast<std::size_t>(capacity) : 0) {}

    /// False where it is full: then nothing is added.
    bool add(const T& item) noexcept {
        if (count_ == items_.size()) {
            return false;
        }
        items_[count_++] = item;
        return true;
    }
    /// Of a list that is not empty.
    [[nodiscard]] T take_last() noexcept { return items_[--count_]; }
    void clear() noexcept { count_ = 0; }
    /// As many of its places as fit, whatever they hold.
    void set_count(std::size_t count) noexcept {
        count_ = count < items_.size() ? count : items_.size();
    }

    [[nodiscard]] std::size_t count() const noexcept { return count_; }
    [[nodiscard]] std::size_t capacity() const noexcept { return items_.size(); }
    [[nodiscard]] T& operator[](std::size_t i) noexcept { return items_[i]; }
    [[nodiscard]] const T& operator[](std::size_t i) const noexcept { return items_[i]; }
    [[nodiscard]] std::span<T> all() noexcept { return {items_.data(), count_}; }
    [[nodiscard]] std::span<const T> all() const noexcept { return {items_.data(), count_}; }

  private:
    std::vector<T> items_;
    std::size_t count_ = 0;
};

}  // namespace fulcrum
