#include "runtime/app/open_store.h"

#include "runtime/files/other_writers.h"
#include "runtime/progress/database_path.h"
#include "runtime/progress/queued_store.h"
#include "runtime/progress/sqlite/sqlite_store.h"

#include <cstdio>
#include <sys/stat.h>
#include <utility>

namespace fulcrum::runtime {
namespace {

// Learners' answers that others may change or read are made their owner's alone, and that is said.
void keep_private(const std::string& database) {
    struct stat about {};
    constexpr mode_t kOthers = S_IRWXG | S_IRWXO;
    const bool is_open = ::stat(database.c_str(), &about) == 0 && (about.st_mode & kOthers) != 0;
    if (is_open && ::chmod(database.c_str(), about.st_mode & 07777U & ~kOthers) == 0) {
        std::fprintf(stderr,
                     "%s: others could read or change what learners did; now only you can.\n",
                     database.c_str());
    }
    if (const auto others = find_other_writers(database)) {
        std::fprintf(stderr,
                     "%s: %s, so whoever likes can change what learners did; take that away (chmod "
                     "go-w), or keep it elsewhere with --db.\n",
                     database.c_str(), others->c_str());
    }
}

}  // namespace

Expected<std::unique_ptr<ProgressStore>> open_store(const std::string& database) {
    const auto path = database.empty() ? default_database_path() : Expected<std::string>(database);
    if (!path) {
        return tl::unexpected(path.error());
    }
    keep_private(*path);
    return open_sqlite_store(*path);
}

std::unique_ptr<ProgressStore> open_store_or_none(const std::string& database) {
    auto store = open_store(database);
    if (store) {
        return std::move(*store);
    }
    std::fprintf(stderr, "%s The lesson is played without keeping progress.\n",
                 to_sentence(store.error()).c_str());
    return make_null_store();
}

std::unique_ptr<ProgressStore> open_store_beside_window(const std::string& database) {
    auto store = open_store_or_none(database);
    if (!store->keeps()) {
        return store;  // no disk, no thread
    }
    return std::make_unique<QueuedStore>(std::move(store));
}

}  // namespace fulcrum::runtime
