// Where the database lies, and how its place is made.
#include "runtime/progress/database_path.h"

#include "tests/unit/runtime/progress/progress_fixture.h"
#include "tests/unit/runtime/rig.h"

#include <sys/stat.h>

using namespace fulcrum::runtime::test;

namespace {

// Sets a variable of the environment, or takes it away, and puts it back at the end.
class Variable {
  public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* old = std::getenv(name)) {
            old_ = old;
        }
        value == nullptr ? unsetenv(name) : setenv(name, value, 1);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;
    ~Variable() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }

  private:
    const char* name_;
    std::optional<std::string> old_;
};

}  // namespace

TEST_CASE("database path: XDG_DATA_HOME, else the home folder; relative ones don't count") {
    const Variable home("HOME", "/pupils/mina");
    {
        const Variable data("XDG_DATA_HOME", "/data");
        CHECK(default_database_path() == "/data/fulcrum/progress.db");
    }
    {
        const Variable data("XDG_DATA_HOME", nullptr);
        CHECK(default_database_path() == "/pupils/mina/.local/share/fulcrum/progress.db");
    }
    for (const char* useless : {"", "relative/data"}) {
        const Variable data("XDG_DATA_HOME", useless);
        CHECK(default_database_path() == "/pupils/mina/.local/share/fulcrum/progress.db");
    }
    const Variable data("XDG_DATA_HOME", nullptr);
    const Variable no_home("HOME", "relative");
    CHECK_FALSE(default_database_path());
}

TEST_CASE("database path: the file and its folders are private, and what exists is left alone") {
    const TemporaryFolder folder;
    const std::string path = folder.file("a/b/progress.db");
    REQUIRE(create_private_file(path));
    struct stat status {};
    REQUIRE(stat(path.c_str(), &status) == 0);
    CHECK((status.st_mode & 0777U) == 0600);
    REQUIRE(stat(folder.file("a").c_str(), &status) == 0);
    CHECK((status.st_mode & 0777U) == 0700);
    write_bytes(path, "kept");
    REQUIRE(create_private_file(path));
    CHECK(bytes_of(path) == "kept");
}
