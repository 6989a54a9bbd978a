#include "runtime/evidence/replay_check.h"

#include "haptics/device/replay/recorded_traits.h"
#include "haptics/math/length.h"
#include "runtime/evidence/record_words.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <span>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kMostNamed = 3;  // facts of one kind that are told one by one
constexpr const char* kToldByRecord =
    " The run kept real time; what lesson and world said in each round was taken from the record.";

bool was_in_real_time(const Record& record) {
    return find_fact(record.header, kClockFact) == kRealTime;
}

// Rounds that the recorder was not in time for.
std::uint64_t count_lost(const Record& record) {
    const auto& samples = record.samples;
    return samples.empty() ? 0 : samples.back().tick + 1 - samples.size();
}

bool is_of_tool(const ReplayReport& report) {
    return report.first == Difference::effect &&
           (report.effect.starts_with("tool") || report.effect == "texture");
}

// Bits, not values: a zero with another sign or a NaN would be another run.
bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(const Vector3& a, const Vector3& b) {
    return same_bits(a.x(), b.x()) && same_bits(a.y(), b.y()) && same_bits(a.z(), b.z());
}

bool same_bits(const Wrench& a, const Wrench& b) {
    return same_bits(a.force, b.force) && same_bits(a.torque, b.torque);
}

bool same_bits(const Pose& a, const Pose& b) {
    return same_bits(a.position, b.position) && same_bits(a.orientation.w(), b.orientation.w()) &&
           same_bits(Vector3(a.orientation.vec()), Vector3(b.orientation.vec()));
}

std::string newtons_text(const Vector3& force_W) {
    const double newtons = compute_length(force_W);
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.6g N", newtons);
    return text.data() + (newtons > 0.0 ? " " + direction_words(force_W) : std::string());
}

std::string torque_text(const Vector3& torque_W) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.6g Nm", compute_length(torque_W));
    return text.data();
}

// "it gives A where it gave B, C apart"; by the torque where the forces are the same.
std::string apart_text(const ReplayReport& report) {
    const bool by_torque = same_bits(report.is_W.force, report.was_W.force);
    const auto text = [&](const Wrench& w) {
        return by_torque ? torque_text(w.torque) : newtons_text(w.force);
    };
    const Wrench apart{report.is_W.force - report.was_W.force,
                       report.is_W.torque - report.was_W.torque};
    std::array<char, 64> by{};
    std::snprintf(by.data(), by.size(), "%.3g %s",
                  compute_length(by_torque ? apart.torque : apart.force), by_torque ? "Nm" : "N");
    return text(report.is_W) + " where it was " + text(report.was_W) + ", " + by.data() + " apart";
}

struct Kind {
    std::string_view prefix;
    const char* one;    // what differs, before the names
    bool tells_values;  // a hash says nothing to people
};
constexpr std::array<Kind, 6> kKinds{{{"program.", "the program is another one", true},
                                      {"lesson.", "the lesson's files have changed", false},
                                      {"asset.", "models or pictures have changed", false},
                                      {"option.", "options differ", true},
                                      {"limit.", "limits differ", true},
                                      {"workspace.", "the workspace differs", true}}};
constexpr Kind kPlan{"plan.", "the plan differs", true};

// A run in real time is repeated under a virtual clock, by what the record tells.
bool is_compared(std::string_view name) {
    return name != "option.hand" && name != "program.build" && name != kClockFact;
}

const RecordFact* find_same(const RecordHeader& header, const std::string& name) {
    const auto found = std::ranges::find(header.facts, name, &RecordFact::name);
    return found == header.facts.end() ? nullptr : &*found;
}

// "(seed is 2 and was 1)"; empty where no fact of the kind differs.
std::string differing(const Kind& kind, const RecordHeader& record, const RecordHeader& now) {
    std::vector<std::string> names;
    for (const RecordFact& was : record.facts) {
        const RecordFact* const is = find_same(now, was.name);
        if (!was.name.starts_with(kind.prefix) || !is_compared(was.name) || is == nullptr ||
            is->value == was.value) {
            continue;
        }
        const std::string name = was.name.substr(kind.prefix.size());
        names.push_back(kind.tells_values ? name + " is " + is->value + " and was " + was.value
                                          : name);
    }
    if (names.empty()) {
        return {};
    }
    std::string text = std::string(kind.one) + " (" + names.front();
    for (std::size_t i = 1; i < std::min(names.size(), kMostNamed); ++i) {
        text += ", " + names[i];
    }
    if (names.size() > kMostNamed) {
        text += " and " + std::to_string(names.size() - kMostNamed) + " more";
    }
    return text + ")";
}

// Where no force differs in the first so many rounds.
std::string tell_same(const Record& record, std::uint64_t n_compared) {
    const std::string n = std::to_string(n_compared);
    const std::string n_all = std::to_string(record.samples.size());
    if (record.cut_off) {
        return "In " + n +
               " rounds of the record the forces are the same, bit for bit, but there " +
               "is no more of it to be read: " + record.fault + ".";
    }
    return n_compared < record.samples.size()
               ? "In " + n + " of " + n_all + " rounds of the record the forces are the same, " +
                     "bit for bit; the others were not repeated."
               : "All forces are the record's, bit for bit, in " + n_all + " rounds.";
}

}  // namespace

bool tells_all(const Record& record) {
    return record.version >= kFirstToldVersion && was_in_real_time(record);
}

