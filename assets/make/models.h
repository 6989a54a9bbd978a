// The models of the toy box, each a function. Real sizes in metres; fruit have their origin at the
// centre of mass.
#pragma once

#include "assets/make/mesh.h"

namespace fulcrum::assets {

[[nodiscard]] Model make_watermelon();  ///< toy melon, 0.19 m long along x
[[nodiscard]] Model make_apple();       ///< 0.08 m across, stem up
[[nodiscard]] Model make_banana();      ///< 0.18 m along its bend, ends up
[[nodiscard]] Model make_egg();         ///< 0.057 m tall, blunt end down
[[nodiscard]] Model
make_bucket();  ///< origin at the rim's centre, opening up; 0.11 m radius inside, 0.14 m deep
[[nodiscard]] Model make_cursor();  ///< where the hand is: a soft ball, 0.02 m radius
[[nodiscard]] Model make_ghost();   ///< where the arm really is: the same, seen through
[[nodiscard]] Model make_star();    ///< puffy, 0.05 m radius, facing +z
[[nodiscard]] Model make_ground();  ///< meadow, disc of 4 m radius, its top at y = 0 in the middle
[[nodiscard]] Model make_tree();    ///< 1.2 m tall, origin at its foot
[[nodiscard]] Model make_cloud();   ///< 0.5 m wide
[[nodiscard]] Model make_hill();    ///< 3 m wide, origin at the middle of its foot
[[nodiscard]] Model make_flower();  ///< 0.09 m tall, origin at its foot
[[nodiscard]] Model make_sphere();  ///< 1 m radius, spotted; drawn at a body's radius
[[nodiscard]] Model make_box();  ///< 2 m along each side; drawn at a body's radius as half a side
[[nodiscard]] Model make_cylinder();  ///< post, 0.16 m tall, 0.08 m across; middle
[[nodiscard]] Model make_capsule();   ///< with round ends, 0.2 m tall, 0.08 m across; middle
[[nodiscard]] Model make_hand();      ///< a white glove that points, 0.11 m; its first finger's tip
[[nodiscard]] Model make_kite();      ///< a diamond with a tail, 0.3 m tall; where its spars cross
[[nodiscard]] Model make_plank();     ///< shelf board, 0.9 m by 0.2 m, its top at y = 0
[[nodiscard]] Model make_ring();      ///< lying, 0.16 m across, its tube 0.032 m; middle
[[nodiscard]] Model make_bowl();      ///< open upwards, 0.2 m across; the middle of its rim

// Of the lesson on materials; what they are made of gives them their look.
[[nodiscard]] Model make_cloth();      ///< over a box of 2 m a side; drawn at a body's radius
[[nodiscard]] Model make_spaceship();  ///< 0.16 m tall, three fins, origin in its middle
[[nodiscard]] Model make_table();      ///< 0.17 m wide, 0.12 m tall
[[nodiscard]] Model make_statue();     ///< 0.16 m tall, on a pedestal
[[nodiscard]] Model make_bell();       ///< 0.11 m tall
[[nodiscard]] Model make_chair();      ///< 0.17 m tall
[[nodiscard]] Model make_castle();     ///< 0.16 m wide, two towers

// The Sun and its planets: balls of 1 m radius, north pole up; drawn at a body's radius.
[[nodiscard]] Model make_sun();
[[nodiscard]] Model make_mercury();
[[nodiscard]] Model make_venus();
[[nodiscard]] Model make_earth();
[[nodiscard]] Model make_mars();
[[nodiscard]] Model make_jupiter();
[[nodiscard]] Model make_saturn();  ///< with its rings, 2.27 m
[[nodiscard]] Model make_uranus();
[[nodiscard]] Model make_neptune();

// Of the lesson on levers.
[[nodiscard]] Model make_lever();  ///< beam of 1.16 m along x, a toy Earth on its left end; middle
[[nodiscard]] Model make_support();  ///< wedge under it, 0.3 m tall; the middle of its edge
[[nodiscard]] Model
make_handles();  ///< four spokes that lie crosswise, for turning a planet; 0.48 m across, 0.1 m tall; middle

// Of the maze park.
[[nodiscard]] Model make_walker();  ///< somebody in a straw hat, 0.07 m tall, origin at the feet
[[nodiscard]] Model make_gem();     ///< six-sided, 0.06 m tall; middle

}  // namespace fulcrum::assets
