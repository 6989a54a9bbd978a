#include "runtime/lua/wire/wire.h"

#include "tests/support/wire_messages.h"
#include "tests/unit/runtime/rig.h"

#include <cstring>
#include <random>

using namespace fulcrum::runtime::test;
using fulcrum::test::full_description;
using fulcrum::test::full_error;
using fulcrum::test::full_frame;
using fulcrum::test::full_load;
using fulcrum::test::full_module_answer;
using fulcrum::test::full_reply;

namespace {

constexpr std::size_t kHead = 5;  // length and kind
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <class Message>
Bytes bytes_of(const Message& message) {
    Bytes bytes;
    encode(message, bytes);
    return bytes;
}

std::span<const std::uint8_t> body_of(const Bytes& bytes) {
    return std::span(bytes).subspan(kHead);
}

/// What the fuzzer begins with: the kind of a message and its body, without the length.
std::vector<std::pair<std::string, Bytes>> seeds() {
    std::vector<std::pair<std::string, Bytes>> all = {
        {"description", bytes_of(full_description())},
        {"reply", bytes_of(full_reply())},
        {"frame", bytes_of(full_frame())},
        {"load", bytes_of(full_load())},
        {"module_answer", bytes_of(full_module_answer())},
        {"error", bytes_of(full_error())}};
    for (auto& [name, bytes] : all) {
        bytes.erase(bytes.begin(), bytes.begin() + sizeof(std::uint32_t));
    }
    return all;
}

/// One command, as the child would send it, taken in by the program.
Expected<LessonReply> take(const LessonCommand& command) {
    LessonReply reply;
    reply.commands.push_back(command);
    const Bytes bytes = bytes_of(reply);
    return decode_reply(body_of(bytes), full_description());
}

}  // namespace

TEST_CASE("wire: a description, a reply and a frame come back as they were") {
    // Compared by encoding again: every field is in the bytes.
    const Bytes description = bytes_of(full_description());
    const auto d = decode_description(body_of(description));
    REQUIRE(d);
    CHECK(bytes_of(*d) == description);
    CHECK(d->tries == 3);
    CHECK(d->sureness == 0.25);
    CHECK(d->bodies[0].solid);
    CHECK(d->questions[0].lists[0].second[1] == "egg");
    CHECK(d->questions[0].again == "Lift it.");
    CHECK(d->questions[0].rules.at(0).second == "on the table");
    CHECK(d->knowledge[0].rules.at(0).first == "which");
    CHECK(std::get<NoiseTexture>(d->materials[1].felt.texture.source).seed == 7);
    CHECK(d->hand.proxy == ProxyKind::virtual_proxy);
    CHECK(std::get<SphereShape>(d->hand.cursor).radius_m == 0.01);
    REQUIRE(d->hand.tool);
    CHECK(std::get<CapsuleShape>(d->hand.tool->shape).half_length_m == 0.05);
    CHECK(d->hand.tool->mass_kg == 0.03);
    CHECK(d->hand.tool->stiffness_N_per_m == 400.0);
    CHECK(d->hand.tool->turn_stiffness_Nm_per_rad == 0.25);
    CHECK(d->hand.tool->voxel_m == 0.004);
    CHECK(d->hand.tool->points == 3000);
    CHECK(d->hand.tool->method == ToolMethod::voxel_sampling);
    CHECK(d->hand.tool->massless);
    CHECK(d->hand.tool->integrator == Integrator::verlet);
    CHECK(d->hand.tool->contact == ContactFinding::levels);
    CHECK(d->hand.tool->detail == 0.05);
    CHECK(d->hand.tool->budget_us == 150.0);
    const Bytes reply = bytes_of(full_reply());
    const auto r = decode_reply(body_of(reply), *d);
    REQUIRE(r);
    CHECK(bytes_of(*r) == reply);
    CHECK(std::get<ScoreCommand>(r->commands[7]).score == -7);
    const LinearisedWrench& wrench = std::get<LessonForceCommand>(r->commands[3]).force;
    CHECK(wrench.torque_W == Vector3(0.5, -0.25, 9.0));
    CHECK(wrench.torque_stiffness_Nm_per_m(1, 2) == -450);
    CHECK(wrench.torque_stiffness_Nm_per_m(2, 1) == 0);
    const Bytes frame = bytes_of(full_frame());
    const auto f = decode_frame(body_of(frame));
    REQUIRE(f);
    CHECK(bytes_of(*f) == frame);
    CHECK_FALSE(std::get<AnsweredEvent>(f->events[3]).over);
    CHECK(std::get<AnsweredEvent>(f->events[3]).turned_round);
    CHECK_FALSE(std::get<AnsweredEvent>(f->events[3]).form_known);
}

