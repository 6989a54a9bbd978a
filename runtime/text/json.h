// What is told to programs: numbers, words, lists and named values, as JSON (RFC 8259). The library that writes it is seen by one
// source alone, for each that sees it costs seconds to compile.
//
// Thread: any; a value. Cost: allocates.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace fulcrum::runtime {

// A value is written as what it is; what holds values copies them.
// NOLINTBEGIN(google-explicit-constructor,misc-no-recursion)
class Json {
  public:
    using Member = std::pair<const char*, Json>;

    Json() = default;  ///< null
    Json(bool value) : value_(value) {}
    Json(double value) : value_(value) {}  ///< null where it is not finite
    template <std::integral I>
    Json(I value) : value_(static_cast<std::int64_t>(value)) {}
    Json(std::string value) : value_(std::move(value)) {}
    Json(std::string_view value) : value_(std::string(value)) {}
    Json(const char* value) : value_(std::string(value)) {}

    [[nodiscard]] static Json array(std::initializer_list<Json> items = {});
    /// Members keep this order.
    [[nodiscard]] static Json object(std::initializer_list<Member> members = {});

    /// Of an array.
    void push_back(Json item);
    [[nodiscard]] Json& at(std::size_t i) { return items_.at(i); }
    /// Of an object: another member, behind those that it has.
    void add(const char* name, Json value);

    /// Indented by two; what is no UTF-8 is replaced. Ends with a line's end.
    [[nodiscard]] std::string to_text() const;

  private:
    friend struct JsonWriter;
    struct Array {};
    struct Object {};

    std::variant<std::monostate, bool, double, std::int64_t, std::string, Array, Object> value_;
    std::vector<Json> items_;
    std::vector<std::string> names_;  // of an object's items
};
// NOLINTEND(google-explicit-constructor,misc-no-recursion)

}  // namespace fulcrum::runtime
