// Writer and reader of messages with the same calls, so that one function a type says its layout
// and its limits once.
//
// A field call has a name for people and its limits. The writer ignores the limits; the reader
// checks them, remembers the first that does not hold, and from there on reads zeros.
#pragma once

#include "haptics/base/error.h"
#include "runtime/lua/wire/wire_limits.h"
#include "runtime/scene/lesson_limits.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <span>
#include <string>
#include <variant>

namespace fulcrum::runtime::wire {

/// Appends fields to a buffer.
class Writer {
  public:
    static constexpr bool kReads = false;
    explicit Writer(Bytes& out) : out_(out) {}

    template <class T>
    void raw(const T& value) {
        static_assert(std::is_trivially_copyable_v<T> &&
                      std::endian::native == std::endian::little);
        const std::size_t at = out_.size();
        out_.resize(at + sizeof(T));
        std::memcpy(out_.data() + at, &value, sizeof(T));
    }
    void number(const char* /*what*/, const double& value, double /*low*/, double /*high*/,
                double /*or_this*/ = 0.0) {
        raw(value);
    }
    template <class Integer>
    void integer(const char* /*what*/, const Integer& value, std::int64_t /*low*/,
                 std::int64_t /*high*/) {
        raw(value);
    }
    void flag(const char* /*what*/, const bool& value) { raw(static_cast<std::uint8_t>(value)); }
    template <class Enum>
    void choice(const char* /*what*/, const Enum& value, Enum /*last*/) {
        raw(static_cast<std::uint8_t>(value));
    }
    void text(const char* /*what*/, const std::string& value, std::size_t /*max_bytes*/) {
        bytes(value);
    }
    void name(const char* /*what*/, const std::string& value) { bytes(value); }
    void source_text(const char* /*what*/, const std::string& value) { bytes(value); }
    template <class List, class Each>
    void list(const char* /*what*/, const List& values, std::size_t /*max*/, Each each) {
        raw(static_cast<std::uint32_t>(values.size()));
        for (const auto& value : values) {
            each(*this, value);
        }
    }
    template <class Variant, class Each>
    void one_of(const char* /*what*/, const Variant& value, Each each) {
        raw(static_cast<std::uint8_t>(value.index()));
        std::visit([&](const auto& alternative) { each(*this, alternative); }, value);
    }

  private:
    void bytes(const std::string& value) {
        raw(static_cast<std::uint32_t>(value.size()));
        out_.insert(out_.end(), value.begin(), value.end());
    }
    Bytes& out_;
};

/// Takes fields from bytes that are not trusted.
class Reader {
  public:
    static constexpr bool kReads = true;
    explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    template <class T>
    [[nodiscard]] T raw(const char* what) {
        T value{};
        if (bytes_.size() < sizeof(T)) {
            refuse(what, "is cut off");
            return value;
        }
        std::memcpy(&value, bytes_.data(), sizeof(T));
        bytes_ = bytes_.subspan(sizeof(T));
        return failed() ? T{} : value;
    }
    void number(const char* what, double& value, double low, double high) {
        number(what, value, low, high, low);
    }
    /// Within its range, or that one value besides.
    void number(const char* what, double& value, double low, double high, double or_this) {
        value = raw<double>(what);
        if (!(value >= low && value <= high) && value != or_this) {  // a NaN is neither
            refuse(what, "is out of its range");
            value = low;
        }
    }
    template <class Integer>
    void integer(const char* what, Integer& value, std::int64_t low, std::int64_t high) {
        value = raw<Integer>(what);
        if (std::cmp_less(value, low) || std::cmp_greater(value, high)) {
            refuse(what, "is out of its range");
            value = static_cast<Integer>(low);
        }
    }
    void flag(const char* what, bool& value) {
        const auto byte = raw<std::uint8_t>(what);
        value = byte == 1;
        if (byte > 1) {
            refuse(what, "is neither yes nor no");
        }
    }
    template <class Enum>
    void choice(const char* what, Enum& value, Enum last) {
        const auto byte = raw<std::uint8_t>(what);
        if (byte > static_cast<std::uint8_t>(last)) {
            refuse(what, "is not a known kind");
        }
        value = failed() ? Enum{} : static_cast<Enum>(byte);
    }
    void text(const char* what, std::string& value, std::size_t max_bytes) {
        bytes(what, value, max_bytes);
        if (!is_clean_utf8(value)) {
            refuse(what, "is not clean UTF-8 text");
            value.clear();
        }
    }
    /// Empty or a name.
    void name(const char* what, std::string& value) {
        bytes(what, value, kMaxNameBytes);
        if (!value.empty() && !is_name(value)) {
            refuse(what, "is not a plain name");
            value.clear();
        }
    }
    /// Any bytes: only the lesson's process, which holds nothing, reads it.
    void source_text(const char* what, std::string& value) { bytes(what, value, kMaxSourceBytes); }
    template <class List, class Each>
    void list(const char* what, List& values, std::size_t max, Each each) {
        const auto n = raw<std::uint32_t>(what);
        if (n > max || n > bytes_.size()) {  // an element takes at least a byte
            refuse(what, "are too many");
        }
        values.clear();
        for (std::uint32_t i = 0; i < n && !failed(); ++i) {
            each(*this, values.emplace_back());
        }
    }
    template <class Variant, class Each>
    void one_of(const char* what, Variant& value, Each each) {
        const auto index = raw<std::uint8_t>(what);
        if (index >= std::variant_size_v<Variant>) {
            refuse(what, "is not a known kind");
            return;
        }
        emplace(value, index, std::make_index_sequence<std::variant_size_v<Variant>>{});
        std::visit([&](auto& alternative) { each(*this, alternative); }, value);
    }