TEST_CASE("wire: the small messages come back as they were") {
    const Bytes bytes = bytes_of(full_load());
    const auto l = decode_load(body_of(bytes));
    REQUIRE(l);
    CHECK(bytes_of(*l) == bytes);
    CHECK(l->lesson.text.size() == 3);
    CHECK(decode_module_request(body_of(bytes_of(ModuleRequest{"story"})))->name == "story");
    const auto answer = decode_module_answer(body_of(bytes_of(full_module_answer())));
    CHECK(answer->source.text == "return 1");
    CHECK(decode_print(body_of(bytes_of(PrintCommand{"p"})))->text == "p");
    const auto error = decode_error(body_of(bytes_of(full_error())));
    CHECK(to_sentence(to_error(*error)) == "lesson.lua:12: wrong.");
}

// With FULCRUM_WRITE_SEEDS set they are written anew first, for a new layout.
TEST_CASE("wire: the fuzzer begins with messages of today's layout") {
    for (const auto& [name, bytes] : seeds()) {
        const std::string path = FULCRUM_SOURCE_DIR "/tests/fuzz/corpus/wire/" + name;
        if (std::getenv("FULCRUM_WRITE_SEEDS") != nullptr) {
            std::ofstream file(path, std::ios::binary);
            std::ranges::copy(bytes, std::ostreambuf_iterator<char>(file));
        }
        std::ifstream file(path, std::ios::binary);
        const Bytes kept{std::istreambuf_iterator<char>(file), {}};
        INFO(name << " is of another layout; run this test once with FULCRUM_WRITE_SEEDS=1");
        CHECK(kept == bytes);
    }
}

TEST_CASE("wire: a message cut off anywhere, or longer than it says, is an error") {
    const LessonDescription d = full_description();
    const Bytes description = bytes_of(d);
    const Bytes reply = bytes_of(full_reply());
    for (std::size_t n = 0; n < description.size() - kHead; ++n) {
        REQUIRE_FALSE(decode_description(body_of(description).first(n)));
    }
    for (std::size_t n = 0; n < reply.size() - kHead; ++n) {
        REQUIRE_FALSE(decode_reply(body_of(reply).first(n), d));
    }
    Bytes longer = reply;
    longer.push_back(0);
    CHECK_FALSE(decode_reply(body_of(longer), d));
}

TEST_CASE("wire: numbers, indices and names of a reply are checked") {
    const auto move = [](std::int32_t body, double y, double speed) {
        return MoveCommand{
            {WorldCommand::Kind::place, body, Vector3(0, y, 0), Vector3(speed, 0, 0)}};
    };
    CHECK(take(move(0, 1e4, 1e3)));
    CHECK(take(move(1, -1e4, 0)));
    CHECK_FALSE(take(move(4, 0, 0)));
    CHECK_FALSE(take(move(-1, 0, 0)));
    CHECK_FALSE(take(move(0, 1.1e4, 0)));
    CHECK_FALSE(take(move(0, kNaN, 0)));
    CHECK_FALSE(take(move(0, 0, 1.1e3)));
    CHECK_FALSE(take(FieldChangeCommand{2, {}}));
    CHECK_FALSE(take(FieldChangeCommand{-1, {}}));
    CHECK_FALSE(take(FieldChangeCommand{0, {true, Vector3::Zero(), 1.5}}));
    CHECK_FALSE(take(AskCommand{"lightest"}));
    CHECK_FALSE(take(VerdictCommand{"", true}));
    CHECK_FALSE(take(ScoreCommand{2'000'000}));
    CHECK_FALSE(take(LevelCommand{-1, ""}));
    CHECK_FALSE(take(FinishCommand{4}));
    CHECK(take(CoverCommand{1, false}));
    CHECK(take(ShowHandCommand{}));
    CHECK(take(ShowHandCommand{Vector3(1.0, 2.0, 3.0)}));
    CHECK_FALSE(take(ShowHandCommand{Vector3(1.0, 2.0e9, 3.0)}));
    CHECK_FALSE(take(CoverCommand{4, true}));
    CHECK_FALSE(take(CoverCommand{-1, true}));
    CHECK(take(MarkCommand{1, kMostMark_N}));
    CHECK_FALSE(take(MarkCommand{4, 1.0}));
    CHECK_FALSE(take(MarkCommand{1, -1.0}));
    CHECK_FALSE(take(MarkCommand{1, 2.0 * kMostMark_N}));
    CHECK(take(LightCommand{1, BodyLight::lit}));
    CHECK_FALSE(take(LightCommand{4, BodyLight::lit}));
    CHECK_FALSE(take(LightCommand{1, static_cast<BodyLight>(3)}));
    CHECK_FALSE(take(SoundCommand{"../pop"}));
    CHECK_FALSE(take(CaptionCommand{std::string(kMaxTextBytes + 1, 'x')}));
    CHECK_FALSE(take(CaptionCommand{"\xFF"}));
    CHECK_FALSE(take(PrintCommand{"\x1B[2J"}));
    LinearisedWrench force;
    CHECK(take(LessonForceCommand{force}));
    force.force_W.x() = kMaxLessonForce_N * 1.01;
    CHECK_FALSE(take(LessonForceCommand{force}));
    force = {};
    force.stiffness_N_per_m(1, 2) = std::numeric_limits<double>::infinity();
    CHECK_FALSE(take(LessonForceCommand{force}));
    force = {};
    force.damping_Ns_per_m(1, 2) = kNaN;
    CHECK_FALSE(take(LessonForceCommand{force}));
    force = {};
    force.torque_W.z() = -kMaxLessonTorque_Nm;
    force.torque_stiffness_Nm_per_m(0, 2) = kMaxLessonTorqueStiffness_Nm_per_m;
    CHECK(take(LessonForceCommand{force}));
    force.torque_W.z() = -kMaxLessonTorque_Nm * 1.01;
    CHECK_FALSE(take(LessonForceCommand{force}));
    force.torque_W.z() = kNaN;
    CHECK_FALSE(take(LessonForceCommand{force}));
    force = {};
    force.torque_stiffness_Nm_per_m(0, 2) = kMaxLessonTorqueStiffness_Nm_per_m * 1.01;
    CHECK_FALSE(take(LessonForceCommand{force}));
    force.torque_stiffness_Nm_per_m(0, 2) = kNaN;
    CHECK_FALSE(take(LessonForceCommand{force}));
}

