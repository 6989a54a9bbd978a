--- A lesson told from top to bottom, instead of in many small callbacks.
---
---   local story = require "story"
---   local wait, wait_for = story.wait, story.wait_for
---
---   function L:start(world)
---     …
---     story(L, function()
---       world:caption "Catch the apple!"
---       apple:drop { at = { 0, 1, 0 } }
---       local event = wait_for { "caught", "landed", body = apple, timeout = 10 }
---       if event and event.name == "caught" then world:caption "Well done!" end
---       wait(2)
---     end)
---   end
---
--- `story(L, function() … end)` begins telling at once and goes on with each event. An event that comes while nobody waits
--- for it is gone: wait for it right after you ask for it. Two stories may run side by side.

-- What the program gives to the shared library: mistakes are told at the lesson's own line.
local module_name, program = ...
local mistake, shown = program.mistake, program.shown

local story = {}

-- Gives the rest of the story to the program until the next event.
local function next_event(called)
  if not coroutine.isyieldable() then mistake(called .. " belongs inside story(L, function() … end)") end
  return coroutine.yield()
end

local function check_seconds(called, seconds)
  if type(seconds) ~= "number" then mistake(called .. " takes seconds; got " .. shown(seconds)) end
end

--- Waits so many seconds.
---@param seconds number
function story.wait(seconds)
  check_seconds("story.wait", seconds)
  local left = seconds
  while left > 0 do
    local event = next_event "story.wait"
    if event.name == "update" then left = left - event.dt end
  end
end

local function check_test(called, test)
  if type(test) ~= "function" then mistake(called .. " takes a function; got " .. shown(test)) end
end

-- Lets a frame go by, and gives how long it was.
local function next_frame(called)
  while true do
    local event = next_event(called)
    if event.name == "update" then return event.dt end
  end
end

--- Waits until `test()` gives true, tried once a frame, or so many seconds have gone by (nil: for ever). Gives whether it
--- became true.
---@param test fun(): any
---@param seconds number|nil
---@return boolean
function story.wait_until(test, seconds)
  check_test("story.wait_until", test)
  if seconds ~= nil then check_seconds("story.wait_until's second value", seconds) end
  local left = seconds
  while not test() do
    if left and left <= 0 then return false end
    local dt = next_frame "story.wait_until"
    left = left and left - dt
  end
  return true
end

local help_options = { hint = "string", show = "table", seconds = "number", again = "boolean" }
local hint_after, show_after, left_after = 20, 40, 60   -- seconds, of which the learner has nothing to do with the lesson's own waiting
local in_vain, most_in_vain = 0, 2                      -- how often running nothing was done, and of that what counts
local way_seconds, stay_seconds = 1.2, 0.6              -- from one place to the next, and there

local function check_help(called, help)
  if type(help) ~= "table" then
    mistake(called .. " takes a table of help, such as { hint = \"Press here.\", show = { { 0, 0.3, 0 } } }; got " .. shown(help))
  end
  for name, value in pairs(help) do
    if help_options[name] == nil then program.unknown(called, help_options, name) end
    if type(value) ~= help_options[name] and not (name == "show" and type(value) == "function") then
      mistake(called .. "'s " .. name .. " is a " .. (help_options[name] == "string" and "text" or help_options[name])
        .. "; got " .. shown(value))
    end
  end
end

