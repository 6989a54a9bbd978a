// A lesson as data: what its Lua declared in `lesson{}` and `start(world)`. The plan is compiled from this alone.
// Every item knows the line of the lesson that asked for it. Ranges, defaults and units as a lesson gives them: runtime/effect.
#pragma once

#include "dialogue/marking/feedback_ladder.h"
#include "haptics/constraint/contact_method.h"
#include "haptics/dynamics/axle.h"
#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/joint_plan.h"
#include "haptics/geometry/shape.h"
#include "haptics/handover/messages.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/math/spatial.h"
#include "haptics/point/proxy_plan.h"
#include "haptics/surface/material.h"
#include "haptics/tool/tool_solver.h"
#include "runtime/effect/kite/kite_description.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

/// Line of lesson.lua, 0 when unknown.
using SourceLine = std::int32_t;

/// "lesson.lua:7", where errors say what they are about.
[[nodiscard]] inline std::string at_line(SourceLine line) {
    return "lesson.lua:" + std::to_string(line);
}

inline constexpr std::int32_t kNoMaterial = -1;
inline constexpr std::size_t kMaxMaterials = 32;

/// What bodies are made of. Heights that come from a picture are not here yet: the program reads the file for the plan.
struct MaterialDescription {
    Material felt{};    ///< in the hand's metres; its name is how Lua and learners call it
    std::string look;   ///< the program's own material that it looks like; empty for none
    std::string image;  ///< PNG or JPEG beside the lesson, empty for none
    SourceLine line = 0;
};

/// What is made of a body's model. Among rigid bodies `model` is a ball, a box, or the hull of one from a file, and for the hand a ball, or the mesh;
/// `mesh`: the closed mesh itself, with its hollows.
enum class BodyShape : std::uint8_t { model, box, ball, cylinder, capsule, hull, mesh };
/// A joint's end that is farther than this is none; degrees are radians here.
inline constexpr double kAnyTravel = 1.0e9;

/// How a rigid body hangs on another one, or on the world, from where both are declared.
struct JointDescription {
    JointKind kind = JointKind::hinge;
    std::string to;  ///< name of a rigid body that was declared before; empty: the world
    Vector3 at_W{Vector3::Zero()};
    Vector3 other_at_W{Vector3::Zero()};  ///< of a rod: its end on this body; `at_W` is the other
    Vector3 axis_W{Vector3::UnitZ()};     ///< of a hinge or slider
    double lowest = -kAnyTravel;          ///< radians or metres; at most 0
    double highest = kAnyTravel;          ///< at least 0
    double speed = 0.0;                   ///< of its motor, which has at most `force`
    double force = 0.0;
    double friction = 0.0;
};

/// A body that lies, falls, is pushed and gripped, with its mass.
struct RigidDescription {
    std::optional<JointDescription> joint{};
};

// Of a body that is made of several boxes.
inline constexpr std::size_t kMaxBoxes = 200;
inline constexpr double kFarthestBox_m = 100.0;  ///< each coordinate of a box's middle
inline constexpr double kLeastEdge_m = 0.002;
inline constexpr double kMostEdge_m = 10.0;

struct BodyDescription {
    std::string name;   ///< unique; how Lua calls it
    std::string noun;   ///< English noun as a child says it, e.g. "watermelon"
    std::string model;  ///< name of a model, e.g. "apple" for assets/models/apple.glb
    double radius_m = 0.05;
    double mass_kg = 1.0;  ///< the true mass
    double exaggeration =
        1.0;  ///< felt mass / true mass as the teacher sets it, before all are scaled to fit
    double drag_area_m2 = 0.0;
    bool solid = false;    ///< can be touched as a mesh
    bool movable = false;  ///< may fall, be caught and be held
    bool visible = false;  ///< seen from the start, at `position_W`
    Vector3 position_W{Vector3::Zero()};
    SourceLine line = 0;
    std::int32_t material = kNoMaterial;      ///< index into LessonDescription::materials
    std::optional<AxleSettings> hinge{};      ///< a solid body that turns, and does nothing else
    std::optional<RigidDescription> rigid{};  ///< a solid body that all forces move
    Vector3 size_m{Vector3::Zero()};  ///< edges of a box, each 0.002 to 10; zero: twice the radius
    std::string about{};              ///< what is said when it is first touched; may be empty
    std::vector<PlacedBox> boxes{};   ///< that it is made of instead of one, with the model "box"
    // Three shapes in one frame: `model` is seen, these are felt by the hand and simulated among rigid bodies.
    std::string felt_model{};                  ///< empty: as it is seen
    std::string simulated_model{};             ///< empty: as it is felt
    BodyShape felt_as = BodyShape::model;      ///< what is made of the felt one
    BodyShape collides_as = BodyShape::model;  ///< what is made of the simulated one
    ShadingSettings shading{};  ///< its facets are felt as one even surface, as far as its creases
    double seen_scale = 1.0;    ///< of what cannot be touched: times its model
};