TEST_CASE("wire: a reply has bounded commands, and an orientation of unit length") {
    LessonReply reply;
    reply.commands.assign(kMaxCommands, ScoreCommand{1});
    CHECK(decode_reply(body_of(bytes_of(reply)), full_description()));
    reply.commands.emplace_back(ScoreCommand{1});
    CHECK_FALSE(decode_reply(body_of(bytes_of(reply)), full_description()));
    reply = {};
    reply.hand_target_W.orientation.coeffs() *= 1.5;
    const auto taken = decode_reply(body_of(bytes_of(reply)), full_description());
    REQUIRE(taken);
    CHECK(taken->hand_target_W.orientation.norm() == Approx(1.0));
    reply.hand_target_W.orientation.coeffs().setZero();
    CHECK_FALSE(decode_reply(body_of(bytes_of(reply)), full_description()));
}

TEST_CASE("wire: contradictions of a description are found") {
    const auto taken = [](auto change) {
        LessonDescription d = full_description();
        change(d);
        return decode_description(body_of(bytes_of(d))).has_value();
    };
    CHECK(taken([](auto&) {}));
    CHECK_FALSE(taken([](auto& d) { d.id.clear(); }));
    CHECK_FALSE(taken([](auto& d) { d.bodies[1].name = "apple"; }));
    CHECK_FALSE(taken([](auto& d) { d.bodies[1].name.clear(); }));
    CHECK_FALSE(taken([](auto& d) { d.bodies[1].model = "../egg"; }));
    CHECK_FALSE(taken([](auto& d) { d.bodies[1].mass_kg = -1; }));
    CHECK_FALSE(taken([](auto& d) { d.bodies[1].radius_m = 0; }));
    CHECK_FALSE(taken([](auto& d) { d.bodies[1].line = -1; }));
    CHECK_FALSE(taken([](auto& d) { d.forces[1].name = "s"; }));
    CHECK_FALSE(taken([](auto& d) { d.bodies[0].material = 2; }));
    CHECK_FALSE(taken([](auto& d) { d.bodies[0].material = -2; }));
    CHECK_FALSE(taken([](auto& d) { d.materials[1].felt.name = "felt"; }));
    CHECK_FALSE(taken([](auto& d) { d.materials[1].felt.name.clear(); }));
    CHECK_FALSE(taken([](auto& d) { d.materials[0].image = "../felt.png"; }));
    CHECK_FALSE(taken([](auto& d) { d.materials[0].image = "felt.png/"; }));
    CHECK_FALSE(taken([](auto& d) { d.materials[0].look = "a b"; }));
    CHECK_FALSE(taken([](auto& d) { d.materials[0].felt.texture.height_m = kNaN; }));
    CHECK_FALSE(taken([](auto& d) { d.materials[0].felt.friction.static_coefficient = 6; }));
    CHECK_FALSE(
        taken([](auto& d) { d.materials[0].felt.texture.law = static_cast<TextureLaw>(3); }));
    CHECK_FALSE(taken([](auto& d) { d.materials.assign(kMaxMaterials + 1, d.materials[0]); }));
    CHECK_FALSE(taken([](auto& d) { d.hand.proxy = static_cast<ProxyKind>(3); }));
    CHECK_FALSE(taken([](auto& d) { d.hand.cursor = SphereShape{0.0}; }));
    CHECK(taken([](auto& d) { d.hand.cursor = BoxShape{}; }));
    CHECK(taken([](auto& d) { d.hand.cursor = CapsuleShape{}; }));
    CHECK(taken([](auto& d) { d.hand.cursor = CylinderShape{}; }));
    CHECK_FALSE(taken([](auto& d) { d.hand.cursor = HullShape{}; }));
    CHECK(taken([](auto& d) { d.hand.proxy.reset(); }));
    CHECK(taken([](auto& d) { d.hand.tool.reset(); }));
    CHECK(taken([](auto& d) { d.hand.tool->shape = CylinderShape{}; }));
    CHECK_FALSE(taken([](auto& d) { d.hand.tool->shape = HullShape{}; }));
    CHECK_FALSE(taken([](auto& d) { d.hand.tool->shape = std::monostate{}; }));
    CHECK_FALSE(taken([](auto& d) { d.hand.tool->model = "gear"; }));
    CHECK_FALSE(taken([](auto& d) { d.hand.tool->mass_kg = kNaN; }));
    CHECK_FALSE(taken([](auto& d) { d.hand.tool->voxel_m = -0.001; }));
    CHECK_FALSE(taken([](auto& d) { d.hand.tool->points = -1; }));
    CHECK_FALSE(taken([](auto& d) { d.hand.tool->method = static_cast<ToolMethod>(4); }));
    CHECK_FALSE(taken([](auto& d) { d.hand.tool->contact = static_cast<ContactFinding>(2); }));
    CHECK_FALSE(taken([](auto& d) { d.hand.tool->detail = 0.21; }));
    CHECK_FALSE(taken([](auto& d) { d.hand.tool->budget_us = -1.0; }));
    CHECK_FALSE(taken([](auto& d) { d.hand.tool->integrator = static_cast<Integrator>(5); }));
    CHECK_FALSE(taken([](auto& d) { d.forces[0].field.stiffness_N_per_m = 2001; }));
    CHECK_FALSE(taken([](auto& d) { d.forces[0].field.kind = static_cast<FieldKind>(3); }));
    CHECK_FALSE(taken([](auto& d) { d.questions.push_back(d.questions[0]); }));
    CHECK_FALSE(taken([](auto& d) { d.tests[0].hand = "../sweep.lua"; }));
    CHECK_FALSE(taken([](auto& d) { d.gravity_W.y() = kNaN; }));
    CHECK_FALSE(taken([](auto& d) {
        d.bodies[0].solid = false;
        d.bodies.assign(kMaxBodies + 1, d.bodies[0]);
        for (std::size_t i = 0; i < d.bodies.size(); ++i) {
            d.bodies[i].name = "b" + std::to_string(i);
        }
    }));
    CHECK_FALSE(taken([](auto& d) {
        d.bodies.assign(kMaxSolids + 1, d.bodies[0]);
        for (std::size_t i = 0; i < d.bodies.size(); ++i) {
            d.bodies[i].name = "b" + std::to_string(i);
        }
    }));
}

