// A thin hold on sqlite for this folder alone: connections and statements that close themselves,
// errors as one exception that `guarded` turns into an Error at the folder's edge.
#pragma once

#include "haptics/base/error.h"

#include <sqlite3.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace fulcrum::runtime::sqlite {

/// What sqlite, or a rule of this folder, refused. Never leaves the folder.
class Refused final : public std::exception {
  public:
    explicit Refused(Error error, int code = SQLITE_ERROR)
        : error_(std::move(error)), code_(code) {}
    [[nodiscard]] const char* what() const noexcept override { return error_.message.c_str(); }
    [[nodiscard]] const Error& error() const noexcept { return error_; }
    /// sqlite's extended result code, or SQLITE_ERROR.
    [[nodiscard]] int code() const noexcept { return code_; }

  private:
    Error error_;
    int code_;
};

/// The sentence for one of sqlite's result codes; `text` is sqlite's own, of which one line is
/// taken.
[[nodiscard]] Error error_for(int code, const std::string& path, const std::string& text);

/// One connection.
class Database {
  public:
    /// Opens `path` with sqlite's flags through the file layer `vfs` (empty: the system's).
    /// `parameters` are appended to the file's URI, e.g. "immutable=1".
    Database(const std::string& path, int flags, const std::string& vfs,
             const char* parameters = "");

    /// Runs fixed SQL without results.
    void run(const char* sql);
    /// The one number that a query answers with.
    [[nodiscard]] std::int64_t number(const char* sql);
    /// Rows changed by the last INSERT.
    [[nodiscard]] int changes() const noexcept { return sqlite3_changes(handle_.get()); }
    [[nodiscard]] sqlite3* handle() const noexcept { return handle_.get(); }
    [[nodiscard]] const std::string& path() const noexcept { return path_; }
    /// Throws `Refused` where another file, or none, stands in its place: what is written then nobody reads again.
    void check_in_place() const;
    /// Throws `Refused` for a result code of this connection.
    [[noreturn]] void refuse(int code) const;

  private:
    struct Close {
        void operator()(sqlite3* handle) const noexcept { sqlite3_close_v2(handle); }
    };
    std::string path_;
    std::unique_ptr<sqlite3, Close> handle_;
};

/// One prepared statement; values go in and out by position, in order, and never become SQL.
class Statement {
  public:
    Statement(Database& database, const char* sql);

    /// Binds the next parameter.
    Statement& bind(std::string_view text);
    Statement& bind(std::int64_t number);
    Statement& bind(double number);
    Statement& bind(bool flag) { return bind(static_cast<std::int64_t>(flag)); }
    Statement& bind(const char* text) { return bind(std::string_view(text)); }
    Statement& bind(std::int32_t number) { return bind(static_cast<std::int64_t>(number)); }

    /// True when a row is there to be read.
    [[nodiscard]] bool step();
    /// Runs to the end.
    void run();

    /// The next column of the row.
    [[nodiscard]] std::string text();
    [[nodiscard]] std::int64_t number();
    [[nodiscard]] double real();
    [[nodiscard]] bool flag() { return number() != 0; }

  private:
    struct Finalize {
        void operator()(sqlite3_stmt* statement) const noexcept { sqlite3_finalize(statement); }
    };
    Database& database_;
    std::unique_ptr<sqlite3_stmt, Finalize> handle_;
    int parameter_ = 0;
    int column_ = 0;
};

/// All or nothing: rolled back unless `commit` returned.
class Transaction {
  public:
    enum class Kind : std::uint8_t { write, read };
    Transaction(Database& database, Kind kind);
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    ~Transaction();
    void commit();

  private:
    Database& database_;
    bool open_ = true;
};

/// Runs `work`; what it refuses becomes the failed side.
template <class Work>
auto guarded(Work&& work) -> Expected<decltype(work())> {
    try {
        if constexpr (std::is_void_v<decltype(work())>) {
            work();
            return {};
        } else {
            return work();
        }
    } catch (const Refused& refused) {
        return tl::unexpected<Error>(refused.error());
    }
}

}  // namespace fulcrum::runtime::sqlite