std::string explain_difference(const RecordHeader& record, const RecordHeader& now) {
    std::string text;
    const auto add = [&](const std::string& clause) {
        if (!clause.empty()) {
            text += (text.empty() ? "" : "; ") + clause;
        }
    };
    for (const Kind& kind : kKinds) {
        add(differing(kind, record, now));
    }
    // What the plan decided follows from the rest; it is told where nothing else explains it.
    if (text.empty()) {
        add(differing(kPlan, record, now));
    }
    // Another build need not compute anything else, so it is named last.
    const RecordFact* const was = find_same(record, "program.build");
    const RecordFact* const is = find_same(now, "program.build");
    if (was != nullptr && is != nullptr && was->value != is->value) {
        add("the program was built anew since");
    }
    return text;
}

ReplayCheck::ReplayCheck(std::shared_ptr<const Record> record, RecordHeader header)
    : record_(std::move(record)),
      header_(std::move(header)),
      has_same_effects_(record_->header.effects == header_.effects) {}

void ReplayCheck::take(const RecordRound& round) {
    // Rounds that the recorder lost leave gaps; the run goes on in ticks.
    const auto at =
        std::ranges::lower_bound(record_->samples, round.sample.tick, {}, &RecordSample::tick);
    if (at == record_->samples.end() || at->tick != round.sample.tick) {
        return;
    }
    ++report_.n_compared;
    if (!same_bits(at->applied_W, round.sample.applied_W)) {
        ++report_.n_different;
        report_.most_N =
            std::max(report_.most_N,
                     compute_length(Vector3(at->applied_W.force - round.sample.applied_W.force)));
    }
    if (report_.same()) {
        find_first(round, static_cast<std::size_t>(at - record_->samples.begin()));
    }
}

void ReplayCheck::differ(Difference what, const RecordSample& at, const Wrench& is_W,
                         const Wrench& was_W, std::string effect) {
    report_.first = what;
    report_.tick = at.tick;
    report_.time_s = at.time_s;
    report_.is_W = is_W;
    report_.was_W = was_W;
    report_.effect = std::move(effect);
}

void ReplayCheck::find_first(const RecordRound& round, std::size_t i) {
    const RecordSample& was = record_->samples[i];
    const RecordSample& is = round.sample;
    if (!same_bits(was.time_s, is.time_s)) {
        return differ(Difference::time, was, is.applied_W, was.applied_W);
    }
    if (!same_bits(was.pose_D, is.pose_D) || was.buttons != is.buttons) {
        return differ(Difference::hand, was, is.applied_W, was.applied_W);
    }
    if (has_same_effects_) {
        const auto shares_W = record_->shares_of(i);
        for (std::size_t k = 0; k < shares_W.size(); ++k) {
            if (!same_bits(shares_W[k], round.shares.each_W[k])) {
                return differ(Difference::effect, was, round.shares.each_W[k], shares_W[k],
                              header_.effects[k]);
            }
        }
    }
    if (!same_bits(was.commanded_W, is.commanded_W)) {
        return differ(Difference::commanded, was, is.commanded_W, was.commanded_W);
    }
    if (!same_bits(was.applied_W, is.applied_W)) {
        return differ(Difference::applied, was, is.applied_W, was.applied_W);
    }
    if (was.faults != is.faults || was.gate != is.gate) {
        differ(Difference::state, was, is.applied_W, was.applied_W);
    }
}

std::string ReplayCheck::sentence() const {
    if (report_.n_compared == 0) {
        return "No round of the record was repeated, so no force was compared.";
    }
    if (report_.same()) {
        return tell_same(*record_, report_.n_compared) + (tells_all(*record_) ? kToldByRecord : "");
    }
    std::array<char, 64> when{};
    std::snprintf(when.data(), when.size(), "At %.4f s (round %llu) ", report_.time_s,
                  static_cast<unsigned long long>(report_.tick));
    std::string text = when.data();
    switch (report_.first) {
        case Difference::effect:
            text += "the share of " + report_.effect +
                    " is the first thing that differs from the record: " + apart_text(report_);
            break;
        case Difference::commanded:
            text += "the commanded force is the first thing that differs from the record: " +
                    apart_text(report_);
            break;
        case Difference::applied:
            text +=
                "the force that the gate let through is the first thing that differs from the "
                "record: " +
                apart_text(report_);
            break;
        case Difference::state:
            text += "the gate's phase or a fault is the first thing that differs from the record";
            break;
        case Difference::hand:
            text += "the hand is the first thing that differs from the record";
            break;
        default:
            text += "the clock is the first thing that differs from the record";
            break;
    }
    std::array<char, 128> extent{};
    std::snprintf(extent.data(), extent.size(),
                  "; the applied force differs in %llu of %llu rounds, by up to %.3g N.",
                  static_cast<unsigned long long>(report_.n_different),
                  static_cast<unsigned long long>(report_.n_compared), report_.most_N);
    return text + extent.data() + explain();
}

std::string ReplayCheck::explain() const {
    const Record& record = *record_;
    if (was_in_real_time(record) && !tells_all(record)) {
        return " The run kept real time, and a record of version " +
               std::to_string(record.version) +
               " does not tell what world and lesson said in which round; record it again.";
    }
    if (const std::uint64_t lost = count_lost(record); tells_all(record) && lost > 0) {
        return " The record lost " + std::to_string(lost) +
               " rounds, for its disk or the computer was too slow; what came in them is not "
               "known.";
    }
    std::string text;
    if (const auto budget = find_fact(record.header, kToolTimeFact);
        budget && is_of_tool(report_)) {
        text = " The tool had " + std::string(*budget) +
               " us of each step then and ended its search by the clock, which is not in a record.";
    }
    if (const std::string why = explain_difference(record.header, header_); !why.empty()) {
        return text + " Likely why: " + why + ".";
    }
    if (!text.empty()) {
        return text;
    }
    return record.header.facts.empty()
               ? " The record is of an earlier version and does not say what it was made with."
               : " Program, lesson, files, options and limits are the record's.";
}

}  // namespace fulcrum::runtime
