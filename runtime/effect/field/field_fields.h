// What a lesson says of a spring, a viscosity and a magnet that pull at the hand.
#pragma once

#include "haptics/field/field_plan.h"
#include "runtime/effect/field_list.h"
#include "runtime/scene/lesson_limits.h"

namespace fulcrum::runtime::fields {

using enum ParameterType;

inline constexpr auto kPlace = field(
    &FieldPlan::anchor_W,
    {"at", vector, "metres", -kMaxCoordinate_m, kMaxCoordinate_m, kRequired, "where it pulls to"});

inline constexpr std::tuple kSpring{
    argument({"name", name, "", 0, 0, "nil", "\"spring1\", \"spring2\" … by default"}), kPlace,
    field(&FieldPlan::stiffness_N_per_m,
          {"stiffness", number, "newtons per metre", 0, 2000, kRequired, ""}),
    field(&FieldPlan::damping_Ns_per_m,
          {"damping", number, "newton seconds per metre", 0, 50, "0", ""})};

inline constexpr std::tuple kViscosity{
    argument({"name", name, "", 0, 0, "nil", "\"viscosity1\", \"viscosity2\" … by default"}),
    field(&FieldPlan::damping_Ns_per_m,
          {"damping", number, "newton seconds per metre", 0, 50, kRequired, "honey is about 20"})};

inline constexpr std::tuple kMagnet{
    argument({"name", name, "", 0, 0, "nil", "\"magnet1\", \"magnet2\" … by default"}), kPlace,
    field(&FieldPlan::peak_force_N,
          {"force", number, "newtons", 0, 10, kRequired, "the strongest pull"}),
    field(&FieldPlan::range_m,
          {"range", number, "metres", 0.001, 10, "0.1", "distance of the strongest pull"})};

/// A kind of force that a lesson declares as world:name{ … }.
template <class List>
struct ForceKind {
    FieldKind kind;
    const char* name;
    List list;
    const char* text;
};
template <class List>
ForceKind(FieldKind, const char*, List, const char*) -> ForceKind<List>;

/// All of them, in the order of FieldKind.
inline constexpr std::tuple kForces{
    ForceKind{FieldKind::spring, "spring", kSpring,
              "Declares a spring that pulls the hand. It is on from the start."},
    ForceKind{FieldKind::viscosity, "viscosity", kViscosity,
              "Declares a thickness of the air that brakes the hand. It is on from the start."},
    ForceKind{FieldKind::magnet, "magnet", kMagnet,
              "Declares a magnet that pulls the hand. It is on from the start."}};
/// Calls visit(force) for each.
template <class Visit>
constexpr void for_each_force(Visit&& visit) {
    std::apply([&](const auto&... forces) { (visit(forces), ...); }, kForces);
}

}  // namespace fulcrum::runtime::fields
