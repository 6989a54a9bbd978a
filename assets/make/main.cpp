// fulcrum_make_assets OUTDIR: makes every model of the toy box as OUTDIR/<name>.glb. Same program,
// same bytes.
#include "assets/make/glb_writer.h"
#include "assets/make/models.h"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace {

using namespace fulcrum::assets;

constexpr Model (*kModels[])() = {
    make_watermelon, make_apple,   make_banana,  make_egg,      make_bucket,  make_cursor,
    make_ghost,      make_star,    make_ground,  make_hill,     make_tree,    make_cloud,
    make_flower,     make_plank,   make_sphere,  make_box,      make_cloth,   make_spaceship,
    make_table,      make_statue,  make_bell,    make_chair,    make_castle,  make_sun,
    make_mercury,    make_venus,   make_earth,   make_mars,     make_jupiter, make_saturn,
    make_uranus,     make_neptune, make_lever,   make_support,  make_ring,    make_bowl,
    make_walker,     make_gem,     make_handles, make_cylinder, make_capsule, make_hand,
    make_kite};

void write(const std::filesystem::path& folder, const Model& model) {
    const auto bytes = encode_glb(model);
    const auto path = folder / (model.name + ".glb");
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) {
        throw std::runtime_error(path.string() + ": cannot be written");
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: fulcrum_make_assets OUTDIR\n");
        return 2;
    }
    try {
        const std::filesystem::path folder(argv[1]);
        std::filesystem::create_directories(folder);
        for (const auto make : kModels) {
            write(folder, make());
        }
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 1;
    }
    return 0;
}
