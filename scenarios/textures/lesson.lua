-- What is it made of? Metal, wood and rock: first seen and felt, then under a cloth, then as a spaceship, a table and a
-- statue.
--
-- The answer key is the material's physics: what is hard, rough or slippery is read off the numbers that the hand feels.
-- Give a block another material below and the right answers change with it.

local game = require "game"
local know = require "know"
local story = require "story"
local wait, wait_with_help = story.wait, story.wait_with_help

local L = lesson {
  id = "textures", title = "What is it made of?", icon = "cloth", order = 2, level = "A1", minutes = 12, free_english = true,
  feedback = { "recast", "prompt", "replay", "rule" },   -- when an error comes again, the hand strokes the block once more
}

know.words(L, { "stroke", "tap", lift = "To lift a thing is to move it up." })
know.things(L, { weight = false })   -- how heavy these are nobody felt

local names = { "metal", "wood", "rock" }

-- How else they are called; "it is wooden" says that it is made of wood.
local called = { "metal", "wood", "rock|stone" }
-- What a thing might be made of as well: understood, and wrong.
local guessed = { "metal", "wood", "rock|stone", "plastic", "glass", "paper", "rubber", "cloth", "gold" }
local materials = { metal = "metal", wooden = "wood", rock = "rock", plastic = "plastic", glass = "glass", rubber = "rubber", paper = "paper" }
local function said_material(a)
  local thing = a.whole or a.wooden
  return thing and materials[thing:match "^%a+"] or a.material
end

