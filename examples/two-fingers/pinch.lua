-- A simulated finger at one side of the wooden block, 1 for the right one and -1 for the left one: both do the same at the same time,
-- and so lift it, turn it and put it on the stone block. A finger that is alone grips with its button.
local motion = require "motion"

local half, radius = 0.03, 0.008
local beside, inside = 0.03, -0.010   -- of the surface: before the squeeze, and in it
local steps, degrees = 10, 35

local function pinch(side, world)
  local wood, rock = world:find "wood", world:find "rock"
  -- Where the finger is when the block's middle is there, turned by so much.
  local function at(x, y, gap, turn)
    local out = side * (half + radius + gap)
    return { x + out * math.cos(turn), y + out * math.sin(turn), 0 }
  end
  local x, y = wood.x, wood.y
  motion.move_to(at(x, y, beside, 0), 1)
  motion.move_to(at(x, y, inside, 0), 0.8)
  motion.wait(0.3)
  motion.move_to(at(x, y + 0.13, inside, 0), 2.5)
  motion.wait(1)
  for _, way in ipairs { 1, -1 } do
    for i = 1, steps do
      local share = way > 0 and i / steps or 1 - i / steps
      motion.move_to(at(x, y + 0.13, inside, math.rad(degrees * share)), 0.15)
    end
    motion.wait(0.5)
  end
  motion.move_to(at(rock.x, y + 0.13, inside, 0), 5)
  motion.wait(0.5)
  motion.move_to(at(rock.x, rock.y + 2 * half + 0.001, inside, 0), 3)
  motion.wait(0.3)
  motion.move_to(at(rock.x, rock.y + 2 * half, beside, 0), 0.8)
end

local function grip(world)
  local wood, rock = world:find "wood", world:find "rock"
  motion.move_to({ wood.x, wood.y + half + 0.06, 0 }, 0.8)
  motion.move_to({ wood.x, wood.y + half + radius - 0.003, 0 }, 0.6)
  motion.press(1)
  motion.wait(0.3)
  local x, y = motion.place()
  motion.move_to({ x, y + 0.12, 0 }, 1.2)
  motion.wait(0.5)
  motion.move_to({ rock.x, y + 0.12, 0 }, 1.2)
  motion.wait(0.4)
  motion.move_to({ rock.x, y + 2 * half, 0 }, 1.2)
  motion.wait(0.4)
  motion.press(0)
  motion.wait(0.3)
  motion.move_to({ rock.x, y + 0.12, 0 }, 0.6)
end

return function(side)
  return motion.play(function(world)
    motion.start_at { side * 0.1, 0.12, 0 }
    motion.wait(3)
    if world.hands > 1 then pinch(side, world) else grip(world) end
  end)
end
