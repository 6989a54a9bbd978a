#include "runtime/arms/websocket/http.h"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace fulcrum::runtime {
namespace {

constexpr std::string_view kLineEnd = "\r\n";

char make_small(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

std::string_view trim_blanks(std::string_view text) {
    constexpr std::string_view kBlanks = " \t";
    const std::size_t from = text.find_first_not_of(kBlanks);
    return from == std::string_view::npos
               ? std::string_view()
               : text.substr(from, text.find_last_not_of(kBlanks) - from + 1);
}

std::optional<std::size_t> parse_size(std::string_view text, int base) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    const bool is_whole = error == std::errc{} && !text.empty() && end == text.data() + text.size();
    return is_whole ? std::optional(value) : std::nullopt;
}

// "HTTP/1.1 200 OK"
int parse_status_line(std::string_view line) {
    constexpr std::string_view kVersion = "HTTP/1.";
    constexpr std::size_t kStatusAt = 9;
    const auto status =
        line.size() >= kStatusAt + 3 && line.starts_with(kVersion) && line[kStatusAt - 1] == ' '
            ? parse_size(line.substr(kStatusAt, 3), 10)
            : std::nullopt;
    return status && *status >= 100 ? static_cast<int>(*status) : 0;
}

}  // namespace

bool is_same_word(std::string_view a, std::string_view b) noexcept {
    return std::ranges::equal(a, b, [](char x, char y) { return make_small(x) == make_small(y); });
}

std::string_view HttpHead::find(std::string_view name) const noexcept {
    const auto found =
        std::ranges::find_if(fields, [&](const auto& field) { return field.first == name; });
    return found == fields.end() ? std::string_view() : std::string_view(found->second);
}

std::optional<HttpHead> parse_http_head(std::string_view text) {
    HttpHead head;
    bool is_first = true;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(kLineEnd), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + kLineEnd.size(), text.size()));
        if (is_first) {
            is_first = false;
            head.status = parse_status_line(line);
            if (head.status == 0) {
                return std::nullopt;
            }
            continue;
        }
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos || colon == 0) {
            return std::nullopt;
        }
        std::string name(line.substr(0, colon));
        std::ranges::transform(name, name.begin(), make_small);
        head.fields.emplace_back(std::move(name), trim_blanks(line.substr(colon + 1)));
    }
    return is_first ? std::nullopt : std::optional(std::move(head));
}

std::string make_http_get(std::string_view path, std::uint16_t port) {
    std::string text = "GET ";
    text += path;
    text += " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port);
    text += "\r\nAccept: application/json\r\nConnection: close\r\n\r\n";
    return text;
}

void HttpReader::feed(std::string_view bytes) {
    if (state_ != State::reading) {
        return;
    }
    buffer_ += bytes;
    if (!has_head_) {
        read_head();
    }
    if (has_head_ && state_ == State::reading) {
        read_body();
    }
}

void HttpReader::end() {
    if (state_ == State::reading) {
        const bool ends_so = has_head_ && !is_chunked_ && !length_;
        state_ = ends_so ? State::done : State::broken;
    }
}

void HttpReader::read_head() {
    const std::size_t end = buffer_.find("\r\n\r\n");
    if (end == std::string::npos) {
        state_ = buffer_.size() > kMostHeadBytes ? State::broken : State::reading;
        return;
    }
    auto head = parse_http_head(std::string_view(buffer_).substr(0, end));
    if (!head) {
        state_ = State::broken;
        return;
    }
    head_ = std::move(*head);
    has_head_ = true;
    buffer_.erase(0, end + 4);
    is_chunked_ = is_same_word(head_.find("transfer-encoding"), "chunked");
    const std::string_view said = head_.find("content-length");
    if (!is_chunked_ && !said.empty()) {
        length_ = parse_size(said, 10);
        state_ = length_ && *length_ <= kMostBodyBytes ? State::reading : State::broken;
    }
}

void HttpReader::read_body() {
    if (is_chunked_) {
        read_chunks();
    } else {
        body_ += buffer_;
        buffer_.clear();
        if (length_ && body_.size() >= *length_) {
            body_.resize(*length_);
            state_ = State::done;
        }
    }
    if (body_.size() > kMostBodyBytes) {
        state_ = State::broken;
    }
}

// "size in hex[;extension]", the bytes, and so on; the last has none.
void HttpReader::read_chunks() {
    while (state_ == State::reading) {
        const std::size_t end = buffer_.find(kLineEnd);
        if (end == std::string::npos) {
            state_ = buffer_.size() > kMostHeadBytes ? State::broken : State::reading;
            return;
        }
        const std::string_view line = std::string_view(buffer_).substr(0, end);
        const auto size = parse_size(trim_blanks(line.substr(0, line.find(';'))), 16);
        if (!size || *size > kMostBodyBytes || body_.size() > kMostBodyBytes) {
            state_ = State::broken;
            return;
        }
        if (*size == 0) {
            state_ = State::done;
            return;
        }
        const std::size_t from = end + kLineEnd.size();
        if (buffer_.size() < from + *size + kLineEnd.size()) {
            return;
        }
        body_.append(buffer_, from, *size);
        buffer_.erase(0, from + *size + kLineEnd.size());
    }
}

}  // namespace fulcrum::runtime
