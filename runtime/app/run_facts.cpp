#include "runtime/app/run_facts.h"

#include "haptics/base/processor.h"
#include "haptics/base/sha256.h"
#include "haptics/device/replay/recorded_traits.h"
#include "haptics/tool/tool_plan.h"
#include "runtime/app/hand_device.h"
#include "runtime/app/program_build.h"
#include "runtime/effect/tool/check_tool.h"
#include "runtime/effect/tool/plan_tool.h"
#include "runtime/evidence/record_words.h"
#include "runtime/evidence/replay_check.h"
#include "runtime/lesson/learner_feedback.h"
#include "runtime/scene/shape_models.h"

#include <array>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>

namespace fulcrum::runtime {
namespace fs = std::filesystem;

namespace {

class Facts {
  public:
    explicit Facts(std::vector<RecordFact>& facts) : facts_(facts) {}
    void add(std::string name, std::string value) {
        facts_.push_back({std::move(name), std::move(value)});
    }
    void add(std::string name, double value) { add(std::move(name), exact_text(value)); }
    void add(std::string name, const Vector3& v) {
        add(std::move(name), exact_text(v.x()) + " " + exact_text(v.y()) + " " + exact_text(v.z()));
    }
    /// Named from the lesson's folder, or by its own: where that lies is nobody's business, and a copied lesson is the same one.
    void add_file(const std::string& kind, const fs::path& file, const fs::path& lesson_folder) {
        Sha256 hash;
        std::ifstream stream(file, std::ios::binary);
        std::array<char, 65536> part{};
        while (stream.read(part.data(), part.size()) || stream.gcount() > 0) {
            hash.add(
                std::as_bytes(std::span(part).first(static_cast<std::size_t>(stream.gcount()))));
        }
        std::error_code error;
        const bool is_own = fs::equivalent(file.parent_path(), lesson_folder, error);
        const fs::path name =
            is_own ? file.filename() : file.parent_path().filename() / file.filename();
        add(kind + name.string(), to_hex(hash.finish()));
    }

