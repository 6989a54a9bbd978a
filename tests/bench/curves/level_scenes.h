// Two bodies by rule, and a way along which a hand presses one on the other: what contact levels of detail are measured on.
#pragma once

#include "haptics/base/error.h"
#include "haptics/geometry/triangle_mesh.h"
#include "haptics/tool/implicit_penalty/contact_clusters.h"
#include "haptics/tool/implicit_penalty/level_contacts.h"

#include <memory>
#include <string>
#include <vector>

namespace fulcrum::bench {

struct LevelScene {
    std::string name;
    TriangleMesh object;
    TriangleMesh tool;
    double within_m = 0.0;
    std::vector<Pose> hands;  ///< X_OT that the hand asks for, a step each
};

/// Jaws of support/jaws.h: a bite, and grinding over the teeth.
[[nodiscard]] LevelScene make_jaws_scene(int n_along, int n_round, int n_steps);
/// A spoon in a cup goes round along wall, rim and bottom.
[[nodiscard]] LevelScene make_spoon_scene(int fineness, int n_steps);
/// A mesh rolls and slides on another like it, both brought to a diagonal of 0.2 m.
[[nodiscard]] LevelScene make_rolling_scene(const std::string& name, const TriangleMesh& mesh,
                                            int n_steps);

/// Levels of both, and what they took.
struct SceneLevels {
    std::shared_ptr<const ContactLevels> object;
    std::shared_ptr<const ContactLevels> tool;
    double seconds = 0.0;  ///< for the tool's
};
[[nodiscard]] SceneLevels make_scene_levels(const LevelScene& scene);

/// The sum over clusters of k (depth + d), for what is near pushes from d outside on, as in the source and in a lesson's tool, so that the
/// tool stays outside; with contacts kept from step to step.
class ClusterForce {
  public:
    ClusterForce(double within_m, std::unique_ptr<LevelContacts> finder);
    /// Looks for contacts: what is timed.
    void find(const Pose& X_OT);
    /// Of what was found last, newtons.
    [[nodiscard]] Vector3 compute_force_N(const Pose& X_OT);
    [[nodiscard]] std::size_t n_contacts() const { return near_.count(); }
    [[nodiscard]] const LevelContacts& finder() const { return *finder_; }
    [[nodiscard]] std::size_t n_clusters() const { return clusters_.all().size(); }

    static constexpr double kStiffness_N_per_m = 20000.0;

  private:
    double within_m_;
    std::unique_ptr<LevelContacts> finder_;
    BoundedList<NearContact> near_;
    ContactClusters clusters_;
};

/// The hand's way, with a tool that a coupling of 500 N/m pulls to the hand and contacts hold back: six rounds a step towards the balance. The
/// tool turns with the hand.
struct PlayedScene {
    std::vector<Vector3> felt_N;  ///< of the coupling, a step each
    std::vector<double> us;       ///< of each question, processor time
    double n_contacts = 0.0;      ///< means of a question
    double n_pairs = 0.0;
    double n_late = 0.0;
    std::size_t bytes = 0;
};
[[nodiscard]] PlayedScene play_scene(const LevelScene& scene, const SceneLevels& levels,
                                     const LevelPairSettings& settings);

/// A lump deep in another like it, that slides to and fro: what a budget has to hold.
struct DeepPlay {
    std::vector<double> us;        ///< of each question, processor time
    std::vector<Vector3> force_N;  ///< of clusters, where the tool is, whoever presses it there
    double n_left = 0.0;           ///< means of a question
    double n_coarser = 0.0;
    double most_left_m = 0.0;
};
[[nodiscard]] DeepPlay play_deep(const std::shared_ptr<const ContactLevels>& lump, int n_steps,
                                 const LevelPairSettings& settings);

}  // namespace fulcrum::bench
