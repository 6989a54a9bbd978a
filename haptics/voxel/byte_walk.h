// Numbers as bytes one after the other, as they lie in memory: counted, written or read by one and the same walk over a shape.
//
// Thread: load.
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace fulcrum {

using Bytes = std::vector<std::byte>;

/// At the end of what is there.
class ByteWriter {
  public:
    explicit ByteWriter(Bytes& bytes) noexcept : bytes_(bytes) {}
    template <class T>
    void field(const T& value) {
        array(std::span<const T>(&value, 1));
    }
    template <class T>
    void array(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        const auto raw = std::as_bytes(values);
        bytes_.insert(bytes_.end(), raw.begin(), raw.end());
    }

  private:
    Bytes& bytes_;
};

/// Writes nothing, counts it.
class ByteCounter {
  public:
    template <class T>
    void field(const T& /*value*/) noexcept {
        n_bytes_ += sizeof(T);
    }
    template <class T>
    void array(std::span<const T> values) noexcept {
        n_bytes_ += values.size_bytes();
    }
    [[nodiscard]] std::size_t n_bytes() const noexcept { return n_bytes_; }

  private:
    std::size_t n_bytes_ = 0;
};

/// After the first field that is not there all others are zero, and `is_whole` says so.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::byte> bytes) noexcept : left_(bytes) {}
    template <class T>
    void field(T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        is_whole_ = is_whole_ && left_.size() >= sizeof(T);
        value = T{};
        if (is_whole_) {
            std::memcpy(&value, left_.data(), sizeof(T));
            left_ = left_.subspan(sizeof(T));
        }
    }
    /// `n` values, if there are as many.
    template <class T>
    void array(std::vector<T>& values, std::size_t n) {
        static_assert(std::is_trivially_copyable_v<T>);
        is_whole_ = is_whole_ && left_.size() / sizeof(T) >= n;
        values.clear();
        if (is_whole_ && n > 0) {
            values.resize(n);
            std::memcpy(static_cast<void*>(values.data()), left_.data(), n * sizeof(T));
            left_ = left_.subspan(n * sizeof(T));
        }
    }
    [[nodiscard]] bool is_whole() const noexcept { return is_whole_; }
    [[nodiscard]] std::size_t n_left() const noexcept { return left_.size(); }

  private:
    std::span<const std::byte> left_;
    bool is_whole_ = true;
};

}  // namespace fulcrum
