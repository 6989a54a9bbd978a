#include "runtime/evidence/force_account.h"

#include "haptics/math/length.h"
#include "runtime/evidence/record_words.h"
#include "runtime/text/json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

// What is missing of `asked` where no more than `most` is let through.
Vector3 cut_off(const Vector3& asked, double most) {
    const double length = compute_length(asked);
    return most > 0.0 && length > most ? Vector3(asked * (most / length - 1.0)) : Vector3::Zero();
}

bool is_open(GatePhase gate, Fault faults) {
    return !any(faults) && (gate == GatePhase::rising || gate == GatePhase::open);
}

bool has_torque(const ForceAccount& account) {
    const auto turns = [](const Wrench& w) { return w.torque.squaredNorm() > 0.0; };
    return turns(account.asked_W) || turns(account.felt_W) ||
           std::ranges::any_of(account.effects, turns, &ForcePart::wrench_W);
}

std::string row(const std::string& name, const Wrench& part_W, const Wrench& felt_W,
                bool with_torque) {
    std::array<char, 256> text{};
    std::snprintf(text.data(), text.size(), "%-22.40s %9.4f  %-26s", name.c_str(),
                  compute_length(part_W.force), direction_words(part_W.force).c_str());
    std::string line = text.data();
    if (with_torque) {
        std::snprintf(text.data(), text.size(), " %9.5f", compute_length(part_W.torque));
        line += text.data();
    }
    if (compute_length(felt_W.force) > 0.0) {
        std::snprintf(text.data(), text.size(), " %8.1f %%",
                      percent_of(part_W.force, felt_W.force));
        line += text.data();
    }
    return line + "\n";
}

Json json_of(const Vector3& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

Json json_of(const std::string& name, const Wrench& part_W, const Wrench& felt_W) {
    return Json::object({{"name", name},
                         {"force_N", json_of(part_W.force)},
                         {"torque_Nm", json_of(part_W.torque)},
                         {"newtons", compute_length(part_W.force)},
                         {"direction", direction_words(part_W.force)},
                         {"percent", percent_of(part_W.force, felt_W.force)}});
}

Json json_of(const ForceAccount& account) {
    const Wrench& felt_W = account.felt_W;
    Json effects = Json::array();
    for (const ForcePart& part : account.effects) {
        effects.push_back(json_of(part.name, part.wrench_W, felt_W));
    }
    return Json::object({{"hand", account.hand + 1},
                         {"time_s", account.time_s},
                         {"round", account.tick},
                         {"touched", account.touched},
                         {"gate", gate_word(account.gate)},
                         {"faults", fault_words(account.faults)},
                         {"effects", std::move(effects)},
                         {"asked", json_of("asked for", account.asked_W, felt_W)},
                         {"limits", json_of("the limits", account.limit_W, felt_W)},
                         {"taken_by_gate", json_of("the gate", account.gate_W, felt_W)},
                         {"felt", json_of("felt", felt_W, felt_W)}});
}

std::string number(double value, const char* format) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

}  // namespace

ForceAccount make_account(std::span<const std::string> names, std::span<const Wrench> shares_W,
                          const Wrench& asked_W, const Wrench& felt_W, GatePhase gate, Fault faults,
                          const MostFelt& most) {
    ForceAccount account;
    for (std::size_t i = 0; i < std::min(names.size(), shares_W.size()); ++i) {
        account.effects.push_back({names[i], shares_W[i]});
    }
    account.asked_W = asked_W;
    account.felt_W = felt_W;
    account.gate = gate;
    account.faults = faults;
    if (is_open(gate, faults)) {
        account.limit_W = {cut_off(asked_W.force, most.force_N),
                           cut_off(asked_W.torque, most.torque_Nm)};
    }
    account.gate_W = {felt_W.force - (asked_W.force + account.limit_W.force),
                      felt_W.torque - (asked_W.torque + account.limit_W.torque)};
    return account;
}