-- Where the program's hand is after so many seconds of going round between the places, and staying at each.
local function place_on_way(places, seconds)
  local each = way_seconds + stay_seconds
  local step = math.floor(seconds / each)
  local from, to = places[step % #places + 1], places[(step + 1) % #places + 1]
  local share = math.min(math.max(seconds - step * each - stay_seconds, 0) / way_seconds, 1)
  share = share * share * (3 - 2 * share)
  return { from[1] + share * (to[1] - from[1]), from[2] + share * (to[2] - from[2]), from[3] + share * (to[3] - from[3]) }
end

--- Waits until the learner has done something, and never for ever: after 20 seconds `hint` is said, after 40 the program's own hand
--- goes along the places of `show` as the learner's should, and after 60 (or `seconds`) it gives false: then do it for the learner, or
--- go on without. Where things may have moved, `show` is a function that gives the places of now.
--- Who was helped just before (`again`) is shown at once. Who let that time go by the last time is helped after half of it, and then
--- after a quarter, until something is done.
---
---   local done = story.wait_with_help(world, function() return ball.y > 0.3 end, {
---     hint = "Hold the button on the ball, and go up.",
---     show = { { 0, 0.1, 0 }, { 0, 0.4, 0 } },
---   })
---@param world World
---@param test fun(): any
---@param help table
---@return boolean
function story.wait_with_help(world, test, help)
  if type(world) ~= "userdata" then mistake("story.wait_with_help takes the world first; got " .. shown(world)) end
  check_test("story.wait_with_help", test)
  check_help("story.wait_with_help", help)
  local hurry = 2 ^ in_vain
  local passed, hinted, shows = help.again and show_after or 0, help.again, false
  local last = help.seconds or left_after
  local done = test()
  while not done and passed < last do
    passed = passed + hurry * next_frame "story.wait_with_help"
    done = test()
    if not done and help.hint and not hinted and passed >= hint_after then
      hinted = true
      world:caption(help.hint)
    end
    if not done and help.show and passed >= show_after then
      shows = true
      local places = type(help.show) == "function" and help.show() or help.show
      world:show_hand { at = place_on_way(places, (passed - show_after) / hurry) }
    end
  end
  if shows then world:hide_hand() end
  in_vain = done and 0 or math.min(in_vain + 1, most_in_vain)
  return done and true or false
end

--- Waits until `test()` has been true for so many seconds in all, or twice as many have gone by: long enough to show something
--- that is only seen while the hand presses, and no longer when it lets go.
---@param test fun(): any
---@param seconds number
function story.wait_while(test, seconds)
  check_test("story.wait_while", test)
  check_seconds("story.wait_while's second value", seconds)
  local held, passed = 0, 0
  while held < seconds and passed < 2 * seconds do
    local dt = next_frame "story.wait_while"
    passed = passed + dt
    if test() then held = held + dt end
  end
end

-- What an event has, by its name; an answer's slots come on top.
local fields = {
  caught = { body = "userdata", speed = "number" },
  landed = { body = "userdata", speed = "number" },
  touched = { body = "userdata" },
  released = { body = "userdata" },
  key = { key = "string" },
  answered = false,
}
local names = "caught, landed, touched, released, key and answered"

local function check_field(wanted, field)
  local value = wanted[field]
  if field == "timeout" then
    if type(value) ~= "number" then mistake("story.wait_for's timeout is seconds; got " .. shown(value)) end
    return
  end
  for i = 1, #wanted do
    local has = fields[wanted[i]]
    if not has or type(value) == has[field] then return end
  end
  mistake("story.wait_for: no event \"" .. wanted[1] .. "\" has " .. tostring(field) .. " = " .. shown(value)
    .. "; an event has body, speed or key, and timeout is in seconds")
end

local function check_wanted(wanted)
  if #wanted == 0 then mistake "story.wait_for takes the name of an event, such as \"caught\"; got nothing" end
  for i = 1, #wanted do
    if fields[wanted[i]] == nil then
      mistake("story.wait_for knows " .. names .. "; got " .. shown(wanted[i]))
    end
    program.awaits(wanted[i])
  end
  for field in pairs(wanted) do
    if type(field) == "string" then check_field(wanted, field) end
  end
end

-- Does the event have one of the wanted names, and every field that is asked for?
local function fits(event, wanted)
  local named = false
  for i = 1, #wanted do
    if event.name == wanted[i] then named = true end
  end
  if not named then return false end
  for field, value in pairs(wanted) do
    if type(field) == "string" and field ~= "timeout" and event[field] ~= value then return false end
  end
  return true
end

--- Waits for an event and gives it; gives nil when the timeout (in seconds) came first.
---
---   wait_for "caught"                                   -- any of this name
---   wait_for("caught", "landed")                        -- one of several
---   wait_for { "caught", body = apple, timeout = 10 }   -- only if its fields are so
---   wait_for { "key", key = "space" }
---
--- The events and their fields stand under "Events".
---@return table|nil event
function story.wait_for(...)
  local wanted = ...
  if type(wanted) ~= "table" then wanted = { ... } end
  check_wanted(wanted)
  local left = wanted.timeout
  while true do
    local event = next_event "story.wait_for"
    if fits(event, wanted) then return event end
    if event.name == "update" and left then
      left = left - event.dt
      if left <= 0 then return nil end
    end
  end
end

local n_asking = 0   -- stories that wait for an answer

--- Does a story wait for the answer to a question just now?
---@return boolean
function story.is_asking() return n_asking > 0 end

--- Asks a question and waits until the answer has been marked and answered to; a wrong answer is an answer too: ask again
--- until `answer.over`.
---@param world World
---@param question string
---@return Answer answer
function story.ask(world, question)
  if type(world) ~= "userdata" or type(question) ~= "string" then
    mistake("story.ask takes the world and the name of a question, story.ask(world, \"heaviest\"); got "
      .. shown(world) .. " and " .. shown(question))
  end
  world:ask(question)
  n_asking = n_asking + 1
  local answer = story.wait_for { "answered", question = question }
  n_asking = n_asking - 1
  return answer
end

return setmetatable(story, {
  __index = function(_, field) program.unknown(module_name, story, field) end,
  __call = function(_, lesson, tell)
    if type(lesson) ~= "table" or type(tell) ~= "function" then mistake "write story(L, function() … end)" end
    local telling = coroutine.create(tell)
    local function go_on(event)
      if coroutine.status(telling) == "dead" then return end
      local fine, problem = coroutine.resume(telling, event)
      if not fine then error(problem, 0) end
    end
    lesson:listen(go_on)
    go_on()
  end,
})
