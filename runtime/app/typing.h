// One line of text being typed: letters, backspace, return.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

class TypedLine {
  public:
    /// Holds at most `longest_bytes`; what stands in it at first is cut there.
    explicit TypedLine(std::size_t longest_bytes = 160, std::string_view text = {})
        : longest_bytes_(longest_bytes) {
        add(text);
    }
    /// Adds typed UTF-8; what would make the line too long, and control characters, are left out.
    void add(std::string_view utf8);
    /// Takes the last character away, whole.
    void backspace();
    /// Gives the line and empties it; nothing when only blanks were typed.
    [[nodiscard]] std::optional<std::string> take();
    void clear() { text_.clear(); }
    /// Nothing is typed but blanks.
    [[nodiscard]] bool is_blank() const;
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    std::size_t longest_bytes_;
    std::string text_;
};

}  // namespace fulcrum::runtime
