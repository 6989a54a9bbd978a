#include "runtime/lua/process/turn_taking.h"

#include <catch2/catch.hpp>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

using namespace fulcrum::runtime;

namespace {

// Another process that waits to be killed.
class Waiting {
  public:
    Waiting() : id_(::fork()) {
        while (id_ == 0) {
            ::pause();
        }
    }
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;
    ~Waiting() { end(); }
    void end() {
        if (id_ > 0) {
            ::kill(id_, SIGKILL);
            ::waitpid(id_, nullptr, 0);
            id_ = -1;
        }
    }
    [[nodiscard]] pid_t id() const { return id_; }

  private:
    pid_t id_;
};

cpu_set_t affinity_of(pid_t process) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CHECK(::sched_getaffinity(process, sizeof set, &set) == 0);
    return set;
}

bool same(const cpu_set_t& a, const cpu_set_t& b) {
    return CPU_EQUAL(&a, &b) != 0;
}

}  // namespace

TEST_CASE("turn taking: both are on one processor while they take turns, and free again after it") {
    const cpu_set_t before = affinity_of(0);
    Waiting other;
    const cpu_set_t others = affinity_of(other.id());
    {
        TurnTaking turns(other.id());
        CHECK_FALSE(turns.is_together());
        CHECK(same(affinity_of(0), before));
        for (int i = 0; i < TurnTaking::kTurns; ++i) {
            turns.turn();
        }
        CHECK(turns.is_together());
        const cpu_set_t here = affinity_of(0);
        CHECK(CPU_COUNT(&here) == 1);
        CHECK(same(affinity_of(other.id()), here));
        CHECK(CPU_ISSET(::sched_getcpu(), &here));
    }
    CHECK(same(affinity_of(0), before));
    CHECK(same(affinity_of(other.id()), others));
}

TEST_CASE("turn taking: one that is gone, or was never there, changes nothing for long") {
    const cpu_set_t before = affinity_of(0);
    Waiting other;
    {
        TurnTaking turns(other.id());
        other.end();
        for (int i = 0; i < 4 * TurnTaking::kTurns; ++i) {
            turns.turn();
        }
        TurnTaking nobody(-1);
        for (int i = 0; i < 4 * TurnTaking::kTurns; ++i) {
            nobody.turn();
        }
        CHECK_FALSE(nobody.is_together());
    }
    CHECK(same(affinity_of(0), before));
}