-- "Metal block", "wooden block": a thing with what it is made of.
local function with_materials(noun)
  local said = { "rock " .. noun .. "|stone " .. noun }
  for _, material in ipairs { "metal", "wooden", "plastic", "glass", "rubber", "paper" } do said[#said + 1] = material .. " " .. noun end
  return said
end

local adjectives = { "hard", "soft", "rough", "smooth", "slippery", "sticky" }

-- The things of the third level, and what each is made of.
local things = {
  { name = "spaceship", material = "metal", above = 0.096 },
  { name = "table",     material = "wood",  above = 0.062 },
  { name = "statue",    material = "rock",  above = 0.080 },
}

local thing_names = {}
for i, thing in ipairs(things) do thing_names[i] = thing.name end

local top = 0.3                     -- of the board on which everything stands
local places = { -0.2, 0, 0.2 }   -- left, middle, right
local side = 0.045                  -- half a side of a block

local blocks = {}      -- material's name -> block
local made = {}        -- thing's name -> body
local touched          -- the body under the hand
local felt = {}        -- body -> metres that the hand has stroked over it
local guide            -- the pull that leads the hand back
local star             -- hangs over what is to be felt: a mouse cannot be led

function L:start(world)
  world:ground(top - 0.025)
  world:camera { eye = { 0, 0.80, 0.80 }, target = { 0, 0.46, 0 }, angle = 36 }
  world:hand { centre = { 0, 0.46, 0 } }
  world:body { name = "board", noun = "", model = "plank", visible = true, at = { 0, top, 0 } }
  for i, name in ipairs(names) do
    blocks[name] = world:body {
      name = name, model = "box", radius = side, material = name,
      solid = true, movable = true, visible = true, at = { places[i], top + side, 0 },
      about = "A block of " .. name .. ". Stroke it, and tap it.",
    }
  end
  for i, thing in ipairs(things) do
    made[thing.name] = world:body {
      name = thing.name, model = thing.name, radius = thing.above, material = thing.material,
      solid = true, movable = true, at = { places[i], top + thing.above, 0 },
    }
    made[thing.name]:hide()
  end
  star = world:body { name = "star", model = "star", radius = 0.03 }
  guide = world:spring { name = "guide", at = { 0, 0.5, 0 }, stiffness = 40, damping = 4 }
  guide:off()
  game.play(L, world, function(round) play(world, round) end)
end

-- ---- what the hand feels --------------------------------------------------------------------------------------------

function L:touched(body) touched = body end
function L:released() touched = nil end

local last   -- where the hand was a frame ago

function L:update(world)
  local here = world:tool().position
  if touched and last then
    felt[touched] = (felt[touched] or 0) + math.sqrt((here.x - last.x) ^ 2 + (here.z - last.z) ^ 2)
  end
  last = here
end

-- Waits until the hand has stroked so much of it; the star shows which one that is.
local enough = 0.06
local function feel(world, body)
  star:place { at = { body.x, body.y + 0.13, body.z - 0.05 } }
  felt[body] = 0
  wait_with_help(world, function() return felt[body] >= enough end, {
    hint = "Go down until you touch it. Then go to the left and to the right.",
    show = { { body.x - 0.05, body.y + 0.12, body.z }, { body.x - 0.05, body.y + 0.05, body.z }, { body.x + 0.05, body.y + 0.05, body.z } },
  })
end

-- Nothing is put where a hand is: one that is lower than what will stand there is led up first, above everything.
local clear = top + 0.2
local function is_clear(world, coming)
  local hand = world:tool()
  for x, body in pairs(coming) do
    local near = math.max(math.abs(hand.x - x), math.abs(hand.z)) < body.radius + 0.05
    if near and hand.y < top + 2 * body.radius + 0.03 then return false end
  end
  return true
end

-- `coming`: what will stand where, by its x.
local function hands_off(world, coming)
  if not is_clear(world, coming) then
    world:caption "Lift your hand."
    guide:move { at = { 0, clear + 0.04, 0 } }
    guide:on()
    repeat   -- as long as it takes
    until wait_with_help(world, function() return is_clear(world, coming) end, {
      hint = "Go up, above everything.", show = { { 0, top + 0.1, 0 }, { 0, clear + 0.05, 0 } },
    })
    guide:off()
  end
  world:caption ""
end

-- Bodies by the x of the place where each stands, from the left.
local function at_places(bodies, in_order)
  local coming = {}
  for i, name in ipairs(in_order) do coming[places[i]] = bodies[name] end
  return coming
end

-- Leads the hand over a body and lets go of it there.
local function lead(world, body)
  world:caption "Come with me to the star."
  star:place { at = { body.x, body.y + 0.13, body.z - 0.05 } }
  local over = { body.x, body.y + 0.12, body.z }
  guide:move { at = over }
  guide:on()
  wait(1.5)
  guide:off()
end

-- ---- questions ------------------------------------------------------------------------------------------------------

-- Is all that was said true of that material?
local function all_true(material, ...)
  for _, said in ipairs { ... } do
    if not know.feels(material, said) then return false end
  end
  return true
end

-- What else is true of them, and nobody can feel here.
local also_true = {
  metal = { cold = true, shiny = true, grey = true, strong = true }, wood = { warm = true, brown = true, strong = true },
  rock = { cold = true, grey = true, bumpy = true, strong = true },
}

-- "Rougher than metal", by what the hand feels of both.
local degrees = { hard = "hardness", soft = "hardness", rough = "roughness", smooth = "roughness", slippery = "slipperiness", sticky = "slipperiness" }
local less = { soft = true, smooth = true, sticky = true }
local function is_more(adjective, one, other)
  if not (blocks[one] and blocks[other]) then return false end
  local more = blocks[one].material[degrees[adjective]] - blocks[other].material[degrees[adjective]]
  return less[adjective] and more < 0 or not less[adjective] and more > 0
end

for _, name in ipairs(names) do
  local own, others = {}, {}
  for _, words in ipairs(called) do table.insert(words:match "^%a+" == name and own or others, words) end
  L:question("like_" .. name) {
    prompt = "What is " .. name .. " like?",
    again = "Let's feel it again.",
    answers = { "{material} is <adjective:{feel}> [and <adjective:{feel:also}>]",
                "{material} (is|feels) <adjective:{feel}> [and <adjective:{feel:also}>]",
                "(it|this|this one) feels <adjective:{feel}> [and <adjective:{feel:also}>]",
                "{material} (is|feels) <three>", "(it|this|this one) (is|feels) <three>",
                "({material}|it|this) is a <adjective:{feel}> material", "{wrong} (is|feels) <adjective:{feel}> [and <adjective:{feel:also}>]",
                "({material}|it|this) (is|feels) <adjective:{feel}> like <something>", "({material}|it|this) can be <adjective:{feel}>",
                "({material}|it|this) (is|feels) <adjective:{extra}>", "({material}|it|this) (is|feels) <adjective:{extra}> and <adjective:{feel}>",
                "({material}|it|this) (is|feels) <adjective:{feel}> and <adjective:{extra}>",
                "{material} is <comparative:{feel:more}> than {wrong:other}", "(it|this) is <comparative:{feel:more}> than {wrong:other}",
                "not (as|so) <adjective:{feel:less}> as {wrong:other}" },
    nearly = { "(it|{material}) has {feel}" },
    lists = { material = own, wrong = others, feel = adjectives, extra = { "cold", "warm", "shiny", "grey", "brown", "strong", "bumpy" } },
    rules = { three = "<adjective:{feel}> [and] <adjective:{feel:also}> and <adjective:{feel:third}>",
              something = "(sandpaper|glass|ice|stone|a stone|wood|metal|a mirror|a wall|rubber)" },
    right = function(a)   -- "It is hard" says no material: then it is the one that was asked for
      if a.more then return is_more(a.more, a.material or a.wrong or name, a.other or name) and (a.material or a.wrong or name) == name end
      if a.less then return is_more(a.less, a.other, name) end
      if a.extra and not also_true[name][a.extra] then return false end
      return not a.wrong and all_true(blocks[name].material, a.feel, a.also, a.third)
    end,
  }
end

local hidden   -- the block that is asked for

L:question "under" {
  prompt = "What is under this cloth?",
  again = "Let's feel it again.",
  answers = { "<it> is {material}", "{material} [is under (the|this) cloth]", "<it> <made_of:{material}>", "<it> is {wooden}",
              "there is {material} [under (it|(the|this) cloth)]", "under (the|this) cloth [there] is {material}",
              "(it|this) feels like {material}", "(it|this) (must|could|might) be {material}", "it is something made of {material}",
              "(it|this|that) is [a|the] {whole}", "there is [a|the] {whole} [under (it|(the|this) cloth)]",
              "[a|the] {whole} [is under (it|(the|this) cloth)]" },
  nearly = { "under (the|this) cloth it is [a] {material}" },
  lists = { material = guessed, wooden = { "wooden" }, whole = with_materials "block" },
  right = function(a) return hidden and said_material(a) == hidden.material.name end,
  examples = { right = { "a metal block", "it's a block of metal", "it feels like metal", "the metal block is under the cloth" },
               wrong = { "it isn't metal", "a block of wood", "it is not made of metal", "not metal" },
               form = { "it is block of metal" } },
}

for _, thing in ipairs(things) do
  L:question("made_" .. thing.name) {
    prompt = "What is the " .. thing.name .. " made of?",
    again = "Let's feel it again.",
    answers = { "[a|an|the] {thing} <made_of:{material}>", "[(a|an|the)] {thing} is {wooden}",
                "it is {wooden}", "(it|this) is a {whole}", "(it|[the] {thing}) consists of {material}", "the material is {material}",
                "(it|[a|the] {thing}) (must|could|might) be [made of] {material}", "(they|people|we) (make|made) (it|[a|the] {thing}) (of|out of|from) {material}",
                "(they|people|we) make <things> (of|out of|from) {material}", "(it|[a|the] {thing}) is made (of|out of|from) <kind> {material}" },
    rules = { kind = "(brown|grey|old|real|solid|good|dark|thick)", things = thing.name .. "s" },
    lists = { thing = { "spaceship", "table", "statue" }, material = guessed, wooden = { "wooden" }, whole = with_materials(thing.name) },
    right = function(a)
      return (a.thing or thing.name) == thing.name and said_material(a) == made[thing.name].material.name
    end,
  }
end

-- ---- the game -------------------------------------------------------------------------------------------------------

-- "Metal is hard and smooth."
local function description_of(name)
  local m = blocks[name].material
  return name:sub(1, 1):upper() .. name:sub(2) .. " is " .. (know.feels(m, "hard") and "hard" or "soft") .. " and "
    .. (know.feels(m, "rough") and "rough" or "smooth") .. "."
end

-- After a wrong answer the hand is led back and feels again; after two there is a hint.
local function ask(world, question, body, hint, solution)
  game.ask(question, {
    again = function(answer)
      lead(world, body)
      world:caption("Feel it again." .. (not answer.right and answer.attempt >= 2 and " " .. hint or ""))
      feel(world, body)
    end,
    solution = solution,
  })
  star:hide()
end

local function seen(world)
  world:level(1, "Look and feel")
  for _, name in ipairs(names) do
    world:caption("This is " .. name .. ". Tap it and stroke it.")
    feel(world, blocks[name])
    ask(world, "like_" .. name, blocks[name], "Is it hard? Is it rough?", description_of(name))
  end
end

-- The three blocks in another order, the same in every play of a test.
local function shuffle()
  local order = { 1, 2, 3 }
  for i = #order, 2, -1 do
    local j = math.random(i)
    order[i], order[j] = order[j], order[i]
  end
  for i, name in ipairs(names) do
    blocks[name]:place { at = { places[order[i]], top + side, 0 } }
  end
end

local function under_a_cloth(world)
  world:level(2, "Under a cloth")
  hands_off(world, at_places(blocks, names))
  for _, name in ipairs(names) do blocks[name]:cover() end
  shuffle()
  wait(1.5)
  for turn, name in ipairs { "rock", "metal" } do
    hidden = blocks[name]
    lead(world, hidden)
    world:caption(turn == 1 and "Feel what is under this cloth." or "And under this cloth? Feel it.")
    feel(world, hidden)
    ask(world, "under", hidden, "Is it rough or smooth?", "It is " .. hidden.material.name .. ".")
    hands_off(world, { [hidden.x] = hidden })
    hidden:uncover()
    world:sound "pop"
    wait(1)
  end
end

local function things_made(world)
  world:level(3, "Things")
  hands_off(world, at_places(made, thing_names))
  for _, name in ipairs(names) do blocks[name]:hide() end
  for i, thing in ipairs(things) do
    made[thing.name]:place { at = { places[i], top + thing.above, 0 } }
  end
  wait(1)
  for _, thing in ipairs(things) do
    local body = made[thing.name]
    world:caption("This is a " .. thing.name .. ". Feel it.")
    feel(world, body)
    ask(world, "made_" .. thing.name, body, "Is it metal, wood or rock?",
      "The " .. thing.name .. " is made of " .. body.material.name .. ".")
  end
end

local function begin_again()
  for _, thing in ipairs(things) do made[thing.name]:hide() end
  for i, name in ipairs(names) do
    blocks[name]:uncover()
    blocks[name]:place { at = { places[i], top + side, 0 } }
  end
end

function play(world, round)
  if round > 1 then
    hands_off(world, at_places(blocks, names))
    begin_again()
  end
  seen(world)
  under_a_cloth(world)
  things_made(world)
end

L:test {
  hand = "stroker.lua",
  say = { "metal is hard and smooth", "wood is hard and rough", "rock is hard and rough",
          "it is rock", "it is metal",
          "a spaceship is made of metal", "a table is made of wood", "a statue is made of rock" },
  expect = { finished = true, stars = 3, form_errors = 0 },
}

return L
