-- Blocks that lie, fall and are stacked: heavier and lighter, taller, on top of, under and between.
--
-- The answer key is the simulated world: what is heavier follows from the masses, what lies on what from where the blocks are.

local game = require "game"
local know = require "know"
local story = require "story"
local wait, wait_until, wait_with_help = story.wait, story.wait_until, story.wait_with_help

local L = lesson { id = "stacks", title = "Blocks", icon = "box", order = 7, level = "A1", minutes = 10, free_english = true }

know.things(L)
know.words(L, { "button", "newton", "tall", "tower", "weigh", "weight", lift = "To lift a thing is to move it up." })

local edge = 0.08             -- of the cubes, metres
local lifted = 0.04           -- so high above where it lay a block is lifted
local blocks = {
  { name = "wood", noun = "wooden block", material = "wood", mass = 0.1, size = { edge, edge, edge }, x = -0.2,
    about = "This block is made of wood, from a tree." },
  { name = "rock", noun = "stone block", material = "rock", mass = 0.2, size = { edge, 2 * edge, edge }, x = 0,
    about = "This block is made of rock. It is rough." },
  { name = "metal", noun = "metal block", material = "metal", mass = 0.35, size = { edge, edge, edge }, x = 0.2,
    about = "This block is made of metal. It is hard and smooth." },
}
local bodies = {}             -- by name and by noun
local height = {}             -- of each body, by name

function L:start(world)
  world:ground(0)
  world:camera { eye = { 0, 0.45, 1.1 }, target = { 0, 0.16, 0 }, angle = 40 }
  world:hand { centre = { 0, 0.22, 0 }, scale = 2, cursor = "ball", cursor_size = 0.008 }
  for _, block in ipairs(blocks) do
    local body = world:body {
      name = block.name, noun = block.noun, model = "box", size = block.size, rigid = true, mass = block.mass,
      material = block.material, about = block.about, at = { block.x, block.size[2] / 2, 0 },
    }
    bodies[block.name], bodies[block.noun] = body, body
    height[block.name] = block.size[2]
  end
  game.play(L, world, function() play(world) end)
end

-- ---- physics is the answer key ----------------------------------------------------------------------------------------

local function is_heavier(a, b) return a and b and a.mass > b.mass end
local function is_taller(a, b) return a and b and height[a.name] > height[b.name] end

local function is_on(a, b)
  local gap = (a.y - height[a.name] / 2) - (b.y + height[b.name] / 2)
  return math.abs(gap) < 0.004 and math.abs(a.x - b.x) < edge / 2 and math.abs(a.z - b.z) < edge / 2
end

local function is_between(a, b, c)
  return a and b and c and (a.x - b.x) * (a.x - c.x) < 0
end

-- ---- questions ----------------------------------------------------------------------------------------------------------

-- "The wooden block", "the wooden one", "the block of wood" or just "wood".
local called = { "wooden block|wooden one|wood", "stone block|stone one|rock block|rock one|block of rock|stone|rock", "metal block|metal one|metal" }

L:question "heavier" {
  prompt = "Which block is heavier: the wooden block or the metal block?",
  again = "Lift both again.",
  answers = { "[the|a] {thing} is <comparative:heavy> [than [the|a] {other}]",
              "[the|a] {thing} is the <comparative:heavy> one",
              "the <comparative:heavy> (one|block) is [the|a] {thing}" },
  lists = { thing = called, other = called },
  -- Of the two that are asked about; what else that one is heavier than may be said with it.
  right = function(a)
    local thing = bodies[a.thing]
    local asked = thing == bodies.wood and bodies.metal or thing == bodies.metal and bodies.wood
    return is_heavier(thing, asked) and (a.other == nil or is_heavier(thing, bodies[a.other]))
  end,
  examples = { right = { "The metal block is heavier.", "the metal one is heavier", "the metal one", "the block of metal", "metal is heavier",
                         "the wooden block is not as heavy as the metal block", "the wooden block isn't heavier" },
               wrong = { "the wooden block is heavier", "the stone block is heavier", "the stone block", "the wood block weighs more", "they weigh the same",
                         "the metal block isn't heavier", "the stone block isn't heavier" } },
}

L:question "taller" {
  prompt = "Which block is the tallest?",
  again = "Look at the blocks again.",
  answers = { "[the|a] {thing} is the <superlative:tall> [one|block]",
              "the <superlative:tall> [one|block] is [the|a] {thing}", "[the|a] {thing} is the (<superlative:high>|<superlative:big>) [one|block]",
              "[the|a] {thing} is <comparative:tall> than (the other (two|blocks|two blocks)|both other blocks)" },
  lists = { thing = called },
  right = function(a)
    local thing = bodies[a.thing]
    return is_taller(thing, bodies.wood) and is_taller(thing, bodies.metal)
  end,
  examples = { right = { "the block of stone", "the stone block is taller than the others", "the tallest is the rock block" },
               wrong = { "the wood block", "the stone block isn't the tallest", "they are equally tall" } },
}

