#include "tests/unit/runtime/progress/progress_fixture.h"

#include "runtime/progress/sqlite/sqlite_store.h"

#include <sqlite3.h>

#include <stdexcept>
#include <unistd.h>

namespace fulcrum::runtime::test {

TemporaryFolder::TemporaryFolder(On on)
    : ScratchFolder(on == On::memory && access("/dev/shm", W_OK) == 0
                        ? std::filesystem::path("/dev/shm")
                        : std::filesystem::temp_directory_path()) {}

std::size_t TemporaryFolder::entries() const {
    const std::filesystem::directory_iterator files(path());
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

Classroom::Classroom(const std::string& database_path) : path(database_path) {
    auto opened = open_sqlite_store(path);
    if (!opened) {
        throw std::runtime_error(to_sentence(opened.error()));
    }
    store = std::move(*opened);
    learner = {random_record_id(), "Mina", 500};
    session = {random_record_id(),
               learner.id,
               "gravity",
               "7f3a",
               "A1",
               1'000,
               {{"force_limit_N", "5"}, {"hand", "mouse"}}};
    if (!store->add_learner(learner) || !store->begin_session(session)) {
        throw std::runtime_error("the classroom can't be set up");
    }
}

AttemptRecord attempt_for(const RecordId& session, const std::string& question, int attempt,
                          bool right) {
    AttemptRecord record;
    record.id = random_record_id();
    record.session = session;
    record.question = question;
    record.attempt = attempt;
    record.said = right ? "the watermelon is the heaviest" : "the egg is the heaviest";
    record.meaning_right = right;
    record.form_right = right;
    record.slots = right ? "thing=watermelon" : "thing=egg";
    record.answer_s = 2.5;
    record.said_utc_ms = 1'500 + attempt;
    return record;
}

std::string error_text(const Expected<void>& result) {
    return result ? "" : to_sentence(result.error());
}

std::string refusal(const std::string& path, const SqliteStoreOptions& options) {
    const auto opened = open_sqlite_store(path, options);
    return opened ? "" : to_sentence(opened.error());
}

bool is_sentence_about(const std::string& text, const std::string& place) {
    return text.find(place) != std::string::npos && text.find('\n') == std::string::npos &&
           text.back() == '.';
}

namespace {

int first_cell(void* into, int columns, char** values, char** /*names*/) {
    auto& text = *static_cast<std::string*>(into);
    if (text.empty() && columns > 0 && values[0] != nullptr) {
        text = values[0];
    }
    return 0;
}

std::string execute(const std::string& path, const std::string& sql, std::string& cell) {
    sqlite3* raw = nullptr;
    const int opened = sqlite3_open_v2(path.c_str(), &raw, SQLITE_OPEN_READWRITE, nullptr);
    const std::unique_ptr<sqlite3, decltype(&sqlite3_close)> handle(raw, &sqlite3_close);
    if (opened != SQLITE_OK ||
        sqlite3_exec(raw, sql.c_str(), first_cell, &cell, nullptr) != SQLITE_OK) {
        return sqlite3_errmsg(raw);
    }
    return "";
}

}  // namespace

std::string run_sql(const std::string& path, const std::string& sql) {
    std::string ignored;
    return execute(path, sql, ignored);
}

std::string query(const std::string& path, const std::string& sql) {
    std::string cell;
    const std::string error = execute(path, sql, cell);
    return error.empty() ? cell : "error: " + error;
}

std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write_bytes(const std::string& path, const std::string& bytes) {
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace fulcrum::runtime::test
