#include "runtime/progress/queued_store.h"

#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/unit/runtime/progress/progress_fixture.h"
#include "tests/unit/runtime/progress/test_store.h"
#include "tests/unit/runtime/rig.h"

#include <condition_variable>
#include <mutex>

using namespace fulcrum::runtime::test;

namespace {

// What stands behind: a disk that stands still until it is let go, and refuses what it is told to.
struct Disk {
    std::mutex mutex;
    std::condition_variable moved;
    bool still = false;
    int refusals = 0;
    std::vector<std::string> order;  // every try
    std::vector<AttemptRecord> attempts;
    int begun = 0;  // writes that the disk was asked for

    void hold() {
        const std::lock_guard lock(mutex);
        still = true;
    }
    void let_go() {
        {
            const std::lock_guard lock(mutex);
            still = false;
        }
        moved.notify_all();
    }
    void await_write(int number) {
        std::unique_lock lock(mutex);
        moved.wait(lock, [&] { return begun >= number; });
    }
};

class DiskStore final : public TestStore {
  public:
    explicit DiskStore(Disk& disk) : disk_(disk) {}
    [[nodiscard]] Expected<void> add_attempt(const AttemptRecord& attempt) override {
        return begin_write(attempt.question).map([&] {
            const std::lock_guard lock(disk_.mutex);
            disk_.attempts.push_back(attempt);
        });
    }
    [[nodiscard]] Expected<ProgressData> read(const ProgressFilter& /*filter*/) override {
        const std::lock_guard lock(disk_.mutex);
        ProgressData kept;
        kept.attempts = disk_.attempts;
        return kept;
    }

  protected:
    Expected<void> begin_write(const std::string& what) override {
        std::unique_lock lock(disk_.mutex);
        ++disk_.begun;
        disk_.moved.notify_all();
        disk_.moved.wait(lock, [&] { return !disk_.still; });
        disk_.order.push_back(what);
        if (disk_.refusals > 0) {
            --disk_.refusals;
            return fail("the disk is full");
        }
        return {};
    }

  private:
    Disk& disk_;
};

std::unique_ptr<QueuedStore> on(Disk& disk, QueuedStoreSettings settings = {}) {
    return std::make_unique<QueuedStore>(std::make_unique<DiskStore>(disk), settings);
}

AttemptRecord numbered(int number) {
    return attempt_for(random_record_id(), "q" + std::to_string(number), 1, true);
}

void add(QueuedStore& store, int from, int to) {
    for (int i = from; i < to; ++i) {
        REQUIRE(store.add_attempt(numbered(i)));
    }
}

constexpr double kWhile_s = 60.0;  // longer than any machine hesitates

}  // namespace

TEST_CASE("queued store: a write is taken while the disk stands still, and kept once it moves") {
    Disk disk;
    disk.hold();
    const auto store = on(disk);
    add(*store, 0, 5);
    CHECK(store->status().taken == 5);
    CHECK(store->status().kept == 0);  // nothing is called kept before it is
    check_says(refusal_of(store->settle(0.0)), {"5 records"});
    disk.let_go();
    REQUIRE(store->settle(kWhile_s));
    CHECK(store->status().kept == 5);
    CHECK(disk.attempts.size() == 5);
    CHECK_FALSE(store->take_trouble());
}

TEST_CASE("queued store: the order of the writes is the order of the calls") {
    Disk disk;
    const auto store = on(disk);
    SessionRecord session;
    session.id = random_record_id();
    session.learner = random_record_id();
    session.lesson = "gravity";
    std::vector<std::string> order{"learner", "session"};
    REQUIRE(store->add_learner({session.learner, "Mina", 1}));
    REQUIRE(store->begin_session(session));
    for (int i = 0; i < 100; ++i) {
        REQUIRE(store->add_attempt(numbered(i)));
        order.push_back("q" + std::to_string(i));
    }
    REQUIRE(store->add_setting({session.id, "throat_heard", "1.20"}));
    order.emplace_back("setting");
    REQUIRE(store->add_hand_setting(
        {random_record_id(), session.learner, "mouse", "handed", "left", 1}));
    order.emplace_back("handed");
    SessionEnd end;
    end.session = session.id;
    REQUIRE(store->end_session(end));
    order.emplace_back("end");
    REQUIRE(store->settle(kWhile_s));
    CHECK(disk.order == order);
}

