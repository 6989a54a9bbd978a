#include "runtime/arms/websocket/http_query.h"

#include "haptics/base/clock.h"

namespace fulcrum::runtime {

void HttpQuery::begin(std::string_view path, std::uint16_t port, double deadline_s) {
    line_ = LoopbackSocket::begin(port);
    unsent_ = make_http_get(path, port);
    reader_ = {};
    deadline_s_ = deadline_s;
    state_ = line_.is_open() ? State::waits : State::failed;
}

HttpQuery::State HttpQuery::step() {
    return go_on(0.0);
}

// Waits until `until_s` at most for each of its parts.
HttpQuery::State HttpQuery::go_on(double until_s) {
    if (state_ != State::waits) {
        return state_;
    }
    if (!unsent_.empty()) {
        unsent_.erase(0, line_.send(unsent_, until_s));
    }
    std::string received;
    while (unsent_.empty() && reader_.state() == HttpReader::State::reading) {
        received.clear();
        const auto got = line_.receive(received, until_s);
        if (got == LoopbackSocket::Received::nothing) {
            break;
        }
        reader_.feed(received);
        if (got == LoopbackSocket::Received::closed) {
            reader_.end();
        }
    }
    if (reader_.state() == HttpReader::State::done) {
        state_ = State::done;
    } else if (reader_.state() == HttpReader::State::broken || !line_.is_open() ||
               monotonic_now_s() >= deadline_s_) {
        state_ = State::failed;
    }
    if (state_ != State::waits) {
        line_.close();
    }
    return state_;
}

Expected<HttpAnswer> ask_http(std::string_view path, std::uint16_t port, double deadline_s) {
    HttpQuery query;
    query.begin(path, port, deadline_s);
    while (query.go_on(deadline_s) == HttpQuery::State::waits) {
    }
    if (query.state() == HttpQuery::State::failed) {
        return fail("nobody answers there", "127.0.0.1:" + std::to_string(port));
    }
    return query.answer();
}

}  // namespace fulcrum::runtime
