-- The gravity game: catch what falls, feel what it weighs, say which one is the heaviest.
--
-- The answer key is the simulated physics: a body's weight is its mass times gravity. Change a mass below and the right
-- answers change with it.

local game = require "game"
local know = require "know"
local shelf = require "shelf"
local story = require "story"
local wait, wait_for = story.wait, story.wait_for

local L = lesson {
  id = "gravity", title = "Which one is the heaviest?", icon = "watermelon", order = 1, level = "A1", minutes = 10, free_english = true,
  feedback = { "recast", "prompt", "replay", "rule" },   -- of an error that comes again the bucket shows once more what is meant
}

-- Of what is not made of one material nobody can say what it is made of, nor how it feels.
know.things(L, { made_of = false, is_made_of = false, feel = false, is_it = false })
know.words(L, { "newton", "weight", "gravity", "force", "weigh", "bucket" })

-- True masses in kilograms. `exaggeration` makes the felt weights easy to tell apart; Fulcrum then shrinks all of them by
-- one factor until they fit under the arm's limit. With a limit of 10 N the apple weighs 6 N in the hand and the egg 3 N.
local names = { "watermelon", "apple", "banana", "egg" }
local fruit = {
  watermelon = { a = "a watermelon", mass = 3.0,    exaggeration = 0.3, radius = 0.095, drag_area = 0.013,
                 about = "A watermelon is full of water." },
  apple      = { a = "an apple",     mass = 0.2039, exaggeration = 3.0, radius = 0.04,  drag_area = 0.0024,
                 about = "Apples grow on trees." },
  banana     = { a = "a banana",     mass = 0.12,   exaggeration = 3.5, radius = 0.045, drag_area = 0.004,
                 about = "Bananas grow where it is hot." },
  egg        = { a = "an egg",       mass = 0.0612, exaggeration = 5.0, radius = 0.026, drag_area = 0.001,
                 about = "An egg comes from a bird." },
}

-- What falls in each level, and what is asked then. What was caught stands on a shelf. In the first level it shows at once what was felt of
-- it, so that newtons get a meaning; from the second on not before it is felt again, or the arrows would answer instead of the hand.
local levels = {
  { title = "Two things",   falls = { "apple", "egg" },                         asks = { "heavier" }, shows = true },
  { title = "Three things", falls = { "egg", "banana", "apple" },               asks = { "heaviest" } },
  { title = "Four things",  falls = { "banana", "watermelon", "egg", "apple" }, asks = { "heaviest", "lightest" } },
}

-- Where things fall from, one place after the other: left, right, middle …
local places = { -0.22, 0.2, 0.02, -0.12, 0.26, 0.1 }
local height = 1.05

local bodies = {}    -- name -> body
local in_play = {}   -- the bodies of this level
local next_place = 1

function L:start(world)
  world:gravity(9.81)
  world:ground(0)
  world:camera { eye = { 0, 1.0, 1.95 }, target = { 0, 0.45, 0 } }
  world:hand { centre = { 0, 0.3, 0 }, scale = 2 }
  world:bucket { model = "bucket", radius = 0.11, depth = 0.04 }
  world:body { name = "tree", noun = "", model = "tree", visible = true, at = { 0.95, 0, -1.3 } }
  world:body { name = "hill", noun = "", model = "hill", visible = true, at = { -1.5, -0.2, -5.5 } }
  world:body { name = "flower", noun = "", model = "flower", visible = true, at = { -0.6, 0, -0.3 } }
  for _, name in ipairs(names) do
    local f = fruit[name]
    bodies[name] = world:body {
      name = name, noun = name, model = name, movable = true,
      mass = f.mass, exaggeration = f.exaggeration, radius = f.radius, drag_area = f.drag_area, about = f.about,
    }
  end
  shelf.build(L, world, { at = { 0, 0.36, -0.3 } })
  game.play(L, world, function() play(world) end)
end

-- ---- physics is the answer key ------------------------------------------------------------------------------------

local function extreme(better)
  local best
  for _, body in ipairs(in_play) do
    if not best or better(body.weight, best.weight) then best = body end
  end
  return best
end

local function is_heavier(a, b) return a and b and a.weight > b.weight end

local function heaviest() return extreme(function(a, b) return a > b end) end
local function lightest() return extreme(function(a, b) return a < b end) end

-- ---- questions ----------------------------------------------------------------------------------------------------

L:question "heavier" {
  prompt = "Which one is heavier, the apple or the egg?",
  again = "Let's weigh both again.",
  answers = { "[the|a|an] {thing} is <comparative:heavy> [than [the|a|an] {other}]",
              "[the|a|an] {thing} is the <comparative:heavy> one", "the <comparative:heavy> one is [the|a|an] {thing}",
              "[the|a|an] {thing} has more weight [than [the|a|an] {other}]" },
  nearly = { "[the|a|an] {thing} is heavy more [than [the|a|an] {other}]", "[the|a|an] {thing} more heavy is [than [the|a|an] {other}]" },
  -- Of the two that are asked about; what else that one is heavier than may be said with it.
  right = function(a)
    local thing, other = bodies[a.thing], bodies[a.other]
    local asked = thing == bodies.apple and bodies.egg or thing == bodies.egg and bodies.apple
    return is_heavier(thing, asked) and (other == nil or is_heavier(thing, other))
  end,
  examples = { right = { "the apple weighs more", "the egg is not as heavy as the apple", "the egg isn't heavier",
                         "the apple is heavier than the other one" },
               wrong = { "the egg weighs more than the apple", "the apple isn't heavier", "they weigh the same", "neither is heavier",
                         "the apple is as heavy as the egg" },
               form = { "the apple weigh more", "the apple weight more", "the egg is not as heavy than the apple" } },
}

