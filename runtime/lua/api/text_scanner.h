// Goes through a Lua text without running it, from token to token as far as whoever looks for calls in it needs.
//
// Thread: one scanner, one thread.  Cost: linear in the text.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// Stands at a place of the text; the text lives longer.
class TextScanner {
  public:
    explicit TextScanner(std::string_view text) : text_(text) {}

    [[nodiscard]] bool at_end() const { return at_ >= text_.size(); }
    /// The line that the scanner is on.
    [[nodiscard]] int line() {
        const std::size_t now = std::min(at_, text_.size());
        for (; counted_ < now; ++counted_) {
            line_ += text_[counted_] == '\n' ? 1 : 0;
        }
        return line_;
    }

    /// Passes a comment or a text, if one begins here.
    bool pass_comment_or_text() {
        if (rest().starts_with("--")) {
            at_ += 2;
            if (!pass_long_bracket()) {
                at_ = std::min(text_.find('\n', at_), text_.size());
            }
            return true;
        }
        return take_text().has_value() || pass_long_bracket();
    }
    /// Passes `word`, which may be empty, and the blanks behind it, if it stands here.
    bool pass(std::string_view word) {
        if (!rest().starts_with(word)) {
            return false;
        }
        at_ += word.size();
        at_ = std::min(text_.find_first_not_of(" \t", at_), text_.size());
        return true;
    }
    void step() { ++at_; }
    /// The letter that stands here; not at the end.
    [[nodiscard]] char here() const { return text_[at_]; }
    /// Does a letter that a name may begin with stand here? Not at the end.
    [[nodiscard]] bool is_letter() const {
        return here() == '_' || (here() >= 'a' && here() <= 'z') ||
               (here() >= 'A' && here() <= 'Z');
    }
    /// The text between quotes that begins here, which is passed; none when no quote stands here.
    std::optional<std::string> take_text() {
        if (at_end() || (text_[at_] != '"' && text_[at_] != '\'')) {
            return std::nullopt;
        }
        const char quote = text_[at_++];
        std::string content;
        for (; !at_end() && text_[at_] != quote && text_[at_] != '\n'; ++at_) {
            at_ += text_[at_] == '\\' ? 1 : 0;
            content += at_end() ? '\0' : text_[at_];
        }
        ++at_;
        return content;
    }
    /// Does a name begin here, and not go on?
    [[nodiscard]] bool begins_name() const {
        const auto is_part = [](char c) {
            return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                   (c >= 'A' && c <= 'Z');
        };
        return at_ == 0 || !is_part(text_[at_ - 1]);
    }

  private:
    [[nodiscard]] std::string_view rest() const {
        return text_.substr(std::min(at_, text_.size()));
    }
    /// [[ … ]] or [==[ … ]==].
    bool pass_long_bracket() {
        const std::size_t inner = rest().find_first_not_of('=', 1);
        if (!rest().starts_with('[') || inner == std::string_view::npos || rest()[inner] != '[') {
            return false;
        }
        const std::string close = ']' + std::string(inner - 1, '=') + ']';
        const std::size_t end = text_.find(close, at_);
        at_ = end == std::string_view::npos ? text_.size() : end + close.size();
        return true;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t counted_ = 0;  ///< lines before this are counted
    int line_ = 1;
};

}  // namespace fulcrum::runtime
