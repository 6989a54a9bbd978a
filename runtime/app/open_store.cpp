#include "runtime/app/open_store.h"

#include "runtime/progress/database_path.h"
#include "runtime/progress/queued_store.h"
#include "runtime/progress/sqlite/sqlite_store.h"

#include <cstdio>
#include <utility>

namespace fulcrum::runtime {
namespace {

Expected<std::unique_ptr<ProgressStore>> open_store(const std::string& database) {
    if (!database.empty()) {
        return open_sqlite_store(database);
    }
    const auto path = default_database_path();
    if (!path) {
        return tl::unexpected(path.error());
    }
    return open_sqlite_store(*path);
}

}  // namespace

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