L:question "heaviest" {
  prompt = "Which one is the heaviest?",
  again = "Let's weigh them again.",
  answers = { "[a|an|the] {thing} is the <superlative:heavy> [one|thing|object|fruit]",
              "the <superlative:heavy> [one|thing|object|fruit] is [a|an|the] {thing}", "[a|an|the] {thing} has the most weight" },
  nearly = { "[a|an|the] {thing} is [the] heaviest [(one|thing|object|fruit)] (from|in|between) (all|them|all things)" },
  right = function(a) return bodies[a.thing] == heaviest() end,
  examples = { right = { "the watermelon weighs the most", "the watermelon is heavier than the others", "the others are not as heavy as the watermelon",
                         "nothing is heavier than the watermelon" },
               wrong = { "the apple weighs the most", "the watermelon isn't the heaviest", "they all weigh the same", "none of them" },
               form = { "the watermelon weigh the most", "the watermelon is heavier than others" } },
}

L:question "lightest" {
  prompt = "Which one is the lightest?",
  again = "Let's weigh them again.",
  answers = { "[a|an|the] {thing} is the <superlative:light> [one|thing|object|fruit]",
              "the <superlative:light> [one|thing|object|fruit] is [a|an|the] {thing}", "[a|an|the] {thing} has the least weight" },
  nearly = { "[a|an|the] {thing} is the less heavy", "[a|an|the] {thing} is [the] lightest [(one|thing|object|fruit)] (from|in|between) (all|them|all things)" },
  right = function(a) return bodies[a.thing] == lightest() end,
  examples = { right = { "the egg weighs the least", "the egg is lighter than the others", "the others are heavier than the egg" },
               wrong = { "the banana weighs the least", "the egg isn't the lightest", "they are equally light" } },
}

-- ---- the game -----------------------------------------------------------------------------------------------------

-- Lets a body fall until it is caught, then lets its weight be felt. Who misses it often is told how, then shown where to wait, and
-- in the end it is put into the bucket.
local tells_after, shows_after, gives_after = 3, 6, 10   -- times
local function catch(world, body, shows)
  local a = fruit[body.name].a
  local missed, event = 0, nil
  repeat
    local x = places[next_place]
    next_place = next_place % #places + 1
    world:caption(missed < tells_after and "Catch " .. a .. "!" or "Look where it falls. Move the bucket under it.")
    if missed >= shows_after then
      world:show_hand { at = { x, 0.3, 0.12 } }
      wait(2)
    end
    body:drop { at = { x, height, 0 } }
    event = wait_for { "caught", "landed", body = body }
    if event.name == "landed" then
      missed = missed + 1
      wait(1)
    end
  until event.name == "caught" or missed == gives_after
  world:hide_hand()
  if event.name == "caught" then
    game.point()
  else
    game.miss()
    body:hold()
  end
  world:caption("This is " .. a .. ". Feel how heavy it is.")
  wait(3)
  world:caption ""
  shelf.put(body, { hidden = not shows })
  wait(0.6)
end

-- Puts things into the bucket one after the other, so that the hand can compare them.
local function weigh(world, things)
  for _, body in ipairs(things) do
    world:caption("Feel " .. fruit[body.name].a .. ".")
    shelf.feel(body, 2.5)
    wait(0.8)
  end
end

-- What is weighed against the right one: what was said instead of it, where that was caught, else another thing.
local function contrast(answer, right)
  for _, body in ipairs(in_play) do
    if body ~= right and body == bodies[answer.thing] then return body end
  end
  return in_play[1] ~= right and in_play[1] or in_play[2]
end

-- After a wrong answer, and where the right one keeps an error of form, two things are weighed again.
local function ask(world, question, key)
  game.ask(question, {
    again = function(answer) weigh(world, { contrast(answer, key()), key() }) end,
    solution = function()
      return "The " .. key().noun .. " is " .. (question == "heavier" and question or "the " .. question) .. "."
    end,
  })
end

local function play_level(world, number)
  local level = levels[number]
  world:level(number, level.title)
  in_play = {}
  shelf.clear()
  for _, name in ipairs(level.falls) do in_play[#in_play + 1] = bodies[name] end
  for _, body in ipairs(in_play) do catch(world, body, level.shows) end
  for _, question in ipairs(level.asks) do
    ask(world, question, question == "lightest" and lightest or heaviest)
  end
end

function play(world)
  wait(1)
  next_place = 1
  for number = 1, #levels do play_level(world, number) end
end

L:test {
  hand = "catcher.lua",
  say = { "the apple is heavier than the egg", "watermelon is most heavy", "an apple is the heaviest",
          "watermelon is most heavy", "the egg is the lightest" },
  expect = { finished = true },
}

return L
