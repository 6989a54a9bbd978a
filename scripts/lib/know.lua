--- What a learner may ask about the things of a scene while no question is open, answered from the simulation: what it is, what it is
--- made of, how heavy it is, how it feels.
---
---   local know = require "know"
---   know.things(L)                        -- at the top of the file
---   know.things(L, { weight = false })    -- not what the lesson is about to ask
---   know.words(L, { "lever", "torque" })  -- what the lesson's words mean
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

-- Where what a thing is called by comes from, if it is called by what it is made of: a block of wood that is just "wood".
local comes_from = {
  wood = "Wood comes from trees.", metal = "Metal comes from stones in a very hot fire.", rock = "Rock comes from under the ground.",
  rubber = "Rubber comes from the juice of a tree, or from oil.", glass = "Glass is made from sand.", ice = "Ice is frozen water.",
}

-- How much of it a material has: a number of it, and whether more or less.
local degrees = {
  hard = { "hardness", 1 }, soft = { "hardness", -1 }, rough = { "roughness", 1 }, smooth = { "roughness", -1 },
  slippery = { "slipperiness", 1 }, sticky = { "slipperiness", -1 },
}

-- "Yes, it is." where a thing is more so than the other; nobody feels less than a hundredth of it.
local function compare(material, other, adjective)
  local of, sign = table.unpack(degrees[adjective])
  local more = sign * (material[of] - other[of])
  if math.abs(more) < 0.01 then return ("No, one is as %s as the other."):format(adjective) end
  return more > 0 and "Yes, it is." or "No, it isn't."
end

-- "Rough or smooth?"
local function which_of(material, one, other)
  local is_one, is_other = know.feels(material, one), know.feels(material, other)
  if is_one and is_other then return ("It is %s and %s."):format(one, other) end
  if not (is_one or is_other) then return ("It isn't %s, and it isn't %s."):format(one, other) end
  return ("It is %s."):format(is_one and one or other)
end

-- An answer about the thing that is meant, where the learner has it and sees it.
local function of_what_is_seen(tell)
  return function(asked, world)
    local body = meant(asked, world)
    if not body then return nothing_yet end
    if body.covered then return "I can't see it. Feel it!" end
    return tell(asked, body)
  end
end

-- A body of which nobody said what it weighs has a kilogram, and no hand can carry it.
local function is_unweighed(body) return body.mass == 1 and body.felt_weight == 0 end

