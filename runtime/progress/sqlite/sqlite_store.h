// Progress in one sqlite file: write-ahead log, a sync before every acknowledgement, one
// transaction a record.
//
//   acknowledged(write)  ⇒  its frames in the log were synced  ⇒  kept after a kill and after a
//   power cut
//
// A database is looked at before it is opened for writing: one that is damaged, newer than the
// program or of another program is refused in one sentence and stays as it was, byte for byte. An
// older one is brought up in one transaction.
//
// Thread: as ProgressStore. Cost: opening checks the whole file (about 0.1 s for 50 MB).
// Source: the file formats and their guarantees, https://www.sqlite.org/wal.html and
// fileformat2.html.
#pragma once

#include "haptics/base/error.h"
#include "runtime/progress/store.h"

#include <cstdint>
#include <memory>
#include <string>

namespace fulcrum::runtime {

struct SqliteStoreOptions {
    enum class Synchronous : std::uint8_t {
        full,   ///< sync at every commit: an acknowledged write survives a power cut
        normal  ///< sync at checkpoints only: quicker, and loses after a power cut; to compare
                ///< with, never for learners
    };
    Synchronous synchronous = Synchronous::full;
    bool create =
        true;  ///< makes the file and its folders when there is none; false: refuse in one sentence
    int busy_timeout_ms = 5000;  ///< how long to wait for another program's write, 0 to 600 000
    std::string vfs;  ///< sqlite's file layer by its registered name; empty: the system's
};

/// Opens the learners' database at `path`, made with mode 0600 in folders of mode 0700 when there
/// is none. Errors are one sentence with the path: damaged, newer, of another program, folder or
/// file not writable, disk full, busy. The caller then plays with `make_null_store()`.
[[nodiscard]] Expected<std::unique_ptr<ProgressStore>> open_sqlite_store(
    const std::string& path, const SqliteStoreOptions& options = {});

}  // namespace fulcrum::runtime