/// The body with what the hand feels of it as its model.
[[nodiscard]] inline BodyDescription as_felt(BodyDescription body) {
    if (!body.felt_model.empty()) {
        body.model = body.felt_model;
        body.boxes.clear();
    }
    return body;
}
/// The same of what is simulated.
[[nodiscard]] inline BodyDescription as_simulated(BodyDescription body) {
    if (body.simulated_model.empty()) {
        return as_felt(std::move(body));
    }
    body.model = body.simulated_model;
    body.boxes.clear();
    return body;
}

/// The edges of a body that is a box; of other shapes twice the radius.
[[nodiscard]] inline Vector3 box_size_m(const BodyDescription& body) {
    return body.size_m.isZero() ? Vector3::Constant(2.0 * body.radius_m) : body.size_m;
}

struct ForceDescription {
    std::string name;  ///< unique; how Lua switches it
    FieldPlan field{};
    SourceLine line = 0;
};

struct BucketDescription {
    bool present = false;
    std::string model = "bucket";
    double opening_radius_m = 0.11;
    double depth_m = 0.14;
    int holds =
        1;  ///< bodies at once; felt weights are scaled so that this many fit under the force limit
    SourceLine line = 0;
};

/// How contacts between rigid bodies are solved.
struct RigidSolveDescription {
    ContactMethod method = ContactMethod::newton;
    FrictionShape friction = FrictionShape::cone;
    SourceLine line = 0;  ///< 0: the lesson does not say
};

struct CameraDescription {
    Vector3 eye_W{0.0, 0.55, 1.5};
    Vector3 target_W{0.0, 0.35, 0.0};
    double vertical_angle_deg = 40.0;
};

/// What Otaduy and Lin found that nobody feels, in parts of a tool's size.
inline constexpr double kUsualDetail = 0.025;
inline constexpr double kMostDetail = 0.2;

/// A tool of points in the hand, which stays outside solid bodies and is felt with force and torque; masses and stiffnesses as
/// the hand feels them, lengths in the scene's metres. Ranges as the program's reference has them.
struct ToolDescription {
    CursorShape shape =
        CylinderShape{0.02, 0.05};  ///< upright along y; a point where it has a model
    std::string model;              ///< instead of a shape, or empty
    double mass_kg = 0.02;
    double stiffness_N_per_m = 500.0;  ///< of the spring between hand and tool
    double turn_stiffness_Nm_per_rad =
        0.0;               ///< 0: as stiff at the tool's farthest point as the spring
    double voxel_m = 0.0;  ///< side of the bodies' voxels; 0: chosen for each body
    int points =
        0;  ///< on its surface; 0: 2000, among voxels one a voxel of its own where a step has time
    ToolMethod method = ToolMethod::field_sampling;
    bool massless = false;
    Integrator integrator = Integrator::backward_euler;
    ShadingSettings shading{};  ///< its facets are felt as one even surface, as far as its creases
    ContactFinding contact = ContactFinding::fields;  ///< of implicit_penalty
    double detail = kUsualDetail;  ///< of contact levels: their tolerance in parts of its size
    double budget_us = 0.0;        ///< of contact levels, in each step of a live run; 0: half of it
    PenaltyModel contact_model = PenaltyModel::planes;  ///< of implicit_penalty
};

/// A lesson's: both of a person, or a finger of each.
inline constexpr std::size_t kMostHands = 2;

/// Where a hand works in the scene: the device's centre, and world metres a device metre.
struct HandDescription {
    Vector3 centre_W{0.0, 0.3, 0.0};
    double scale = 1.0;
    double rate_hz = 1000.0;    ///< of the haptic loop
    bool lesson_force = false;  ///< hand:force(function …) was called
    SourceLine force_line = 0;
    /// What solid bodies are touched with; not given: what the scene needs.
    std::optional<ProxyKind> proxy{};
    CursorShape cursor{};
    SourceLine line = 0;
    std::optional<ToolDescription> tool{};  ///< instead of either
    bool needed = false;  ///< of a further hand: the lesson cannot be played without it
    VelocityMethod velocity = VelocityMethod::adaptive_window;             ///< how it is found out
    SegmentStructureKind structure = SegmentStructureKind::bounding_tree;  ///< of a god_object
    std::string cursor_model{};  ///< whose hull the cursor is, in its own size; or empty
};

/// Answers to a question of which is known how they are to be marked.
struct QuestionExamples {
    std::vector<std::string> right;  ///< right in meaning and form
    std::vector<std::string> wrong;  ///< understood, and wrong in meaning
    std::vector<std::string> form;   ///< right in meaning, with an error of form
};