  private:
    std::vector<RecordFact>& facts_;
};

// Models and pictures that are files.
void add_assets(const FactSources& run, Facts& facts) {
    std::set<fs::path> files;
    const auto add_model = [&](const std::string& model) {
        if (!model.empty() && !is_shape_model(model)) {
            files.insert(find_model(run.places, run.request.folder, model));
        }
    };
    for (const BodyDescription& body : run.lesson.bodies) {
        add_model(body.model);
        add_model(body.felt_model);
        add_model(body.simulated_model);
    }
    if (run.lesson.hand.tool) {
        add_model(run.lesson.hand.tool->model);
    }
    for (const MaterialDescription& material : run.lesson.materials) {
        if (!material.image.empty()) {
            files.insert(run.request.folder / material.image);
        }
    }
    files.erase(fs::path{});
    for (const fs::path& file : files) {
        facts.add_file("asset.", file, run.request.folder);
    }
}

std::string_view word_of(HandKind kind) {
    constexpr std::string_view kWords[] = {"simulated",     "mouse", "replay", "HID",
                                           "arm on a link", "keys",  "nobody"};
    static_assert(std::size(kWords) == static_cast<std::size_t>(HandKind::none) + 1);
    return kWords[static_cast<std::size_t>(kind)];
}

void add_options(const FactSources& run, Facts& facts) {
    facts.add("option.seed", std::to_string(run.request.seed));
    facts.add(kClockFact, run.request.plan.live ? kRealTime : "virtual");
    const bool is_timed =
        run.plan.haptic.tool && run.lesson.hand.tool->method != ToolMethod::god_object;
    if (run.request.plan.live && is_timed) {
        facts.add(kToolTimeFact, find_budget_us(run.lesson.hand));
    }
    facts.add("option.hand", std::string(word_of(run.request.hand)));
    facts.add("option.day", run.plan.day);
    facts.add(kScaleFact, run.plan.haptic.workspace.scale / run.lesson.hand.scale);
    facts.add("option.device N", run.device_force_limit_N);
    for (std::size_t i = 0; i < run.plan.holders.size(); ++i) {
        const WallHolder& holder = run.plan.holders[i];
        const std::string prefix = holder_prefix(i);
        facts.add(prefix + kHolderFact, holder.name);
        facts.add(prefix + kHolderMassFact, holder.mass_kg);
        facts.add(prefix + kHolderDampingFact, holder.damping_Ns_per_m);
        facts.add(prefix + kHolderForceFact, holder.max_force_N);
        facts.add(prefix + kHolderLinkFact, holder.link_s);
    }
    facts.add(kFeedbackFact,
              feedback_text(run.request.feedback.value_or(run.request.kept_feedback)));
    facts.add("option.hearing", std::string(name_of(run.plan.speech)));
    if (run.plan.partner.kind != PartnerKind::shipped) {
        facts.add(kPartnerFact, std::string(name_of(run.plan.partner.kind)));
    }
}

void add_limits(const FactSources& run, Facts& facts) {
    const SiteLimits& site = run.request.plan.site;
    facts.add("limit.site N", site.force_N);
    facts.add("limit.site Nm", site.torque_Nm);
    facts.add("limit.site m/s", site.speed_m_per_s);
    facts.add("limit.site J", site.energy_J);
    facts.add("limit.lesson N",
              run.lesson.force_limit_N ? exact_text(*run.lesson.force_limit_N) : "none");
    const SafetySettings& safety = run.plan.haptic.safety;
    facts.add("limit.plan N", safety.max_force_N);
    facts.add("limit.plan Nm", safety.max_torque_Nm);
    facts.add("limit.slew N/s", safety.max_slew_N_per_s);
    facts.add("limit.transient N", safety.max_transient_N);
    facts.add("limit.transient N s", safety.transient_Ns);
    facts.add("limit.transient N2 s", safety.transient_N2s);
    facts.add("limit.soft start N/s", safety.soft_start_N_per_s);
    facts.add("limit.soft start s", safety.soft_start_s);
    facts.add("limit.engage below N", safety.engage_below_N);
    facts.add("limit.rest m/s", safety.rest_speed_m_per_s);
    facts.add("limit.rest s", safety.rest_s);
    facts.add("limit.fade s", safety.fade_s);
    facts.add("limit.hand m/s", safety.max_felt_speed_m_per_s);
    facts.add("limit.energy J", safety.max_energy_J);
}

void add_workspace(const Workspace& workspace, Facts& facts) {
    facts.add("workspace.scale", workspace.scale);
    facts.add("workspace.centre m", workspace.pose_WD.position);
    const Quaternion& turn = workspace.pose_WD.orientation;
    facts.add("workspace.turn w x y z", exact_text(turn.w()) + " " + exact_text(turn.x()) + " " +
                                            exact_text(turn.y()) + " " + exact_text(turn.z()));
}

// How a tool's contacts and forces are found.
void add_tool(const ToolDescription& tool, const ToolPlan& plan, Facts& facts) {
    facts.add("plan.tool", std::string(name_of(tool.method)));
    if (tool.contact != ContactFinding::fields) {
        facts.add("plan.tool contact", std::string(name_of(tool.contact)));
    }
    if (tool.method == ToolMethod::god_object) {
        // The budget of its steps, which no clock tells.
        facts.add("plan.tool rounds", make_god_object_settings(plan).most_rounds);
    }
    if (has_thread(tool)) {
        facts.add("option.contact", plan.beside ? "by a thread beside the steps" : "in each step");
    }
}

// What was decided before anything ran: each stage with who asked for it, and what bodies weigh in the hand.
void add_plan(const FactSources& run, Facts& facts) {
    const Plan& plan = run.plan;
    const HapticPlan& haptic = plan.haptic;
    if (haptic.tool) {
        add_tool(*run.lesson.hand.tool, *haptic.tool, facts);
    } else if (!haptic.solids.empty()) {
        facts.add("plan.proxy", std::string(name_of(haptic.proxy.kind)));
    }
    facts.add("plan.velocity", std::string(name_of(haptic.velocity_method)));
    facts.add("plan.coupling N/m", haptic.coupling.stiffness_N_per_m);
    facts.add("plan.coupling Ns/m", haptic.coupling.damping_Ns_per_m);
    facts.add("plan.lesson Hz", plan.haptic.lesson_rate_hz);
    facts.add("plan.world Hz", plan.world_rate_hz());
    facts.add("plan.kite Hz", plan.kite ? plan.kite->rate_hz : 0.0);
    facts.add("plan.felt scale", plan.felt_scale);
    for (std::size_t i = 0; i < plan.felt_weight_N.size() && i < run.lesson.bodies.size(); ++i) {
        if (plan.felt_weight_N[i] > 0.0) {
            facts.add("plan.weight of " + run.lesson.bodies[i].name + " N", plan.felt_weight_N[i]);
        }
    }
    int n = 0;
    for (const PlanStage& stage : plan.stages) {
        // Whether somebody looks on or keeps it changes no force.
        if (stage.loop != "picture" && stage.loop != "sound" && stage.loop != "record" &&
            stage.name != name_of(HapticStage::record)) {
            facts.add("plan.stage " + std::to_string(++n),
                      stage.loop + " " + stage.name + ", " + exact_text(stage.rate_hz) +
                          " Hz, line " + std::to_string(stage.line) + ", " + stage.because);
        }
    }
    for (std::size_t i = 0; i < plan.notices.size(); ++i) {
        facts.add("plan.notice " + std::to_string(i + 1), plan.notices[i]);
    }
}

void add_more_hands(const FactSources& run, RecordHeader& header) {
    for (std::size_t i = 0; i < run.more_hands.size(); ++i) {
        const FactSources::Hand& hand = run.more_hands[i];
        header.more_hands.push_back({hand.loop.max_force_N(), hand.loop.max_torque_Nm(),
                                     effect_words(hand.loop.effects(), run.lesson)});
        Facts facts(header.facts);
        const std::string prefix = fact_prefix(header.more_hands.size());
        facts.add(prefix + "option.hand", std::string(word_of(run.request.more_hands[i].hand)));
        facts.add(prefix + kScaleFact,
                  run.plan.more_hands[i].workspace.scale / run.lesson.more_hands[i].scale);
        std::vector<RecordFact> traits;
        list_traits(hand.device, traits);
        for (RecordFact& trait : traits) {
            header.facts.push_back({prefix + trait.name, std::move(trait.value)});
        }
    }
}

}  // namespace

RecordHeader describe_run(const FactSources& run) {
    RecordHeader header;
    header.rate_Hz = run.plan.haptic.rate_hz;
    header.lesson = run.lesson.id;
    header.max_force_N = run.loop.max_force_N();
    header.max_torque_Nm = run.loop.max_torque_Nm();
    header.effects = effect_words(run.loop.effects(), run.lesson);
    for (const BodyDescription& body : run.lesson.bodies) {
        header.bodies.push_back(body.name);
    }
    if (run.plan.kite && header.bodies.size() < kMaxBodies) {
        header.bodies.emplace_back("kite");
    }
    Facts facts(header.facts);
    facts.add("program.version", kProgramVersion);
    facts.add("program.build", program_build_id());
    facts.add("program.kernels", name_kernels());
    for (const fs::path& file : run.files) {
        facts.add_file("lesson.", file, run.request.folder);
    }
    add_assets(run, facts);
    add_options(run, facts);
    list_traits(run.device, header.facts);
    facts.add("device.reach m", run.device.reach_m);
    add_more_hands(run, header);
    add_workspace(run.plan.haptic.workspace, facts);
    add_limits(run, facts);
    add_plan(run, facts);
    return header;
}

}  // namespace fulcrum::runtime
