// Stands in for libbarrett's header: the main function that finds a WAM and gives it to wam_main.
// Source: libbarrett, standard_main_function.h.
#pragma once

#include <barrett/products/product_manager.h>
#include <barrett/systems.h>
#include <cstddef>

template <std::size_t DOF>
int wam_main(int argc, char** argv, ::barrett::ProductManager& pm,
             ::barrett::systems::Wam<DOF>& wam);

int main(int argc, char** argv) {
    ::barrett::ProductManager pm;
    ::barrett::systems::Wam<7> wam;
    return wam_main(argc, argv, pm, wam);
}
