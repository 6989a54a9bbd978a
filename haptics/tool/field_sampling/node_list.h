// Nodes of a tool's tree (shell_tree.h), or leaves of its thinnings, ascending: as long as it can get from the start.
//
// Thread: that of its owner; room is made at load. Cost: adding is a store that asks for no room, which its owner knows there is.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

class NodeList {
  public:
    /// Room for so many; at load.
    void reserve(std::size_t n) { nodes_.resize(n); }
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return nodes_.capacity() * sizeof(std::int32_t);
    }

    void clear() noexcept { n_ = 0; }
    void add(std::int32_t node) noexcept { nodes_[n_++] = node; }
    void copy(const NodeList& other) noexcept {
        std::copy(other.begin(), other.end(), nodes_.data());
        n_ = other.n_;
    }
    /// Of those that are there, the first `n`, or all but them.
    void shorten(std::size_t n) noexcept { n_ = n; }
    void drop_first(std::size_t n) noexcept {
        std::copy(begin() + n, end(), nodes_.data());
        n_ -= n;
    }
    /// Those for which `keeps(i)` says so, asked in turn.
    template <class Keeps>
    void keep_if(Keeps keeps) noexcept {
        std::size_t n = 0;
        for (std::size_t i = 0; i < n_; ++i) {
            if (keeps(i)) {
                nodes_[n++] = nodes_[i];
            }
        }
        n_ = n;
    }
    void sort() noexcept { std::sort(nodes_.data(), nodes_.data() + n_); }
    /// What is in either, and what is in the first alone; neither may be this one.
    void unite(const NodeList& a, const NodeList& b) noexcept {
        n_ = static_cast<std::size_t>(
            std::set_union(a.begin(), a.end(), b.begin(), b.end(), nodes_.data()) - nodes_.data());
    }
    void subtract(const NodeList& a, const NodeList& b) noexcept {
        n_ = static_cast<std::size_t>(
            std::set_difference(a.begin(), a.end(), b.begin(), b.end(), nodes_.data()) -
            nodes_.data());
    }

    [[nodiscard]] std::size_t size() const noexcept { return n_; }
    [[nodiscard]] std::size_t operator[](std::size_t i) const noexcept {
        return static_cast<std::size_t>(nodes_[i]);
    }
    [[nodiscard]] const std::int32_t* begin() const noexcept { return nodes_.data(); }
    [[nodiscard]] const std::int32_t* end() const noexcept { return nodes_.data() + n_; }
    [[nodiscard]] std::span<const std::int32_t> all() const noexcept { return {begin(), n_}; }

  private:
    std::vector<std::int32_t> nodes_;
    std::size_t n_ = 0;
};

}  // namespace fulcrum