L:question "between" {
  prompt = "Which block is between the wooden block and the metal block?",
  again = "Look from left to right.",
  answers = { "[the|a] {thing} is between <two>", "it is [the|a] {thing} [(that|which) is (between <two>|in the middle)]", "[the|a] {thing} is", "[the|a] {thing} (is|stands) (in the middle|in between)",
              "[the|a] {thing} stands between <two>", "the (block|one) in the middle is [the|a] {thing}", "between <two> is [the|a] {thing}", "there is [the|a] {thing} between <two>",
              "[the|a] {thing} (is|stands) between [the] {thing:first} and [the] {thing:second}", "[the] {thing} is {beside} (them|<two>)",
              "{none} [is between <two>]" },
  nearly = { "[the|a] {thing} is between [of] [they]", "[the|a] {thing} is (in|on) middle", "[the|a] {thing} is in [the] between",
             "[the|a] {thing} (stay|stays|stand) between <two>", "it is between [the] {thing}", "is [the] {thing}" },
  lists = { thing = called, none = { "neither|neither one|neither of them|none|none of them|nothing|no block" }, beside = { "next to|beside|near" } },
  rules = { two = "(them|them both|the two [blocks]|the two of them|the others|both [blocks]|the other (two|ones|blocks))" },
  right = function(a)
    if a.none or a.beside then return false end
    local first, second = bodies[a.first] or bodies.wood, bodies[a.second] or bodies.metal
    return first ~= second and (first == bodies.rock or second == bodies.rock) == false and is_between(bodies[a.thing], first, second)
  end,
}

-- "In the metal block", "on top the metal block", "under of it": another preposition than the right one is said back with the right one.
-- For that each of the three places has an answer of its own, with a slot of its own.
L:question "on_top" {
  prompt = "Where is the wooden block now?",
  again = "Look at both blocks.",
  answers = { "(it|the (wooden|wood) (block|one)) is {place} [the] {thing}", "{place} [the] {thing}", "(it|the (wooden|wood) (block|one)) (lies|stands|sits|rests) {place} [the] {thing}",
              "[<wooden> <is>] on top of the {thing:lower}", "[<wooden> <is>] on the top of the {thing:lower}", "[<wooden> <is>] below the {thing:upper}", "[<wooden> <is>] next to the {thing:side}", "[<wooden> <is>] (on|to) the {hand} of the {thing}",
              "[<wooden> <is>] {alone}", "[it <is>] {it}", "(I|we) put it {place} the {thing}", "(I|we) put it on top of the {thing:lower}",
              "[(it|the (wooden|wood) (block|one)) is] (at|on) the {end} [of the tower]", "[(it|the (wooden|wood) (block|one)) is] {elsewhere}",
              "[the] {bearer} is {placed} it", "[the] {bearer} is {under} the wooden (block|one)" },
  nearly = { "is {place} [the] {thing}", "is on top of [the] {thing:lower}", "is below [the] {thing:upper}", "is next to [the] {thing:side}",
             "[[<wooden>] is] (on top|on top from|on top to|on the top from|up|up of|up from|onto|in) [the] {thing:lower}",
             "[[<wooden>] is] (down|down of|down from|down to|below of|below from) [the] {thing:upper}",
             "[[<wooden>] is] (next|next of|next from|next by|next at|near of|near from|besides|besides of) [the] {thing:side}",
             "[[<wooden>] is] {place} (of|from|to) [the] {thing}", "<wooden> (lie|lay|lays|laid|stay|stays|stand) {place} [the] {thing}" },
  rules = { wooden = "(it|the (wooden|wood) (block|one))", is = "(is|lies|stands|sits|rests)" },
  lists = { place = { "on|above|over", "under|underneath|beneath", "beside|near", "inside", "in front of", "behind" },
            thing = called, bearer = { called[2], called[3] }, hand = { "left", "right" }, alone = { "on top", "below" }, it = { "on top of it", "below it", "next to it" },
            placed = { "under|below|underneath|beneath", "on top of|on|above|over" }, under = { "under|underneath|beneath", "on|above|over" }, ["end"] = { "top", "bottom" },
            elsewhere = { "on the ground|on the floor|on the table|on the grass", "in the middle|in between", "on the left|to the left", "on the right|to the right" } },
  right = function(a)
    local on_one = is_on(bodies.wood, bodies.metal) or is_on(bodies.wood, bodies.rock)
    if a["end"] or a.alone or a.it then
      return on_one == (a["end"] == "top" or a.alone == "on top" or a.it == "on top of it") and a.it ~= "next to it"
    end
    if a.side or a.hand then return false end
    local thing = a.thing or a.bearer
    local lower, upper = bodies[a.lower or thing], bodies[a.upper or thing]
    if lower == bodies.wood or upper == bodies.wood then return false end
    if a.lower or a.place == "on" or a.placed == "under" or a.under == "under" then return lower ~= nil and is_on(bodies.wood, lower) end
    return (a.upper or a.place == "under" or a.placed == "on top of" or a.under == "on") and upper ~= nil and is_on(upper, bodies.wood) or false
  end,
  examples = { right = { "on top", "on it", "it's on top of the block of metal", "at the top", "it stands on the metal block", "it lies on it", "it sits on it", "it rests on it",
                         "the metal block is under it" },
               wrong = { "under it", "below", "at the bottom", "it is not on the metal block", "on the stone block", "next to the metal block" },
               form = { "it is on metal block", "wooden block is on the metal block", "it is in the metal block", "on top the metal block", "is on the metal block",
                        "it is over of the metal block" } },
}

