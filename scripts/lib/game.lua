--- A game of questions, points and stars, as most lessons are.
---
---   local game = require "game"
---
---   function L:start(world)
---     …
---     game.play(L, world, function()
---       world:level(1, "Near or far?")
---       lift_it()
---       game.point()
---       game.ask("near_far", { hint = "Press at both places. Where do you need less force?" })
---     end)
---   end
---
--- It tells its function as a story (see `story`: `wait` and `wait_for` belong in it too). When that ends there are stars:
--- three for all points that could be had, two for three quarters of them, else one. `game` itself counts what could be
--- had. Then it may be played again.

-- What the program gives to the shared library: mistakes are told at the lesson's own line.
local module_name, program = ...
local mistake, shown = program.mistake, program.shown

local story = require "story"

local game = {}

local points_a_question = 3   -- one less for each wrong try, one at least
local two_stars = 0.75        -- of all points

local scene                   -- the world that is played in; nil before game.play
local score, best = 0, 0

local function check_playing(called)
  if not scene then mistake(called .. " belongs inside game.play(L, world, function() … end)") end
end

local function add(points, of)
  score, best = score + points, best + of
  scene:score(score)
end

local function check_points(called, points)
  if points ~= nil and (math.type(points) ~= "integer" or points < 1) then
    mistake(called .. " takes a whole number of points, 1 or more; got " .. shown(points))
  end
end

--- Gives a point, or several: for something caught, lifted, found.
---@param points integer|nil 1 by default
function game.point(points)
  check_playing "game.point"
  check_points("game.point", points)
  add(points or 1, points or 1)
end

--- Says that a point could have been had and was not: for something that fell, that was not lifted.
---@param points integer|nil 1 by default
function game.miss(points)
  check_playing "game.miss"
  check_points("game.miss", points)
  add(0, points or 1)
end

local type_words = { string = "text", ["function"] = "function" }
local ask_options = { hint = "string", again = "function", solution = "string" }

local function check_options(options)
  if type(options) ~= "table" then
    mistake("game.ask's options are a table, such as { hint = \"Look again.\" }; got " .. shown(options))
  end
  for name, value in pairs(options) do
    if ask_options[name] == nil then program.unknown("game.ask", ask_options, name) end
    if type(value) ~= ask_options[name] and not (name == "solution" and type(value) == "function") then
      mistake("game.ask's " .. name .. " is a " .. type_words[ask_options[name]] .. "; got " .. shown(value))
    end
  end
end

--- Asks a question until its meaning is right or it is left after many tries, and gives the last answer: three points, one
--- less for each wrong try. After a wrong one `hint` is said, and `again` lets the hand feel it once more.
---
---   game.ask "near_far"
---   game.ask("near_far", {
---     hint = "Press at both places. Where do you need less force?",
---     again = function(answer) press_at_both_places() end,
---     solution = "It is easier far from the support.",
---   })
---
--- `solution`, a text or a function that gives one, is said when the last try was wrong too, so that nobody is left without it.
--- Where the ladder of feedback has "replay", `again` lets the hand feel it after a right answer with an error of form, too.
---@param question string
---@param options table|nil
---@return Answer answer
function game.ask(question, options)
  check_playing "game.ask"
  options = options or {}
  check_options(options)
  local points, answer = points_a_question, nil
  repeat
    answer = story.ask(scene, question)
    if answer.understood and not answer.right and not answer.over then
      points = math.max(points - 1, 1)
      story.wait(2)
      -- "Metal is made of a spaceship": nothing to feel again, only to say.
      if not answer.turned_round then
        if options.hint then
          scene:caption(options.hint)
          story.wait(3)
        end
        if options.again then options.again(answer) end
      end
    end
  until answer.over
  add(answer.right and points or 0, points_a_question)
  story.wait(2.5)
  if answer.right and answer.replay and options.again then options.again(answer) end
  local solution = not answer.right and options.solution
  if solution then
    scene:caption(type(solution) == "function" and solution() or solution)
    story.wait(5)
  end
  scene:caption ""
  return answer
end

--- Tells a game as a story, gives its stars, and plays it again when the learner wants to (by the screen's choice, or the space bar); `tell` is given how often it has been
--- begun, 1 at first.
---@param lesson Lesson
---@param world World
---@param tell fun(round: integer)
function game.play(lesson, world, tell)
  if type(lesson) ~= "table" or type(world) ~= "userdata" or type(tell) ~= "function" then
    mistake "write game.play(L, world, function() … end)"
  end
  scene = world
  story(lesson, function()
    story.wait(1.5)
    local round = 0
    while true do
      round = round + 1
      score, best = 0, 0
      world:score(0)
      tell(round)
      world:caption(best > 0 and ("Points: %d of %d."):format(score, best) or "")
      world:finish { stars = score >= best and 3 or score >= two_stars * best and 2 or 1 }
      story.wait_for { "key", key = "space" }
    end
  end)
end

return setmetatable(game, {
  __index = function(_, field) program.unknown(module_name, game, field) end,
})
