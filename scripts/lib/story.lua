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
--- An event that comes while nobody waits for it is gone: wait for it right after you ask for it.
--- Two stories may run side by side.

local story = {}

--- Waits so many seconds.
---@param seconds number
function story.wait(seconds)
  local left = seconds
  while left > 0 do
    local event = coroutine.yield()
    if event.name == "update" then left = left - event.dt end
  end
end

--- Waits until test() gives true; test is tried once a frame.
---@param test fun(): any
function story.wait_until(test)
  while not test() do
    repeat local event = coroutine.yield() until event.name == "update"
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

local known = { caught = true, landed = true, touched = true, released = true, key = true, answered = true }

--- Waits for an event and gives it; nil when the timeout (in seconds) came first.
---   wait_for "caught"                                   any of this name
---   wait_for("caught", "landed")                        one of several
---   wait_for { "caught", body = apple, timeout = 10 }   only if its fields are so
---@return table|nil event  event.name, and as the event has it: body, speed, key, question, said, right, …
function story.wait_for(...)
  local wanted = ...
  if type(wanted) ~= "table" then wanted = { ... } end
  if #wanted == 0 then error("wait_for needs the name of an event, such as \"caught\"", 2) end
  for i = 1, #wanted do
    if not known[wanted[i]] then
      error("wait_for knows caught, landed, touched, released, key and answered; not " .. tostring(wanted[i]), 2)
    end
  end
  local left = wanted.timeout
  while true do
    local event = coroutine.yield()
    if fits(event, wanted) then return event end
    if event.name == "update" and left then
      left = left - event.dt
      if left <= 0 then return nil end
    end
  end
end

--- Asks a question and waits for the answer.
---@param world World
---@param question string
---@return table answer  said, understood, right, form_right, attempt, and the slots of the template
function story.ask(world, question)
  world:ask(question)
  return story.wait_for { "answered", question = question }
end

-- story(L, function() … end) begins telling at once and goes on with each event.
return setmetatable(story, {
  __call = function(_, lesson, tell)
    if type(tell) ~= "function" then error("write story(L, function() … end)", 2) end
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
