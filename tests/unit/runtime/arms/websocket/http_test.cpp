#include "runtime/arms/websocket/http.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using State = HttpReader::State;

HttpReader read_all(const std::string& answer) {
    HttpReader reader;
    for (const char byte : answer) {
        reader.feed({&byte, 1});
    }
    return reader;
}

}  // namespace

TEST_CASE("http: a GET names path, host and port, and asks for the line to be closed") {
    CHECK(make_http_get("/version", 10001) ==
          "GET /version HTTP/1.1\r\nHost: 127.0.0.1:10001\r\nAccept: application/json\r\n"
          "Connection: close\r\n\r\n");
}

TEST_CASE("http: a body ends by its length, its last chunk, or the end of the line") {
    const HttpReader counted =
        read_all("HTTP/1.1 200 OK\r\ncontent-LENGTH:  4 \r\n\r\n{ok}and what is no part of it");
    CHECK(counted.state() == State::done);
    CHECK(counted.status() == 200);
    CHECK(counted.body() == "{ok}");

    const HttpReader chunked = read_all(
        "HTTP/1.1 200 OK\r\nTransfer-Encoding: Chunked\r\n\r\n4;of=it\r\n{\"a\"\r\n"
        "3\r\n:1}\r\n0\r\n\r\n");
    CHECK(chunked.state() == State::done);
    CHECK(chunked.body() == "{\"a\":1}");

    HttpReader open = read_all("HTTP/1.0 404 Not Found\r\nServer: it\r\n\r\nnothing here");
    CHECK(open.state() == State::reading);
    open.end();
    CHECK(open.state() == State::done);
    CHECK(open.status() == 404);
    CHECK(open.body() == "nothing here");

    CHECK(read_all("HTTP/1.1 204 No Content\r\nContent-Length: 0\r\n\r\n").state() == State::done);
}

TEST_CASE("http: what is no answer, or is cut off, or too large, is broken") {
    for (const char* no_answer :
         {"hello\r\n\r\n", "HTTP/1.1 x00 OK\r\n\r\n", "HTTP/2 200 OK\r\n\r\n",
          "HTTP/1.1 200 OK\r\nno field\r\n\r\n", "HTTP/1.1 200 OK\r\nContent-Length: -1\r\n\r\n",
          "HTTP/1.1 200 OK\r\nContent-Length: 1048577\r\n\r\n",
          "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\n"}) {
        CAPTURE(no_answer);
        CHECK(read_all(no_answer).state() == State::broken);
    }
    for (const char* cut_off :
         {"HTTP/1.1 200 OK\r\nContent-Length: 9\r\n\r\n{", "HTTP/1.1 200 OK\r\nServer: it",
          "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n4\r\n{"}) {
        CAPTURE(cut_off);
        HttpReader reader = read_all(cut_off);
        CHECK(reader.state() == State::reading);
        reader.end();
        CHECK(reader.state() == State::broken);
    }
    HttpReader endless;
    endless.feed("HTTP/1.1 200 OK\r\n\r\n" + std::string(kMostBodyBytes + 1, 'x'));
    CHECK(endless.state() == State::broken);
    HttpReader head;
    head.feed(std::string(kMostHeadBytes + 1, 'h'));
    CHECK(head.state() == State::broken);
}

}  // namespace fulcrum::runtime
