// The contact thread's round: where is the tool near anything, in a few clusters?
//
//   fetch the tool's place -> find what is near, object by object -> cluster -> tell the haptic loop
// It goes as fast as it can; the haptic loop goes on with the last answer, as a model of the surfaces near it (contact_planes.h).
// With a budget each object's question may take what is left of it, divided among itself and those after it that were near at the last round.
//
// Thread: one beside the haptic one, or that itself, or a virtual clock. Cost: that of finding and 0.1 us a contact; no allocation.
// Source: M. Otaduy, M. Lin 2005, section 3.1.
#pragma once

#include "haptics/tool/beside_task.h"
#include "haptics/tool/implicit_penalty/contact_model.h"

#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

/// Fixed at load.
struct ContactLoopSettings {
    ContactClusterSettings clusters{};  ///< `most` is of each object; told are kMostClusters in all
    int most_near = 2048;               ///< contacts an object at a time, 32 to 65536
    double budget_us = 0.0;  ///< of a round, 0 to 1e6, for finders that can be hurried; 0: none
};

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const ContactLoopSettings& settings);

class ContactLoop final : public BesideTask {
  public:
    /// Refuses what `validate` does, no finder, a null one, and more than kMaxSolids. The channels outlive it.
    [[nodiscard]] static Expected<std::unique_ptr<ContactLoop>> create(
        std::vector<std::unique_ptr<ContactFinder>> finders, const ContactLoopSettings& settings,
        ContactChannels& channels);

    ContactLoop(const ContactLoop&) = delete;
    ContactLoop& operator=(const ContactLoop&) = delete;
    ~ContactLoop() override;

    /// Told of each round that finds something to do; null: nobody is.
    void listen(RoundListener* listener) noexcept { listener_ = listener; }
    /// Nothing is told before the haptic loop has told of a place, nor of one that is no number.
    bool run_once() noexcept override;

    /// Whether the tool at `tool_W` is nearer to no object than `within_m`, and in none; not where the budget is too short to say. Between rounds, by whoever runs them.
    [[nodiscard]] bool is_free(const Pose& tool_W, std::span<const MovingFrame> objects,
                               double within_m) noexcept;
    [[nodiscard]] double reach_m() const noexcept { return finders_.front()->reach_m(); }
    [[nodiscard]] std::size_t n_objects() const noexcept { return finders_.size(); }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    ContactLoop(std::vector<std::unique_ptr<ContactFinder>> finders,
                const ContactLoopSettings& settings, ContactChannels& channels);
    void tell(const ToolPlace& place) noexcept;
    void share_time(std::size_t object, double began_s) noexcept;
    void look(const ToolPlace& place) noexcept;

    std::vector<std::unique_ptr<ContactFinder>> finders_;
    std::vector<ContactClusters> clusters_;  // one an object
    ContactLoopSettings settings_;
    ContactChannels& channels_;
    BoundedList<NearContact> near_;
    ContactModel model_{};
    std::uint32_t n_placements_ = 0;
    RoundListener* listener_ = nullptr;
};

}  // namespace fulcrum