Expected<ForceAccount> find_account(const Record& record, double time_s) {
    if (record.header.effects.empty()) {
        return fail(record.version < kRecordVersion
                        ? "the record has version " + std::to_string(record.version) +
                              ", which does not tell what each effect adds to the force"
                        : std::string("no effect of this lesson gives a force"),
                    {}, "record the run again, of a lesson in which something is felt");
    }
    const double period_s = 1.0 / record.header.rate_Hz;
    if (record.samples.empty() || !(time_s >= record.samples.front().time_s) ||
        !(time_s < record.samples.back().time_s + period_s)) {
        const std::string from =
            record.samples.empty() ? "" : number(record.samples.front().time_s, "%.4g");
        return fail("the record has no round at " + number(time_s, "%.6g") + " s", {},
                    record.samples.empty() ? "record a longer run"
                                           : "give --force a time from " + from + " to " +
                                                 number(record.samples.back().time_s, "%.6g"));
    }
    const auto after = std::ranges::upper_bound(record.samples, time_s, {}, &RecordSample::time_s);
    const auto at = static_cast<std::size_t>(after - record.samples.begin()) - 1;
    const RecordSample& sample = record.samples[at];
    ForceAccount account = make_account(
        record.header.effects, record.shares_of(at), sample.commanded_W, sample.applied_W,
        sample.gate, sample.faults, {record.header.max_force_N, record.header.max_torque_Nm});
    account.tick = sample.tick;
    account.time_s = sample.time_s;
    account.lesson = record.header.lesson;
    if (sample.touched_body != kNoBody) {
        const auto body = static_cast<std::size_t>(sample.touched_body);
        account.touched = body < record.header.bodies.size() ? record.header.bodies[body]
                                                             : "body " + std::to_string(body + 1);
    }
    return account;
}

double percent_of(const Vector3& part_W, const Vector3& felt_W) {
    const double squared = felt_W.squaredNorm();
    return squared > 0.0 ? 100.0 * part_W.dot(felt_W) / squared : 0.0;
}

std::string account_text(const ForceAccount& account) {
    const Wrench& felt_W = account.felt_W;
    const bool turns = has_torque(account);
    std::string text = account.lesson + " at " + number(account.time_s, "%.4f") + " s (round " +
                       std::to_string(account.tick) + "): ";
    text += compute_length(felt_W.force) > 0.0
                ? "the hand feels " + number(compute_length(felt_W.force), "%.3f") + " N " +
                      direction_words(felt_W.force) + ".\n"
                : "the hand feels nothing.\n";
    text +=
        account.touched.empty() ? "Nothing is touched.\n" : "It touches " + account.touched + ".\n";
    std::array<char, 160> head{};
    std::snprintf(head.data(), head.size(), "\n%-22s %9s  %-26s%s%s\n", "share of", "newtons",
                  "pulls the hand", turns ? "   newton m" : "",
                  compute_length(felt_W.force) > 0.0 ? "   of the felt" : "");
    text += head.data();
    for (const ForcePart& part : account.effects) {
        text += row(part.name, part.wrench_W, felt_W, turns);
    }
    text += row("= asked for", account.asked_W, felt_W, turns);
    text += row("the limits", account.limit_W, felt_W, turns);
    text += row("the gate, " + std::string(gate_word(account.gate)), account.gate_W, felt_W, turns);
    text += row("= felt", felt_W, felt_W, turns);
    if (any(account.faults)) {
        text += "\nThe force fades: " + fault_words(account.faults) + ".\n";
    }
    return text;
}

std::string accounts_json(std::span<const ForceAccount> accounts) {
    Json hands = Json::array();
    for (const ForceAccount& account : accounts) {
        hands.push_back(json_of(account));
    }
    return Json::object({{"version", 2},
                         {"lesson", accounts.empty() ? std::string() : accounts.front().lesson},
                         {"hands", std::move(hands)}})
        .to_text();
}

}  // namespace fulcrum::runtime