/// A question with its answer templates; `right` stays in Lua and is asked by a Judge message.
struct QuestionDescription {
    std::string id;
    std::string prompt;
    std::vector<std::string> answers;   ///< hassil templates with grammar slots
    std::vector<std::string> nearly{};  ///< the same of what is understood and no good English
    std::vector<std::pair<std::string, std::vector<std::string>>>
        lists;          ///< {name} -> words; {thing}, {other}: bodies' nouns by default
    std::string again;  ///< said after a wrong meaning, behind "Not yet."; empty: "Try again."
    SourceLine line = 0;
    QuestionExamples examples{};          ///< what its answers must come to, for `check` and `test`
    dialogue::FeedbackLadder feedback{};  ///< on form; empty: the lesson's own
    std::vector<std::pair<std::string, std::string>> rules{};  ///< <name> -> a template
};

/// Ways to ask of which is known what they come to.
struct KnowledgeExamples {
    std::vector<std::string> right;  ///< ask for it in good English
    std::vector<std::string> form;   ///< ask for it with an error of form
    std::vector<std::string> other;  ///< do not ask for it
};

/// Something that a learner may ask for; `answer` stays in Lua and is asked by an AskedEvent.
struct KnowledgeDescription {
    std::string id;
    std::vector<std::string> asked;  ///< templates of the questions that ask for it
    std::vector<std::pair<std::string, std::vector<std::string>>> lists;  ///< as a question's
    SourceLine line = 0;
    std::vector<std::string> nearly{};  ///< the same of what is understood and no good English
    KnowledgeExamples examples{};       ///< for `check` and `test`
    std::vector<std::pair<std::string, std::string>> rules{};  ///< as a question's
};

/// What L:test { expect = … } may name: the first two are true or false, the others are whole numbers.
inline constexpr std::array<std::string_view, 8> kTestFacts{
    "finished", "felt", "stars", "score", "level", "attempts", "caught", "form_errors"};
inline constexpr std::size_t kTestFlags = 2;

/// The levels of English of the Common European Framework of Reference for Languages.
inline constexpr std::array<std::string_view, 6> kEnglishLevels{"A1", "A2", "B1", "B2", "C1", "C2"};

/// How a simulated learner answers who knows the right answers, in parts of them, each 0 to 1.
struct LearnerRates {
    double wrong = 0.0;    ///< wrong in meaning
    double form = 0.0;     ///< right in meaning, with an error of form
    double unclear = 0.0;  ///< not to be understood
};

/// L:test { … }: how the lesson is played in tests.
struct LessonTestDescription {
    std::string hand;                                         ///< file beside lesson.lua
    std::vector<std::string> say;                             ///< answers in order
    std::optional<LearnerRates> learner{};                    ///< who answers instead
    std::vector<std::pair<std::string, std::string>> expect;  ///< name -> value, e.g. score -> "7"
    SourceLine line = 0;
    std::string second_hand{};  ///< file of another hand; empty: it is not there
};

inline constexpr std::int32_t kMostTries = 20;

/// Everything that a lesson declares.
struct LessonDescription {
    std::string id;
    std::string title;
    std::string level = "A1";             ///< one of kEnglishLevels
    double minutes = 10;                  ///< planned length
    std::optional<double> force_limit_N;  ///< the lesson wants no more, 0.5 to 10
    bool free_english = false;  ///< what no template of a question takes is checked for its form
    dialogue::FeedbackLadder
        feedback{};          ///< on form, of questions without their own; empty: the usual
    std::int32_t tries = 4;  ///< answers of wrong meaning after which a question is left, 1 to 20
    double sureness = 0.4;   ///< of who hears, 0 to 1; what is less sure is asked for again
    Vector3 gravity_W{0.0, -9.81, 0.0};
    double ground_height_m = 0.0;
    RigidSolveDescription contacts{};
    std::vector<MaterialDescription> materials;
    std::vector<BodyDescription> bodies;
    std::vector<ForceDescription> forces;
    BucketDescription bucket{};
    bool in_space = false;  ///< a dark sky with stars instead of a meadow
    CameraDescription camera{};
    HandDescription hand{};
    std::vector<HandDescription> more_hands{};  ///< beside it, at most kMostHands in all
    std::optional<KiteDescription> kite{};      ///< on a line that the hand holds
    WindDescription wind{};                     ///< for it
    std::vector<QuestionDescription> questions;
    std::vector<KnowledgeDescription> knowledge;
    bool wants_past =
        false;  ///< world:recall(): what this learner has answered in earlier sessions
    bool is_room =
        false;  ///< world:room(): other lessons are entered from it, and nothing of it is kept
    std::vector<LessonTestDescription> tests;
    std::string icon{};      ///< the model that its card shows; empty: what the learner will hold
    std::int32_t order = 0;  ///< where its card stands; 0: behind those that say so
};

}  // namespace fulcrum::runtime
