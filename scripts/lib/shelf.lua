--- A shelf on which things stand that are compared: in sight while a question about them is open, to be felt again at will, each with what
--- the hand felt of it.
---
---   local shelf = require "shelf"
---
---   function L:start(world)
---     world:bucket {}
---     …
---     shelf.build(L, world, { at = { 0, 0.36, -0.3 } })
---     game.play(L, world, function()
---       …                               -- an apple is caught, and felt
---       shelf.put(apple)
---       shelf.put(egg)
---       game.ask "heavier"
---       shelf.clear()
---     end)
---   end
---
--- Who goes to a thing with the hand while a question is open has it in the hand for some seconds; then it goes back. Beside each stands an
--- arrow, as long as the one under the hand was, with its newtons; `shelf.put(apple, { hidden = true })` keeps that back until the thing
--- has been felt again, so that first the hand and its memory answer.

-- What the program gives to the shared library: mistakes are told at the lesson's own line.
local module_name, program = ...
local mistake, shown = program.mistake, program.shown

local story = require "story"

local shelf = {}

local board_half, thick, post = 0.45, 0.025, 0.03   -- of the model "plank", and a post's side
local width = 0.72                                  -- of it, on which things stand
local low, high, beside = 0.04, 0.4, 0.085          -- metres above the board and beside a thing, within which a hand is at it
local felt_for = 3                -- seconds in the hand

local board                -- { x, y, z }, the middle of its upper side; nil before shelf.build
local places               -- for things, at most
local hand                 -- the world, for where the hand is
local standing = {}        -- bodies in their order
local place_of = {}        -- body -> { x, y, z }
local taken, left          -- the one in the hand, and for how many seconds more
local tired                -- the one that went back, until the hand has left it

local function check_built(called)
  if not board then mistake(called .. " needs a shelf; write shelf.build(L, world, { at = { 0, 0.36, -0.3 } }) in L:start") end
end

local function check_standing(called, body)
  check_built(called)
  if type(body) ~= "userdata" then mistake(called .. " takes a body; got " .. shown(body)) end
end

local function stand(body)
  body:place { at = place_of[body] }
end

-- Back to its place, and what was felt of it beside it.
local function put_back()
  stand(taken)
  taken:mark(taken.felt_weight)
  tired, taken = taken, nil
end

-- Is the hand at that place, as far as can be told from before it?
local function is_at(tool, place)
  return math.abs(tool.x - place[1]) < beside and tool.y > board[2] + low and tool.y < board[2] + high
end

local function look(dt)
  local tool = hand:tool()
  if taken then
    left = left - dt
    if left <= 0 then put_back() end
    return
  end
  if tired and not (place_of[tired] and is_at(tool, place_of[tired])) then tired = nil end
  for _, body in ipairs(standing) do
    if body ~= tired and is_at(tool, place_of[body]) then
      tired, taken, left = nil, body, felt_for
      body:hold()
      return
    end
  end
end

local build_options = { at = "table", places = "number" }

--- Builds it, 90 centimetres wide, in L:start, where nothing else is: `at` is the middle of its upper side, and `places` how many things
--- stand on it side by side (4).
---@param lesson Lesson
---@param world World
---@param options table
function shelf.build(lesson, world, options)
  if type(lesson) ~= "table" or type(world) ~= "userdata" or type(options) ~= "table" then
    mistake "write shelf.build(L, world, { at = { 0, 0.36, -0.3 } })"
  end
  for name, value in pairs(options) do
    if build_options[name] == nil then program.unknown("shelf.build", build_options, name) end
    if type(value) ~= build_options[name] then mistake("shelf.build's " .. name .. " is a " .. build_options[name] .. "; got " .. shown(value)) end
  end
  for i = 1, 3 do
    if type(options.at and options.at[i]) ~= "number" then mistake "shelf.build needs a place, at = { 0, 0.36, -0.3 }" end
  end
  places = options.places or 4
  if math.type(places) ~= "integer" or places < 1 or places > 12 then mistake("shelf.build's places are 1 to 12; got " .. shown(places)) end
  board, hand = options.at, world
  local x, y, z = board[1], board[2], board[3]
  world:body { name = "shelf-board", noun = "", model = "plank", visible = true, at = { x, y, z } }
  for side, name in pairs { [-1] = "shelf-left", [1] = "shelf-right" } do
    world:body { name = name, noun = "", model = "box", size = { post, y - thick, post }, visible = true,
      at = { x + side * (board_half - post), (y - thick) / 2, z } }
  end
  lesson:listen(function(event)
    if event.name ~= "update" or #standing == 0 then return end
    if story.is_asking() then
      look(event.dt)
    elseif taken then
      put_back()
    end
  end)
end

--- Puts a thing there, side by side with the others, and shows what was felt of it; with `hidden = true` not before it has been felt again.
---@param body Body
---@param options table|nil
function shelf.put(body, options)
  check_standing("shelf.put", body)
  if options ~= nil and type(options) ~= "table" then mistake("shelf.put's options are a table, such as { hidden = true }; got " .. shown(options)) end
  if not place_of[body] then
    if #standing == places then mistake("the shelf has " .. places .. " places, and all are taken; say shelf.build's places") end
    standing[#standing + 1] = body
  end
  local room = width / #standing
  for i, each in ipairs(standing) do
    local place = { board[1] + (i - (#standing + 1) / 2) * room, board[2] + each.radius, board[3] }
    place_of[each] = place
    if each == body or each.where == "placed" then stand(each) end
  end
  body:mark(options and options.hidden and 0 or body.felt_weight)
end

--- Puts a thing that stands there into the hand for so many seconds, inside a story; then it stands there again.
---@param body Body
---@param seconds number
function shelf.feel(body, seconds)
  check_standing("shelf.feel", body)
  if not place_of[body] then mistake("shelf.feel takes what stands there; put " .. body.name .. " there first, with shelf.put") end
  if taken then put_back() end
  body:hold()
  story.wait(seconds)
  stand(body)
  body:mark(body.felt_weight)
end

--- Takes everything away.
function shelf.clear()
  check_built "shelf.clear"
  for _, body in ipairs(standing) do
    body:mark(0)
    body:hide()
  end
  standing, place_of, taken, tired = {}, {}, nil, nil
end

return setmetatable(shelf, {
  __index = function(_, field) program.unknown(module_name, shelf, field) end,
})
