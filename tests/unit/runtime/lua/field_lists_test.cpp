// Field lists: of every one its defaults, and what the wire lets through and refuses.
#include "runtime/effect/asking/lesson_fields.h"
#include "runtime/effect/asking/question_fields.h"
#include "runtime/effect/body/body_fields.h"
#include "runtime/effect/catch/bucket_fields.h"
#include "runtime/effect/field/field_fields.h"
#include "runtime/effect/hand/hand_fields.h"
#include "runtime/effect/hinge/hinge_fields.h"
#include "runtime/effect/kite/kite_fields.h"
#include "runtime/effect/rigid/joint_fields.h"
#include "runtime/effect/scene/scene_fields.h"
#include "runtime/effect/surface/material_fields.h"
#include "runtime/effect/tool/tool_fields.h"
#include "runtime/lua/wire/wire_fields.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

namespace fulcrum::runtime {
namespace {

// visit(name, list, owner as it is where nothing is said)
template <class Visit>
void for_each_list(Visit&& visit) {
    fields::for_each_force([&](const auto& force) { visit(force.name, force.list, FieldPlan{}); });
    visit("lesson", fields::kLesson, LessonDescription{});
    visit("question", fields::kQuestion, QuestionDescription{});
    visit("knows", fields::kKnowledge, KnowledgeDescription{});
    visit("test", fields::kTest, LessonTestDescription{});
    visit("learner", fields::kRates, LearnerRates{});
    visit("gravity", fields::kGravity, LessonDescription{});
    visit("ground", fields::kGround, LessonDescription{});
    visit("camera", fields::kCamera, CameraDescription{});
    visit("bucket", fields::kBucket, BucketDescription{});
    visit("hinge", fields::kHinge, AxleSettings{});
    visit("joint", fields::kJoint, JointDescription{});
    visit("body", fields::kBody, BodyDescription{});
    visit("kite design", fields::kKiteDesign, KiteSettings{});
    visit("kite line", fields::kKiteLine, KiteDescription{});
    visit("wind", fields::kWind, WindDescription{});
    visit("texture", fields::kTexture, TextureSettings{});
    visit("tap", fields::kTap, TransientSettings{});
    visit("saturation", fields::kSaturation, CouplingSettings{});
    visit("contacts", fields::kContacts, RigidSolveDescription{});
    visit("material", fields::kMaterial, Material{});
    visit("tool", fields::kTool, ToolDescription{});
    visit("hand", fields::kHand, HandDescription{});
}

// Does the Lua text stand for what is kept?
template <class Kept>
bool stands_for(const Parameter& row, double kept_per_unit, const Kept& kept) {
    const std::string text = row.fallback;
    if constexpr (std::is_same_v<Kept, bool>) {
        return text == (kept ? "true" : "false");
    } else if constexpr (std::is_same_v<Kept, std::string>) {
        return text == kept;
    } else if constexpr (std::is_same_v<Kept, Vector3>) {
        double x = 0.0;
        double y = 0.0;
        double z = 0.0;
        return std::sscanf(row.fallback, "{%lf, %lf, %lf}", &x, &y, &z) == 3 &&
               kept == kept_per_unit * Vector3(x, y, z);
    } else if constexpr (std::is_enum_v<Kept>) {
        return find_choice(row.choices, text) == static_cast<std::size_t>(kept);
    } else if constexpr (!std::is_arithmetic_v<Kept>) {
        return text == "{}" && kept.empty();
    } else {
        // A default of whole degrees may stand for one of round radians.
        return std::abs(kept_per_unit * std::strtod(row.fallback, nullptr) -
                        static_cast<double>(kept)) <= 0.01 * std::abs(kept_per_unit - 1.0);
    }
}

TEST_CASE("field lists: a default in Lua is what the description has where nothing is said") {
    int n = 0;
    for_each_list([&](const char* whose, const auto& list, const auto& unsaid) {
        for_each_kept(list, [&](const auto& field) {
            const char* const fallback = field.row.fallback;
            if (fallback != kRequired && std::string(fallback) != "nil") {
                INFO(whose << "'s " << field.row.name << ": " << fallback);
                CHECK(stands_for(field.row, field.kept_per_unit, field.in(unsaid)));
                ++n;
            }
        });
    });
    CHECK(n > 40);
}

// What the wire makes of the owner.
template <class List, class Owner>
Expected<Owner> send(const List& list, const Owner& owner) {
    Bytes bytes;
    wire::Writer writer(bytes);
    wire::fields(writer, "it", list, owner);
    wire::Reader reader(bytes);
    Owner came = owner;
    wire::fields(reader, "it", list, came);
    return reader.result(std::move(came));
}

TEST_CASE("field lists: the wire takes the ends of each range and what is unsaid, nothing beyond") {
    int n_numbers = 0;
    for_each_list([&](const char* whose, const auto& list, const auto& unsaid) {
        CHECK(send(list, unsaid));
        for_each_kept(list, [&](const auto& field) {
            INFO(whose << "'s " << field.row.name);
            auto owner = unsaid;
            auto& kept = field.in(owner);
            using Kept = std::remove_cvref_t<decltype(kept)>;
            if constexpr (std::is_same_v<Kept, double>) {
                REQUIRE(field.least() < field.most());
                for (const double end : {field.least(), field.most()}) {
                    kept = end;
                    const auto came = send(list, owner);
                    REQUIRE(came);
                    REQUIRE(field.in(*came) == end);
                }
                const double far = std::numeric_limits<double>::infinity();
                for (const double beyond :
                     {std::nextafter(field.least(), -far), std::nextafter(field.most(), far),
                      std::numeric_limits<double>::quiet_NaN()}) {
                    kept = beyond;
                    const auto came = send(list, owner);
                    REQUIRE_FALSE(came);
                    REQUIRE(came.error().message.find(field.row.name) != std::string::npos);
                }
                ++n_numbers;
            } else if constexpr (std::is_enum_v<Kept>) {
                const std::size_t n = count_choices(field.row.choices);
                kept = static_cast<Kept>(n - 1);
                REQUIRE(send(list, owner));
                kept = static_cast<Kept>(n);
                REQUIRE_FALSE(send(list, owner));
            } else if constexpr (std::is_same_v<Kept, int>) {
                kept = static_cast<int>(field.most()) + 1;
                REQUIRE_FALSE(send(list, owner));
            } else if constexpr (std::is_same_v<Kept, std::string>) {
                const bool is_name = field.row.type == ParameterType::name;
                kept = is_name ? "No Name"
                               : std::string(static_cast<std::size_t>(field.most()) + 1, 'a');
                REQUIRE_FALSE(send(list, owner));
            }
        });
    });
    CHECK(n_numbers > 40);
}

}  // namespace
}  // namespace fulcrum::runtime
