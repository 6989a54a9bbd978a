#include "runtime/progress/sqlite/database.h"

#include "runtime/progress/text_rules.h"

#include <algorithm>

namespace fulcrum::runtime::sqlite {
namespace {

// A path inside a file: URI; everything that could end the path or be an escape is escaped.
std::string uri_for(const std::string& path, const char* parameters) {
    constexpr const char* kDigits = "0123456789ABCDEF";
    std::string uri = "file:";
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '%' || c == '?' || c == '#' || byte < 0x21 || byte > 0x7E) {
            uri += {'%', kDigits[byte >> 4U], kDigits[byte & 0x0FU]};
        } else {
            uri += c;
        }
    }
    return *parameters == '\0' ? uri : uri + '?' + parameters;
}

// sqlite's text may quote a damaged file's bytes, over many lines.
std::string one_line(const std::string& text) {
    constexpr std::size_t kLongest = 120;
    return kept_text(text.substr(0, std::min(text.find('\n'), kLongest)));
}

}  // namespace

Error error_for(int code, const std::string& path, const std::string& text) {
    const std::string detail = one_line(text);
    constexpr const char* kElsewhere = "choose another file with --db or move this one away";
    switch (code & 0xFF) {
        case SQLITE_NOTADB:
            return {"this is not a database of learners' progress", path, kElsewhere};
        case SQLITE_CORRUPT:
            return {"the database is damaged (" + detail + ")", path, kElsewhere};
        case SQLITE_FULL:
            return {"the disk is full, so this was not kept", path,
                    "free some space and try again"};
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return {"another program is writing to the database", path, "close it and try again"};
        case SQLITE_READONLY:
        case SQLITE_PERM:
        case SQLITE_CANTOPEN:
            return {"the database can't be opened for writing (" + detail + ")", path,
                    "make the file and its folder writable, or choose another file with --db"};
        case SQLITE_IOERR:
            return {"the disk refused to read or write (" + detail + ", code " +
                        std::to_string(code) + ")",
                    path, "check the disk, or choose another file with --db"};
        case SQLITE_NOMEM:
            return {"there is no memory left for the database", path, "close other programs"};
        default:
            return {"the database refused this (" + detail + ")", path, "report this sentence"};
    }
}

Database::Database(const std::string& path, int flags, const std::string& vfs,
                   const char* parameters)
    : path_(path) {
    sqlite3* handle = nullptr;
    const int code =
        sqlite3_open_v2(uri_for(path, parameters).c_str(), &handle,
                        flags | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE,
                        vfs.empty() ? nullptr : vfs.c_str());
    handle_.reset(handle);
    if (code != SQLITE_OK) {
        refuse(code);
    }
}

void Database::refuse(int code) const {
    const char* detail = handle_ ? sqlite3_errmsg(handle_.get()) : sqlite3_errstr(code);
    throw Refused(error_for(code, path_, detail), code);
}

void Database::run(const char* sql) {
    const int code = sqlite3_exec(handle_.get(), sql, nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) {
        refuse(code);
    }
}

std::int64_t Database::number(const char* sql) {
    Statement statement(*this, sql);
    return statement.step() ? statement.number() : 0;
}

Statement::Statement(Database& database, const char* sql) : database_(database) {
    sqlite3_stmt* handle = nullptr;
    const int code = sqlite3_prepare_v2(database.handle(), sql, -1, &handle, nullptr);
    if (code != SQLITE_OK) {
        database.refuse(code);
    }
    handle_.reset(handle);
}

Statement& Statement::bind(std::string_view text) {
    // An empty view may hold a null pointer, which sqlite would take for NULL.
    const char* bytes = text.empty() ? "" : text.data();
    const int code = sqlite3_bind_text64(handle_.get(), ++parameter_, bytes, text.size(),
                                         SQLITE_TRANSIENT, SQLITE_UTF8);
    if (code != SQLITE_OK) {
        database_.refuse(code);
    }
    return *this;
}

Statement& Statement::bind(std::int64_t number) {
    if (const int code = sqlite3_bind_int64(handle_.get(), ++parameter_, number);
        code != SQLITE_OK) {
        database_.refuse(code);
    }
    return *this;
}

Statement& Statement::bind(double number) {
    if (const int code = sqlite3_bind_double(handle_.get(), ++parameter_, number);
        code != SQLITE_OK) {
        database_.refuse(code);
    }
    return *this;
}

bool Statement::step() {
    column_ = 0;
    const int code = sqlite3_step(handle_.get());
    if (code != SQLITE_ROW && code != SQLITE_DONE) {
        database_.refuse(code);
    }
    return code == SQLITE_ROW;
}

void Statement::run() {
    while (step()) {
    }
}

std::string Statement::text() {
    const int column = column_++;
    const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(handle_.get(), column));
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column));
    return bytes == nullptr ? std::string{} : std::string(bytes, size);
}

std::int64_t Statement::number() {
    return sqlite3_column_int64(handle_.get(), column_++);
}

double Statement::real() {
    return sqlite3_column_double(handle_.get(), column_++);
}

void Database::check_in_place() const {
    int has_moved = 0;  // stays so where the file layer cannot tell
    sqlite3_file_control(handle_.get(), "main", SQLITE_FCNTL_HAS_MOVED, &has_moved);
    if (has_moved != 0) {
        throw Refused(
            {"the database was removed or replaced while it was in use, so this was not "
             "kept",
             path_, "put it back and begin again"});
    }
}

Transaction::Transaction(Database& database, Kind kind) : database_(database) {
    if (kind == Kind::write) {
        database_.check_in_place();
    }
    database_.run(kind == Kind::write ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
    // After some errors sqlite has rolled back by itself; a second one would only be refused.
    if (open_ && sqlite3_get_autocommit(database_.handle()) == 0) {
        sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
    }
}

void Transaction::commit() {
    database_.run("COMMIT");
    open_ = false;
}

}  // namespace fulcrum::runtime::sqlite
