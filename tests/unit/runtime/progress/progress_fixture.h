// What tests of progress share: a folder that goes away, a class with one learner in one session,
// raw SQL.
#pragma once

#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/unit/runtime/rig.h"

namespace fulcrum::runtime::test {

/// A new folder, removed with all that is in it.
struct TemporaryFolder : ScratchFolder {
    /// In memory, where there is such a place, it is quick: for tests that play the disk themselves.
    enum class On : std::uint8_t { disk, memory };
    explicit TemporaryFolder(On on = On::disk);
    /// Files and folders that lie directly in it.
    [[nodiscard]] std::size_t entries() const;
};

/// A database with the learner "Mina", who has begun the lesson "gravity".
struct Classroom {
    explicit Classroom(const std::string& database_path);
    std::string path;
    std::unique_ptr<ProgressStore> store;
    Learner learner;
    SessionRecord session;
};

/// The same, in a folder that goes with it.
struct OwnFolder {
    TemporaryFolder folder;
};
struct OwnClassroom : private OwnFolder, public Classroom {
    OwnClassroom() : Classroom(folder.file("progress.db")) {}
};

/// An attempt with a new id and form as right as its meaning.
[[nodiscard]] AttemptRecord attempt_for(const RecordId& session, const std::string& question,
                                        int attempt, bool right);

/// The error as its sentence; "" when there is none.
[[nodiscard]] std::string error_text(const Expected<void>& result);

/// The sentence of a refused opening; "" when it opened.
[[nodiscard]] std::string refusal(const std::string& path, const SqliteStoreOptions& options = {});

/// True for one sentence that names the place: it ends in a full stop and has one line.
[[nodiscard]] bool is_sentence_about(const std::string& text, const std::string& place);

/// Runs SQL on a connection of its own; sqlite's message, "" when it went well.
std::string run_sql(const std::string& path, const std::string& sql);

/// The first column of the first row, as text.
[[nodiscard]] std::string query(const std::string& path, const std::string& sql);

/// All bytes of a file; "" when there is none.
[[nodiscard]] std::string bytes_of(const std::string& path);

void write_bytes(const std::string& path, const std::string& bytes);

}  // namespace fulcrum::runtime::test