local known = {
  this = {
    asked = { "what is (this|that|it) [called]", "what am I (holding|touching)", "what do I have [in my hand]" },
    nearly = { "what (this|that|it) [is] [called]", "what (is|are) (I|you) (holding|touching)",
               "what I (am holding|am touching|hold|touch|have) [in my hand]" },
    answer = of_what_is_seen(function(asked, body)
      -- A block of metal that is called so: "This is metal."
      local is_material = body.material and body.material.name == body.noun
      return ("This is %s."):format(is_material and body.noun or with_article(body.noun))
    end),
  },
  made_of = {
    asked = { "what is (it|this|that) made (of|from)", "what is [the|a|an] {thing} made (of|from)",
              "what material is (it|this|that|[the|a|an] {thing})", "what material is (it|this|that|[the|a|an] {thing}) made (of|from)" },
    nearly = { "what (it|this|that) is (made|make) [of|from|by]", "what is (it|this|that) (make (of|from|by)|made by|made)",
               "what [is] [the|a|an] {thing} (make (of|from|by)|made by|made)", "what [the|a|an] {thing} is (made|make) [of|from|by]",
               "what material (it|this|that) [is]", "what material has (it|this|that)", "what material [the|a|an] {thing} is", "what material has [the|a|an] {thing}" },
    answer = of_what_is_seen(function(asked, body)
      if not body.material then return nil end
      local name = body.material.name
      if name == body.noun then return comes_from[name] or ("%s is a material itself."):format(upper(name)) end
      return ("%s is made of %s."):format(called(asked, body), name)
    end),
  },
  is_made_of = {
    asked = { "is (it|this|that) made (of|out of) {material}", "is [the|a|an] {thing} made (of|out of) {material}", "is (it|this|that) {material}",
              "is [the|a|an] {thing} {material}", "is (it|this|that) {wooden}", "is [the|a|an] {thing} {wooden}",
              "is (it|this|that) [made (of|out of)] {stone_name}", "is [the|a|an] {thing} [made (of|out of)] {stone_name}" },
    nearly = { "is (it|this|that) (make (of|from|by)|made (by|with|from)|made) {material}", "is [the|a|an] {thing} (make (of|from|by)|made (by|with|from)|made) {material}",
               "(do|does) (it|this|that) made (of|from|by) {material}", "(do|does) [the|a|an] {thing} made (of|from|by) {material}",
               "is (it|this|that) (make (of|from|by)|made (by|with|from)|made) {stone_name}", "is [the|a|an] {thing} (make (of|from|by)|made (by|with|from)|made) {stone_name}" },
    lists = { wooden = { "wooden" }, stone_name = { "stone" } },
    answer = of_what_is_seen(function(asked, body)
      if not body.material then return nil end
      local name = body.material.name
      local said = asked.wooden and "wood" or asked.stone_name and "rock" or asked.material
      return (name == said or name == asked.stone_name) and "Yes, it is." or ("No, it is made of %s."):format(body.material.name)
    end),
  },
  weight = {
    asked = { "how heavy is (it|this|that)", "how heavy is [the|a|an] {thing}", "how much does (it|this|that) weigh",
              "how much does [the|a|an] {thing} weigh", "what is the weight of (it|this|that|[the|a|an] {thing})",
              "is (it|this|that) <adjective:{weight}>", "is [the|a|an] {thing} <adjective:{weight}>" },
    nearly = { "how heavy (it|this|that) [is]", "how heavy [the|a|an] {thing} [is]", "how much (it|this|that) (weigh|weighs)",
               "how much [the|a|an] {thing} (weigh|weighs)", "how (much|many) (do|does) (it|this|that) (weighs|weight)",
               "how (much|many) (do|does) [the|a|an] {thing} (weighs|weight)", "what weight (is|has) (it|this|that)" },
    lists = { weight = { "heavy", "light" } },
    answer = function(asked, world)
      local body = meant(asked, world)
      if body and is_unweighed(body) then return nil end
      return body and ("%s weighs %.1f newtons."):format(called(asked, body), body.weight) or nothing_yet
    end,
  },
  heavier = {
    asked = { "is (it|this|that) <comparative:{weight}> than [the|a|an] {thing:other}", "is [the|a|an] {thing} <comparative:{weight}> than [the|a|an] {thing:other}" },
    nearly = { "does (it|this|that) {weight} than [the|a|an] {thing:other}", "(does|do) [the|a|an] {thing} {weight} than [the|a|an] {thing:other}" },
    lists = { weight = { "heavy", "light" } },
    answer = function(asked, world)
      local body, other = meant(asked, world), asked.bodies.other
      if not body then return nothing_yet end
      if not other or is_unweighed(body) or is_unweighed(other) then return nil end
      local more = asked.weight == "heavy" and body.weight > other.weight or asked.weight == "light" and body.weight < other.weight
      return more and "Yes, it is." or body.weight == other.weight and "No, they weigh the same." or "No, it isn't."
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
    asked = { "is (it|this|that) <adjective:{feel}>", "is [the|a|an] {thing} <adjective:{feel}>", "does (it|this|that) feel <adjective:{feel:felt}>",
              "does [the|a|an] {thing} feel <adjective:{feel:felt}>", "is (it|this|that) <adjective:{feel}> or <adjective:{feel:also}>",
              "is [the|a|an] {thing} <adjective:{feel}> or <adjective:{feel:also}>", "is (it|this|that) <comparative:{feel:more}> than [the|a|an] {thing:other}",
              "is [the|a|an] {thing} <comparative:{feel:more}> than [the|a|an] {thing:other}" },
    nearly = { "(do|does) (it|this|that) {feel}", "(do|does) [the|a|an] {thing} {feel}", "(do|does|is) (it|this|that) (feel|feels) {feel:felt}",
               "(do|does|is) [the|a|an] {thing} (feel|feels) {feel:felt}" },
    lists = { feel = { "hard", "soft", "rough", "smooth", "slippery", "sticky" } },
    answer = function(asked, world)
      local body, other = meant(asked, world), asked.bodies.other
      if not body then return nothing_yet end
      if not body.material then return nil end
      if asked.more then return other and other.material and compare(body.material, other.material, asked.more) end
      if asked.also then return which_of(body.material, asked.feel, asked.also) end
      if asked.felt then return know.feels(body.material, asked.felt) and "Yes, it does." or "No, it doesn't." end
      return know.feels(body.material, asked.feel) and "Yes, it is." or "No, it isn't."
    end,
  },
}

local order = { "this", "made_of", "is_made_of", "weight", "heavier", "feel", "is_it" }

--- Lets a learner ask about the scene's things. Options leave some of it out: `this`, `made_of`, `is_made_of`, `weight`, `heavier`, `feel`, `is_it`,
--- each true by default; without `weight` there is no `heavier` either.
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
    if options[name] ~= false and not (name == "heavier" and options.weight == false) then lesson:knows(name)(known[name]) end
  end
end