TEST_CASE("queued store: a refusal is tried again, then told once; the next ones are kept") {
    Disk disk;
    const auto store = on(disk);
    disk.refusals = 1;
    add(*store, 0, 1);
    REQUIRE(store->settle(kWhile_s));
    CHECK(disk.order == std::vector<std::string>{"q0", "q0"});
    CHECK_FALSE(store->take_trouble());

    disk.refusals = 2;
    add(*store, 1, 3);
    REQUIRE(store->settle(kWhile_s));
    const auto trouble = value_of(store->take_trouble());
    CHECK(trouble.message == "the disk is full");
    CHECK_FALSE(store->take_trouble());
    CHECK(store->status().kept == 2);
    CHECK(store->status().refused == 1);
    CHECK(disk.attempts.back().question == "q2");
}

TEST_CASE("queued store: a full queue refuses in one sentence, and takes again with room") {
    Disk disk;
    disk.hold();
    QueuedStoreSettings settings;
    settings.capacity = 3;
    const auto store = on(disk, settings);
    add(*store, 0, 3);
    check_says(refusal_of(store->add_attempt(numbered(3))), {"3 records"});
    CHECK(store->status().taken == 3);
    disk.let_go();
    REQUIRE(store->settle(kWhile_s));
    CHECK(store->add_attempt(numbered(3)));
    REQUIRE(store->settle(kWhile_s));
    CHECK(disk.attempts.size() == 4);
}

TEST_CASE("queued store: what can never be kept is refused at once and does not come to the disk") {
    Disk disk;
    const auto store = on(disk);
    AttemptRecord nameless = numbered(0);
    nameless.id = "no id";
    CHECK_FALSE(store->add_attempt(nameless));
    CHECK_FALSE(store->add_learner({}));
    CHECK_FALSE(store->begin_session({}));
    CHECK_FALSE(store->end_session({}));
    CHECK_FALSE(store->add_setting({random_record_id(), "", "1"}));
    REQUIRE(store->settle(kWhile_s));
    CHECK(disk.begun == 0);
}

TEST_CASE("queued store: reading and enrolling come after what was taken, or say they cannot") {
    Disk disk;
    QueuedStoreSettings settings;
    settings.patience_s = kWhile_s;
    auto store = on(disk, settings);
    add(*store, 0, 20);
    CHECK(store->read({})->attempts.size() == 20);
    CHECK(store->enrol("Mina")->nickname == "Mina");

    settings.patience_s = 0.0;
    Disk stuck;
    stuck.hold();
    const auto waiting = on(stuck, settings);
    add(*waiting, 0, 1);
    CHECK_FALSE(waiting->read({}));
    CHECK_FALSE(waiting->enrol("Mina"));
    stuck.let_go();
}

TEST_CASE("queued store: its end waits for what was taken in, and no longer than it was told to") {
    Disk disk;
    QueuedStoreSettings settings;
    settings.patience_s = kWhile_s;
    auto store = on(disk, settings);
    add(*store, 0, 50);
    store.reset();
    CHECK(disk.attempts.size() == 50);

    // With no patience the write under way comes to its end, and the others are left.
    settings.patience_s = std::numeric_limits<double>::quiet_NaN();
    disk.hold();
    auto hasty = on(disk, settings);
    add(*hasty, 0, 50);
    disk.await_write(51);
    std::thread ending([&] { hasty.reset(); });
    std::this_thread::yield();
    disk.let_go();
    ending.join();
    CHECK(disk.attempts.size() >= 51);
    CHECK(disk.attempts.size() <= 100);
}

TEST_CASE("queued store: before sqlite everything is kept once, also when it is handed in twice") {
    const TemporaryFolder folder;
    Classroom classroom(folder.file("progress.db"));
    const AttemptRecord attempt = attempt_for(classroom.session.id, "heaviest", 1, true);
    AttemptRecord other = attempt;
    other.said = "something else";
    {
        QueuedStore store(std::move(classroom.store));
        CHECK(store.keeps());
        for (int i = 0; i < 3; ++i) {
            REQUIRE(store.add_attempt(attempt));
        }
        REQUIRE(store.settle(kWhile_s));
        CHECK(store.status().kept == 3);
        REQUIRE(store.add_attempt(
            other));  // the same id with other content: told, and nothing is changed
        REQUIRE(store.settle(kWhile_s));
        CHECK(store.take_trouble());
        const auto data = value_of(store.read({}));
        REQUIRE(data.attempts.size() == 1);
        CHECK(data.attempts[0] == attempt);
    }
    CHECK(query(classroom.path, "SELECT count(*) FROM attempt") == "1");
}