    /// Remembers the first refusal.
    void refuse(const char* what, const char* why) {
        if (problem_.empty()) {
            problem_ = std::string(what) + " " + why;
        }
        bytes_ = {};
    }
    [[nodiscard]] bool failed() const { return !problem_.empty(); }
    /// The value when all was well and nothing is left over.
    template <class T>
    [[nodiscard]] Expected<T> result(T&& value) {
        if (!failed() && !bytes_.empty()) {
            refuse("the message", "is longer than it says");
        }
        if (failed()) {
            return fail("a message is malformed: " + problem_);
        }
        return std::forward<T>(value);
    }

  private:
    void bytes(const char* what, std::string& value, std::size_t max_bytes) {
        const auto n = raw<std::uint32_t>(what);
        if (n > max_bytes || n > bytes_.size()) {
            refuse(what, "is too long");
            value.clear();
            return;
        }
        value.assign(reinterpret_cast<const char*>(bytes_.data()), n);
        bytes_ = bytes_.subspan(n);
    }
    template <class Variant, std::size_t... kIndex>
    static void emplace(Variant& value, std::size_t index, std::index_sequence<kIndex...> /*all*/) {
        ((index == kIndex ? static_cast<void>(value.template emplace<kIndex>()) : void()), ...);
    }

    std::span<const std::uint8_t> bytes_;
    std::string problem_;
};

/// Three numbers within +-limit.
template <class Archive, class Vector>
void vector(Archive& a, const char* what, Vector& v, double limit) {
    for (int i = 0; i < 3; ++i) {
        a.number(what, v[i], -limit, limit);
    }
}

/// A position, and an orientation that the reader brings back to unit length.
template <class Archive, class AnyPose>
void pose(Archive& a, const char* what, AnyPose& value, double limit) {
    vector(a, what, value.position, limit);
    for (int i = 0; i < 4; ++i) {
        a.number(what, value.orientation.coeffs()[i], -2.0, 2.0);
    }
    if constexpr (Archive::kReads) {
        const double length = value.orientation.norm();
        if (length < 0.5) {
            a.refuse(what, "has no orientation");
            value.orientation.setIdentity();
        } else if (std::abs(length - 1.0) > 1e-9) {
            value.orientation.normalize();
        }
    }
}

}  // namespace fulcrum::runtime::wire