TEST_CASE("wire: 200 000 damaged messages are refused, or make sense within all limits") {
    const LessonDescription d = full_description();
    const Bytes whole = bytes_of(full_reply());
    const Bytes body(whole.begin() + kHead, whole.end());
    std::mt19937 random(3);
    int n_taken = 0;
    for (int i = 0; i < 200'000; ++i) {
        Bytes damaged = body;
        for (std::uint32_t k = random() % 4 + 1; k > 0; --k) {
            damaged[random() % damaged.size()] = static_cast<std::uint8_t>(random());
        }
        const auto reply = decode_reply(damaged, d);
        if (!reply) {
            continue;
        }
        ++n_taken;
        // What is taken passes a second time, byte for byte, save for an orientation brought to unit length.
        REQUIRE(decode_reply(body_of(bytes_of(*reply)), d));
        for (const LessonCommand& command : reply->commands) {
            if (const auto* force = std::get_if<LessonForceCommand>(&command)) {
                REQUIRE(force->force.force_W.allFinite());
                REQUIRE(force->force.stiffness_N_per_m.allFinite());
                REQUIRE(force->force.torque_W.cwiseAbs().maxCoeff() <= kMaxLessonTorque_Nm);
                REQUIRE(force->force.torque_stiffness_Nm_per_m.cwiseAbs().maxCoeff() <=
                        kMaxLessonTorqueStiffness_Nm_per_m);
            }
        }
    }
    CHECK(n_taken > 1000);
}
