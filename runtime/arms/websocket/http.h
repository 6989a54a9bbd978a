// As much HTTP as a service at this computer needs: a GET, and its answer, without a socket.
//
// The answer's body ends as its head says: after Content-Length bytes, with the last of its chunks, or where the line closes.
//
// Thread: its owner's. Cost: a copy a byte.
// Source: RFC 9112, sections 3 (request line), 4 (status line), 6.3 (length of a body), 7.1 (chunks).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

inline constexpr std::size_t kMostHeadBytes = 16384;
inline constexpr std::size_t kMostBodyBytes = 1U << 20U;

/// A status and the fields behind it.
struct HttpHead {
    int status = 0;
    std::vector<std::pair<std::string, std::string>> fields;  ///< names in small letters

    /// Of that name, in small letters; empty where there is none.
    [[nodiscard]] std::string_view find(std::string_view name) const noexcept;
};

/// Whether two ASCII texts differ in the size of letters at most.
[[nodiscard]] bool is_same_word(std::string_view a, std::string_view b) noexcept;

/// Of what stands before an answer's empty line; nothing where that is no head.
[[nodiscard]] std::optional<HttpHead> parse_http_head(std::string_view text);

/// Asks the service at 127.0.0.1:`port` for `path`, which begins with '/'.
[[nodiscard]] std::string make_http_get(std::string_view path, std::uint16_t port);

class HttpReader {
  public:
    enum class State : std::uint8_t { reading, done, broken };

    void feed(std::string_view bytes);
    /// The line is closed: nothing comes behind what came.
    void end();
    [[nodiscard]] State state() const noexcept { return state_; }
    [[nodiscard]] int status() const noexcept { return head_.status; }
    /// Whole when done.
    [[nodiscard]] const std::string& body() const noexcept { return body_; }

  private:
    void read_head();
    void read_body();
    void read_chunks();

    std::string buffer_;  // what came and is not taken
    HttpHead head_{};
    bool has_head_ = false;
    bool is_chunked_ = false;
    std::optional<std::size_t> length_;
    std::string body_;
    State state_ = State::reading;
};

}  // namespace fulcrum::runtime