-- ---- the game -----------------------------------------------------------------------------------------------------------

-- Where the program's hand shows how a block goes to a place above which there is room.
local function way(from, to)
  local up = 0.12
  return { { from.x, from.y, edge }, { from.x, from.y, edge / 2 }, { from.x, from.y + up, edge / 2 }, { to.x, to.y + up, edge / 2 }, { to.x, to.y, edge / 2 } }
end

-- What a hand holds is never taken out of it.
local function let_go(world, body)
  repeat until wait_with_help(world, function() return body.where ~= "held" end, { hint = "Let go of the button." })
end

local function lift(world, body)
  local rest = height[body.name] / 2
  world:caption("Touch the " .. body.noun .. ", hold the button and lift it.")
  local done = wait_with_help(world, function() return body.where == "held" and body.y > rest + lifted end, {
    hint = "Go to the " .. body.noun .. " until you touch it. Hold the button, and go up.",
    show = function() return way(body, body) end,
  })
  if not done then
    game.miss()
    world:caption "Let's go on."
    return wait(2)
  end
  world:sound "pop"
  game.point()
  world:caption("Feel how heavy the " .. body.noun .. " is. Now put it down.")
  let_go(world, body)
  wait_until(function() return body.resting end, 5)
  world:caption ""
end

-- What has fallen out of reach or over comes back.
local function tidy_up(world)
  for _, block in ipairs(blocks) do
    let_go(world, bodies[block.name])
    bodies[block.name]:place { at = { block.x, block.size[2] / 2, 0 } }
  end
end

local function stack(world, top, bottom)
  world:caption("Put the " .. top.noun .. " on top of the " .. bottom.noun .. ".")
  local done = wait_with_help(world, function() return is_on(top, bottom) and top.where ~= "held" and top.resting end, {
    hint = "Hold the button on the " .. top.noun .. ". Lift it above the " .. bottom.noun .. ", and let go.",
    show = function() return way(top, { x = bottom.x, y = bottom.y + edge, z = bottom.z }) end, seconds = 90,
  })
  if done then game.point() else game.miss() end
  world:caption ""
  return done
end

function play(world)
  world:level(1, "Heavy and light")
  tidy_up(world)
  lift(world, bodies.wood)
  lift(world, bodies.metal)
  game.ask("heavier", { hint = "Which one pulls your hand down more?", solution = "The metal block is heavier." })
  tidy_up(world)
  game.ask("taller", { hint = "Which one goes up higher?", solution = "The stone block is the tallest." })
  game.ask("between", { hint = "One is on its left and one on its right.",
                        solution = "The stone block is between them." })
  world:level(2, "A tower")
  if not stack(world, bodies.wood, bodies.metal) then
    tidy_up(world)
    bodies.wood:place { at = { bodies.metal.x, 1.5 * edge, 0 } }
    wait(1)
  end
  game.ask("on_top", { hint = "Is it higher or lower than the metal block?",
                       solution = "It is on top of the metal block." })
end

L:test {
  hand = "stacker.lua",
  say = { "the metal block is heavier than the wooden block", "the stone block is the tallest",
          "the stone block is between them", "it is on top of the metal block" },
  expect = { finished = true, stars = 3 },
}

return L
