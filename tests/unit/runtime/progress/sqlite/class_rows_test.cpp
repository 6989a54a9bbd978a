// What is kept of classes, in a database.
#include "runtime/progress/queued_store.h"
#include "runtime/progress/report.h"
#include "runtime/progress/report_text.h"
#include "runtime/progress/sqlite/database.h"
#include "runtime/progress/sqlite/schema.h"
#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/unit/runtime/progress/progress_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;
using namespace fulcrum::runtime::sqlite;

namespace {

const PupilPictures kPictures{{"apple", "kite"}, "egg"};

// A class with one pupil, shown as names.
ClassRows rows_with(const Learner& learner) {
    ClassRows rows;
    rows.classes.push_back({random_record_id(), "4b", 1});
    rows.settings.push_back({random_record_id(), rows.classes[0].id, kShownAs, "names", 2});
    rows.cards.push_back({random_record_id(), rows.classes[0].id, learner.id, kPictures, 3});
    return rows;
}

void check_kept(const ClassRows& kept, const ClassRows& rows, const Learner& learner) {
    CHECK(kept.classes == rows.classes);
    CHECK(kept.settings == rows.settings);
    CHECK(kept.cards == rows.cards);
    CHECK(kept.pupils == std::vector{learner});
}

}  // namespace

TEST_CASE("classes: what is kept is read back by another program, as it was") {
    OwnClassroom room;
    const ClassRows rows = rows_with(room.learner);
    REQUIRE(room.store->add_class_rows(rows));
    check_kept(value_of(room.store->read_classes()), rows, room.learner);
    check_kept(value_of(value_of(open_sqlite_store(room.path))->read_classes()), rows,
               room.learner);
    QueuedStore queued(value_of(open_sqlite_store(room.path)));
    check_kept(value_of(queued.read_classes()), rows, room.learner);
}

TEST_CASE("classes: a repeated write leaves one row, other content under its id is refused") {
    OwnClassroom room;
    const ClassRows rows = rows_with(room.learner);
    REQUIRE(room.store->add_class_rows(rows));
    CHECK(room.store->add_class_rows(rows));
    check_kept(value_of(room.store->read_classes()), rows, room.learner);
    const auto refused = [&](auto change) {
        ClassRows other = rows;
        change(other);
        check_says(error_text(room.store->add_class_rows(other)), {"under this id"});
        check_kept(value_of(room.store->read_classes()), rows, room.learner);
    };
    refused([](ClassRows& other) { other.classes[0].made_utc_ms = 9; });
    refused([](ClassRows& other) { other.settings[0].value = "pictures"; });
    refused([](ClassRows& other) { other.cards[0].pictures.secret = "star"; });
}

TEST_CASE("classes: a class is kept whole or not at all") {
    OwnClassroom room;
    ClassRows rows = rows_with(room.learner);
    rows.cards.push_back(
        {random_record_id(), rows.classes[0].id, random_record_id(), kPictures, 3});
    check_says(error_text(room.store->add_class_rows(rows)), {"the learner", "is not known"});
    CHECK(room.store->read_classes()->classes.empty());
    CHECK(room.store->read_classes()->cards.empty());
    rows.cards[1] = {random_record_id(), random_record_id(), room.learner.id, kPictures, 3};
    check_says(error_text(room.store->add_class_rows(rows)), {"the class", "is not known"});
    rows.cards.pop_back();
    rows.settings[0].class_id = random_record_id();
    check_says(error_text(room.store->add_class_rows(rows)), {"the class", "is not known"});
    CHECK(room.store->read_classes()->classes.empty());
}

TEST_CASE("classes: no two have one name, whatever its capitals") {
    OwnClassroom room;
    REQUIRE(room.store->add_class_rows(rows_with(room.learner)));
    ClassRows second = rows_with(room.learner);
    second.classes[0].name = "4B";
    check_says(error_text(room.store->add_class_rows(second)), {"another class", "4B"});
    CHECK(room.store->read_classes()->classes.size() == 1);
}

TEST_CASE("classes: rows can't be changed, even by SQL, and go with their learner") {
    OwnClassroom room;
    const ClassRows rows = rows_with(room.learner);
    REQUIRE(room.store->add_class_rows(rows));
    for (const char* change :
         {"UPDATE class SET name = 'x'", "UPDATE class_setting SET value = 'pictures'",
          "UPDATE class_card SET secret = 'star'"}) {
        check_says(run_sql(room.path, change), {"never changed"});
    }
    check_kept(value_of(room.store->read_classes()), rows, room.learner);
    for (const char* bad : {"'apple', 'apple', 'egg'", "'apple', 'egg', 'egg'"}) {
        const std::string insert =
            std::string("INSERT INTO class_card SELECT 9, hex(zeroblob(16)), class, learner, ") +
            bad + ", 1 FROM class_card";
        check_says(run_sql(room.path, insert), {"CHECK"});
    }
    REQUIRE(run_sql(room.path, "PRAGMA foreign_keys = ON; DELETE FROM learner").empty());
    CHECK(room.store->read_classes()->cards.empty());
    CHECK(room.store->read_classes()->classes == rows.classes);
}

TEST_CASE("classes: version 7 gets room for them and keeps every fact; a report reads it") {
    const TemporaryFolder folder;
    const std::string path = folder.file("progress.db");
    const std::string id(32, 'a');
    {
        Database database(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "");
        for (std::size_t step = 0; step < 7; ++step) {
            database.run(migrations()[step]);
        }
        database.run("PRAGMA application_id = 0x46756C63; PRAGMA user_version = 7");
        Statement(database, "INSERT INTO learner VALUES(1, ?, 'guest', 5)").bind(id).run();
        Statement(database, "INSERT INTO session VALUES(1, ?, ?, 'gravity', 'v', 'A1', 6)")
            .bind(id)
            .bind(id)
            .run();
    }
    const auto store = value_of(open_sqlite_store(path));
    CHECK(query(path, "PRAGMA user_version") == "8");
    CHECK(query(path, "PRAGMA integrity_check") == "ok");
    CHECK(store->read_classes()->classes.empty());
    const Learner guest = value_of(store->enrol("guest"));
    CHECK(guest == Learner{id, "guest", 5});
    REQUIRE(store->add_class_rows(rows_with(guest)));
    const auto report = value_of(make_report(*store));
    REQUIRE(report.learners.size() == 1);
    CHECK(report.learners[0].guests == 0);  // all guests of earlier versions stay one learner
    check_says(to_text(report), {"gravity: played once"});
}