-- What words of physics, and others that are no common ones, mean where lessons use them.
local glossary = {
  adjective = "An adjective is a word such as big or red.",
  arm = "An arm is how far a force is from the support of a lever.",
  arrow = "An arrow shows a direction.",
  axis = "An axis is a line that a thing turns about.",
  bow = "A bow is a nice knot.",
  bucket = "A bucket is a thing to carry water in.",
  button = "A button is a small thing to press.",
  centimetre = "A centimetre is short: a hundred of them make a metre.",
  cloud = "A cloud is what brings the rain.",
  drag = "Drag is the force of the air that pushes a kite along with the wind.",
  dust = "Dust is very small pieces of dirt.",
  force = "A force is a push or a pull.",
  gentle = "Gentle means not strong.",
  gravity = "Gravity is the pull of the Earth. It makes things fall.",
  inertia = "Inertia makes a thing hard to move and hard to stop.",
  kilogram = "A kilogram is the mass of a big bottle of water.",
  kilometre = "A kilometre is a thousand metres.",
  lever = "A lever is a bar that turns on a support.",
  lift = "Lift is the force of the air that holds a kite up.",
  metre = "A metre is as long as a very big step.",
  millimetre = "A millimetre is very short: a thousand of them make a metre.",
  multiply = "To multiply two by three is to count two three times: it makes six.",
  newton = "A newton is what we measure forces in. A small apple weighs about one newton.",
  planet = "A planet is a big ball that goes round a star.",
  plural = "A plural is a word for more than one thing, such as apples.",
  pole = "A pole is a place where the axis of a planet comes out.",
  rust = "Rust is what old iron becomes in air and water. It is red.",
  seesaw = "A seesaw is a long board on which two children go up and down.",
  stroke = "To stroke a thing is to move the hand along it.",
  support = "A support is what a lever lies and turns on.",
  swing = "To swing is to move from side to side.",
  tall = "A tall thing goes high up.",
  tap = "To tap a thing is to hit it softly.",
  tension = "Tension is the pull in a line that is tight.",
  thick = "Thick means not thin.",
  tie = "To tie a thing is to hold it with a knot.",
  torque = "Torque is force times arm. It makes things turn.",
  tower = "A tower is high, and not wide.",
  toy = "A toy is a thing to play with.",
  weigh = "To weigh a thing is to find out how heavy it is.",
  weight = "Weight is how hard the Earth pulls a thing. We measure it in newtons.",
  wheel = "A wheel is round, and it turns.",
}

-- How to ask what a word of `list` means, which is said with an article, as "a lever", or without, as "drag"; few ways, for a lesson may know
-- only so many.
local function asked_words(list, slot, with_article, asked, nearly)
  if #list == 0 then return end
  local word, any = "{" .. slot .. "}", "[a|an|the] {" .. slot .. "}"
  local is_of = with_article and any or word
  asked[#asked + 1] = "what is " .. is_of
  asked[#asked + 1] = ("(what does [the word] %s mean|what is (the meaning of|meant by) %s|%s what %s (is|means)|(can|could) you explain %s)")
    :format(word, word, "(tell me|do you know|(can|could) you tell me|I want to know)", is_of, is_of)
  nearly[#nearly + 1] = ("what (%s (mean|means|is)|(mean|means|is mean) %s|(do|does|is) %s (mean|means))"):format(any, any, any)
end

--- Lets a learner ask what words mean: those that stand here, by name, and others of your own, `{ "lever", gem = "A gem is a nice stone." }`.
--- Here stand adjective, arm, arrow, axis, bow, bucket, button, centimetre, cloud, drag, dust, force, gentle, gravity,
--- inertia, kilogram, kilometre, lever, lift, metre, millimetre, multiply, newton, planet, plural, pole, rust, seesaw, stroke,
--- support, swing, tall, tap, tension, thick, tie, torque, tower, toy, weigh, weight and wheel. A word whose
--- meaning begins with "A" or "An" is asked for with an article ("What is a gem?"), any other without ("What is lift?").
---@param lesson Lesson
---@param words table
function know.words(lesson, words)
  if type(lesson) ~= "table" then mistake("know.words takes the lesson, know.words(L, { \"lever\" }); got " .. shown(lesson)) end
  if type(words) ~= "table" then mistake("know.words takes a list of words, such as { \"lever\" }; got " .. shown(words)) end
  local meaning, counted, stuff = {}, {}, {}
  for key, value in pairs(words) do
    if type(value) ~= "string" then mistake("know.words takes words and what they mean as texts; got " .. shown(value)) end
    local own = type(key) == "string"
    local word = own and key or value
    if not own and glossary[word] == nil then program.unknown("know.words", glossary, word) end
    meaning[word] = own and value or glossary[word]
    table.insert(meaning[word]:match "^An? " and counted or stuff, word)
  end
  if next(meaning) == nil then mistake "know.words takes at least one word, such as { \"lever\" }" end
  table.sort(counted)
  table.sort(stuff)
  local asked, nearly = {}, {}
  asked_words(counted, "meant_word", true, asked, nearly)
  asked_words(stuff, "meant_stuff", false, asked, nearly)
  local lists = { meant_word = #counted > 0 and counted or nil, meant_stuff = #stuff > 0 and stuff or nil }
  local first = counted[1] or stuff[1]
  lesson:knows "words" {
    asked = asked, nearly = nearly, lists = lists,
    examples = { right = { ("What does %s mean?"):format(first) }, form = { ("what means %s"):format(first) } },
    answer = function(a) return meaning[a.meant_word or a.meant_stuff] end,
  }
end

return setmetatable(know, {
  __index = function(_, field) program.unknown(module_name, know, field) end,
})
