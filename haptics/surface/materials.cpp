// Sources, named in short beside the numbers:
//
//   like      the law: a sinusoid that decays, scaled by the speed of the tap, of another amplitude, frequency and decay for rubber, wood
//   Okamura   and metal, below what real ones ring with where an arm could not follow. A. M. Okamura, M. R. Cutkosky, J. T. Dennerlein
//             2001, Reality-based models for vibration feedback in virtual environments, IEEE/ASME Trans. Mechatronics 6(3), pp. 245-252.
//             The numbers are ours, chosen after the order of magnitude of theirs, not copied from their tables: 10 N for each m/s on
//             metal, so that a tap of 0.2 m/s rings with 2 N, two thirds of what a desktop arm gives.
//   Marks     Marks' Standard Handbook for Mechanical Engineers, table of coefficients of static and sliding friction
//   Byerlee   J. Byerlee 1978, Friction of rocks, Pure and Applied Geophysics 116: a shear stress of 0.85 times the normal one, up
//             to 200 MPa
//   FEPA      FEPA standard 43-1 for coated abrasives: mean grain of P40 0.425 mm
//   stiffness is chosen everywhere: real walls are a thousand times as stiff as any arm can show. What counts is the order, rubber
//   < paper < wood < rock, glass, metal, and that all lie inside the Z-width of a desktop arm at 1 kHz (`fulcrum bench z-width`);
//   the damper is critical for the handle alone, 2 sqrt(m k), as in coupling_settings.h.
//   heights   are chosen to be felt: reliefs of polished metal or of glass (micrometres, below the 55 um of an encoder's step)
//             cannot be, so these have none.
#include "haptics/surface/materials.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum {
namespace {

CouplingSettings stiff(double stiffness_N_per_m) {
    return {.stiffness_N_per_m = stiffness_N_per_m,
            .damping_Ns_per_m = 2.0 * std::sqrt(kHandleMass_kg * stiffness_N_per_m)};
}

TransientSettings ringing(double force_Ns_per_m, double frequency_Hz, double decay_per_s) {
    return {.kind = TransientKind::decaying_sinusoid,
            .force_Ns_per_m = force_Ns_per_m,
            .frequency_Hz = frequency_Hz,
            .decay_per_s = decay_per_s};
}

TextureSettings relief(const TextureSource& source, TextureLaw law, double height_m,
                       double gain = 1.0) {
    return {.source = source, .law = law, .height_m = height_m, .gain = gain};
}

Material make_wood() {
    return {
        .name = "wood",
        .coupling = stiff(800.0),
        // Oak on oak, across the grain (Marks).
        .friction = {0.54, 0.32, 0.0},
        // Planed softwood: early and late wood of a year alternate every few millimetres (chosen: 3 mm, 0.15 mm deep,
        // so that the slope is 0.11 at most).
        .texture = relief(SineTexture{0.003, 0.0}, TextureLaw::lateral, 1.5e-4),
        .transient = ringing(5.0, 30.0, 80.0)};  // like Okamura
}

Material make_metal() {
    return {
        .name = "metal",
        .coupling = stiff(1000.0),
        // Chosen: metal that hands have touched is never clean, and tables have 0.15 to 0.20 at rest for iron with grease on it;
        // sliding about half of that, so that it is the most slippery of all.
        .friction = {0.15, 0.081, 0.0},
        .transient = ringing(10.0, 100.0, 90.0)};  // like Okamura, aluminium
}

Material make_rock() {
    return {
        .name = "rock",
        .coupling = stiff(1000.0),
        // At rest Byerlee; sliding is chosen, 0.7 of it.
        .friction = {0.85, 0.6, 0.0},
        // Chosen: broken stone has bumps of every size; these are the ones that a stylus can follow.
        .texture = relief(NoiseTexture{0.0015, 0.012, 7}, TextureLaw::perturbed_normal, 1.0e-3),
        // Chosen between wood and metal: stone rings, but a block that lies on the ground loses it soon.
        .transient = ringing(8.0, 80.0, 120.0)};
}

Material make_rubber() {
    return {.name = "rubber",
            .coupling = stiff(300.0),
            // Chosen: it holds a hand about as well as it is pressed.
            .friction = {1.0, 0.8, 0.0},
            // Chosen: the fine pattern of a mat.
            .texture = relief(SineTexture{0.002, 0.7}, TextureLaw::lateral, 3.0e-5),
            .transient = ringing(3.9, 18.0, 60.0)};  // like Okamura
}

Material make_glass() {
    return {
        .name = "glass",
        .coupling = stiff(1000.0),
        // Chosen: little more than metal. Clean glass holds far better, glass with the film of a hand does not.
        .friction = {0.2, 0.12, 0.0},
        // Chosen above metal: a pane is light and stiff.
        .transient = ringing(9.0, 140.0, 70.0)};
}

Material make_paper() {
    return {.name = "paper",
            .coupling = stiff(600.0),
            // Chosen: between metal and wood.
            .friction = {0.4, 0.3, 0.0},
            // Chosen: fibres flock at a millimetre or less.
            .texture = relief(NoiseTexture{0.0006, 0.0015, 3}, TextureLaw::lateral, 3.0e-5),
            // Chosen: a sheet on a table deadens the tap.
            .transient = ringing(3.0, 25.0, 150.0)};
}

Material make_sandpaper() {
    return {
        .name = "sandpaper",
        .coupling = stiff(800.0),
        // Chosen: grains that dig in hold as rubber does.
        .friction = {0.9, 0.8, 0.0},
        // P40: grains of 0.425 mm (FEPA), two to four grains from one to the next; half a grain stands out of the glue (chosen).
        // Finer paper has waves that no loop of 1 kHz can give at a stroke's usual speed.
        .texture = relief(NoiseTexture{0.00085, 0.0017, 80}, TextureLaw::lateral, 2.1e-4),
        .transient = ringing(5.0, 30.0, 120.0)};  // as the wood under it, deadened by glue (chosen)
}

Material make_leaves() {
    return {.name = "leaves",
            // Chosen: a clipped hedge gives way as a firm cushion does.
            .coupling = stiff(250.0),
            // Chosen: leaves and twigs hold a hand less than bark does.
            .friction = {0.5, 0.4, 0.0},
            // Chosen: twigs a few millimetres apart that bend aside.
            .texture = relief(NoiseTexture{0.002, 0.008, 11}, TextureLaw::lateral, 3.0e-4),
            .transient = ringing(1.0, 15.0, 200.0)};  // Chosen: hardly a tap
}

}  // namespace

std::span<const Material> shipped_materials() {
    static const std::array<Material, 8> kMaterials{make_wood(),      make_metal(), make_rock(),
                                                    make_rubber(),    make_glass(), make_paper(),
                                                    make_sandpaper(), make_leaves()};
    return kMaterials;
}

const Material* find_material(std::string_view name) {
    const auto all = shipped_materials();
    const auto found = std::ranges::find(all, name, &Material::name);
    return found == all.end() ? nullptr : &*found;
}

}  // namespace fulcrum
