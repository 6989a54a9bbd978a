--- What a learner may ask about the things of a scene while no question is open, answered from the simulation: what it is, what it is
--- made of, how heavy it is, how it feels.
---
---   local know = require "know"
---   know.things(L)                        -- at the top of the file
---   know.things(L, { weight = false })    -- not what the lesson is about to ask
---
--- "It" and "this" are what the hand holds, else what it touches or touched last. Other things a lesson tells by L:knows.

local module_name, program = ...
local mistake, shown = program.mistake, program.shown

local know = {}

local function upper(text) return (text:gsub("^%l", string.upper)) end

local function with_article(noun)
  return (noun:match "^[aeiou]" and "an " or "a ") .. noun
end

local nothing_yet = "Take something in your hand, or touch it. Then ask me."

-- The body that is asked about; nil where the hand has met none.
local function meant(asked, world)
  if asked.bodies.thing then return asked.bodies.thing end
  for _, body in ipairs(world:bodies()) do
    if body.where == "held" then return body end
  end
  return world.touched
end

local function called(asked, body)
  return asked.bodies.thing and "The " .. body.noun or "It"
end

local adjectives = { hard = true, soft = true, rough = true, smooth = true, slippery = true, sticky = true }

--- Is that adjective true of a material: "hard", "soft", "rough", "smooth", "slippery" or "sticky"?
---@param material Material
---@param adjective string
---@return boolean
function know.feels(material, adjective)
  if type(material) ~= "userdata" then mistake("know.feels takes a material, such as body.material; got " .. shown(material)) end
  if adjectives[adjective] == nil then program.unknown("know.feels", adjectives, adjective) end
  return material.words[adjective] == true
end

-- What can truly be said of a material, two words: hard and smooth.
local function feel_of(material)
  return material.words.hard and "hard" or "soft", material.words.rough and "rough" or "smooth"
end

local known = {
  this = {
    asked = { "what is (this|that|it) [called]", "what am I (holding|touching)", "what do I have [in my hand]" },
    nearly = { "what (this|that|it) [is] [called]", "what (is|are) (I|you) (holding|touching)",
               "what I (am holding|am touching|hold|touch|have) [in my hand]" },
    answer = function(asked, world)
      local body = meant(asked, world)
      if not body then return nothing_yet end
      if body.covered then return "I can't see it. Feel it!" end
      -- A block of metal that is called so: "This is metal."
      local is_material = body.material and body.material.name == body.noun
      return ("This is %s."):format(is_material and body.noun or with_article(body.noun))
    end,
  },
  made_of = {
    asked = { "what is (it|this|that) made (of|from)", "what is [the|a|an] {thing} made (of|from)",
              "what material is (it|this|that)" },
    nearly = { "what (it|this|that) is (made|make) [of|from|by]", "what is (it|this|that) (make (of|from|by)|made by|made)",
               "what [is] [the|a|an] {thing} (make (of|from|by)|made by|made)", "what [the|a|an] {thing} is (made|make) [of|from|by]",
               "what material (it|this|that) [is]", "what material has (it|this|that)" },
    answer = function(asked, world)
      local body = meant(asked, world)
      if not body then return nothing_yet end
      if body.covered then return "I can't see it. Feel it!" end
      return body.material and ("%s is made of %s."):format(called(asked, body), body.material.name)
    end,
  },
  weight = {
    asked = { "how heavy is (it|this|that)", "how heavy is [the|a|an] {thing}", "how much does (it|this|that) weigh",
              "how much does [the|a|an] {thing} weigh", "what is the weight of (it|this|that)" },
    nearly = { "how heavy (it|this|that) [is]", "how heavy [the|a|an] {thing} [is]", "how much (it|this|that) (weigh|weighs)",
               "how much [the|a|an] {thing} (weigh|weighs)", "how (much|many) (do|does) (it|this|that) (weighs|weight)",
               "how (much|many) (do|does) [the|a|an] {thing} (weighs|weight)", "what weight (is|has) (it|this|that)" },
    answer = function(asked, world)
      local body = meant(asked, world)
      -- A body of which nobody said what it weighs has a kilogram, and no hand can carry it.
      if body and body.mass == 1 and body.felt_weight == 0 then return nil end
      return body and ("%s weighs %.1f newtons."):format(called(asked, body), body.weight) or nothing_yet
    end,
  },
  feel = {
    asked = { "how does (it|this|that) feel", "how does [the|a|an] {thing} feel", "what is (it|this|that) like",
              "what is [the|a|an] {thing} like" },
    nearly = { "how (it|this|that) (feel|feels)", "how [the|a|an] {thing} (feel|feels)", "how (do|does|is) (it|this|that) feels",
               "how (do|does|is) [the|a|an] {thing} feels" },
    answer = function(asked, world)
      local body = meant(asked, world)
      if not body then return nothing_yet end
      return body.material and ("%s is %s and %s."):format(called(asked, body), feel_of(body.material))
    end,
  },
  is_it = {
    asked = { "is (it|this|that) <adjective:{feel}>", "is [the|a|an] {thing} <adjective:{feel}>" },
    nearly = { "(do|does) (it|this|that) {feel}", "(do|does) [the|a|an] {thing} {feel}" },
    lists = { feel = { "hard", "soft", "rough", "smooth", "slippery", "sticky" } },
    answer = function(asked, world)
      local body = meant(asked, world)
      if not body then return nothing_yet end
      if not body.material then return nil end
      return know.feels(body.material, asked.feel) and "Yes, it is." or "No, it isn't."
    end,
  },
}

local order = { "this", "made_of", "weight", "feel", "is_it" }

--- Lets a learner ask about the scene's things. Options leave some of it out: `this`, `made_of`, `weight`, `feel`, `is_it`, each
--- true by default.
---@param lesson Lesson
---@param options table|nil
function know.things(lesson, options)
  if type(lesson) ~= "table" then mistake("know.things takes the lesson, know.things(L); got " .. shown(lesson)) end
  options = options or {}
  if type(options) ~= "table" then mistake("know.things's options are a table, such as { weight = false }; got " .. shown(options)) end
  for name, value in pairs(options) do
    if known[name] == nil then program.unknown("know.things", known, name) end
    if type(value) ~= "boolean" then mistake("know.things's " .. name .. " is true or false; got " .. shown(value)) end
  end
  for _, name in ipairs(order) do
    if options[name] ~= false then lesson:knows(name)(known[name]) end
  end
end

return setmetatable(know, {
  __index = function(_, field) program.unknown(module_name, know, field) end,
})
