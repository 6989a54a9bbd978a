-- What a pupil may ask about the planets; `shown` gives the name of the one that is seen from near, or nil. "It" is that one.

local known = require "known"
local numbers = require "numbers"
local planets = require "planets"

local called, named = known.called, known.named

-- A lesson may know 64 ways to ask: all but the first stand in one.
local function joined(asked)
  if #asked < 3 then return asked end
  return { asked[1], "(" .. table.concat(asked, "|", 2) .. ")" }
end

local function counted(n, thing)
  local found = n > 20 and ", found by " .. planets.moons_counted or ""
  return (n > 20 and n or numbers.word(n)) .. " " .. thing .. (n == 1 and "" or "s") .. found
end

-- Lets a pupil ask; gives a function that tells what is known of a planet under a name of L:knows, and one that says when something
-- was told last, as a count.
return function(L, shown)
  local answers, n_told = {}, 0
  local asked_of = {}
  for i, name in ipairs(known.names) do asked_of[i] = name == "Earth" and "Earth|the Earth" or called(name) end

  -- Something that is known of each planet: `tell` is given its name, its facts, what was asked and the world.
  local function knows(id, asked, nearly, examples, tell, lists)
    lists = lists or {}
    lists.planet = asked_of
    L:knows(id) {
      asked = joined(asked), nearly = nearly, lists = lists, examples = examples,
      rules = { one = "({planet}|it|this planet)", there = "((on|in) {planet}|there|(on|in) it)",
                lead = "(tell me|I want to know|do you know|(can|could) you tell me)" },
      answer = function(a, world)
        local name = a.planet or shown()
        n_told = n_told + 1
        if not name then return "Which planet? Ask for instance: How big is Mars?" end
        return tell(name, known.facts(name), a, world)
      end,
    }
    answers[id] = tell
  end

  knows("moons",
    { "how many <plural:moon> does {planet} have", "how many <plural:moon> (does it have|has <one> got)",
      "how many <plural:moon> (are there|go|move) (around|round) <one>", "<lead> how many <plural:moon> <one> has",
      "what is the number of moons of <one>" },
    { "how (many|much) (moon|moons) {planet} (has|have|got)", "how many <plural:moon> has {planet}", "how (many|much) (moon|moons) (have|do|is) {planet} [have]",
      "{planet} (has|have) how many (moon|moons)" },
    { right = { "How many moons does Jupiter have?", "how many moons has the Earth got" },
      form = { "how many moon does Mars have", "how many moons Saturn has", "how much moons has Mars" },
      other = { "how big is Jupiter" } },
    function(name, facts) return ("%s has %s."):format(named(name), counted(facts.moons, "moon")) end)

  knows("has_moons",
    { "does <one> have (moons|a moon|any moons)", "has <one> got (moons|a moon|any moons)", "are there [any] moons (around|round) <one>" },
    { "(do|is|has) {planet} (have|has) [(a|any)] (moon|moons)", "does {planet} (has|have) [any] moon", "{planet} (has|have) [(a|any)] (moon|moons)" },
    { right = { "Does Venus have a moon?", "does the Earth have moons" }, form = { "do Mars have moons", "does Mars has moon" },
      other = { "how many moons does Mars have" } },
    function(name, facts)
      if facts.moons == 0 then return ("No, %s has no moons."):format(called(name)) end
      return ("Yes, %s has %s."):format(called(name), counted(facts.moons, "moon"))
    end)

  knows("moons_called",
    { "what are the moons of <one> called", "what are the names of the moons of <one>", "what is the moon of <one> called" }, {},
    { right = { "What are the moons of Mars called?" } },
    function(name, facts)
      if facts.moons == 0 then return ("%s has no moons."):format(named(name)) end
      if facts.moons == 1 then return "It is called the Moon." end
      return (facts.moons <= 5 and "They are called %s." or "The biggest ones are called %s."):format(facts.moons_called)
    end)

  knows("size",
    { "how (big|large|wide) is {planet} [in kilometres]", "how (big|large|wide) is (it|this planet) [in kilometres]",
      "what is the (size|diameter) of <one>", "what size is <one>", "how many kilometres wide is <one>", "<lead> how (big|large|wide) <one> is" },
    { "how (big|large|wide) {planet} [is]" },
    { right = { "How big is Mars?", "how large is the Earth", "what size is Neptune", "how big is Jupiter in kilometres" }, form = { "how big Mars is" } },
    function(name, facts) return ("%s is %.0f kilometres wide."):format(named(name), 2 * facts.radius / 1000) end)

  knows("mass",
    { "how heavy is {planet}", "how heavy is (it|this planet)", "how much does <one> weigh", "what is the (mass|weight) of <one>", "<lead> how heavy <one> is" },
    { "how heavy {planet} [is]", "how much (weigh|weighs) {planet}", "how much {planet} (weigh|weighs)" },
    { right = { "How heavy is Jupiter?", "what is the mass of Saturn", "How much does Mars weigh?" }, form = { "how heavy Jupiter is", "how much does Mars weighs" } },
    function(name, facts)
      if name == "Earth" then return ("The Earth has a mass of %.0f million million million tonnes."):format(facts.mass / 1e21) end
      return ("%s has %s times the mass of the Earth."):format(named(name), known.rounded(facts.mass / planets.facts("Earth").mass))
    end)

  knows("made_of",
    { "what is {planet} made of", "what is (it|this|that|this planet) made of", "what is {planet}" },
    { "what {planet} [is] made of", "what is {planet} (make|made) (of|from|by)" },
    { right = { "What is Jupiter made of?", "what is this made of" }, form = { "what is Mars make of" } },
    function(name, facts)
      local kind = facts.kind == "planet" and "" or "a " .. facts.kind .. ", and "
      return ("%s is %smostly made of %s."):format(named(name), kind, facts.stuff)
    end)

  knows("is_made_of",
    { "is {planet} [mostly] made (of|from|out of) {stuff}", "is (it|this|that) [mostly] made (of|from|out of) {stuff}" },
    { "is {planet} (make|made) [(from|by)] {stuff}", "{planet} is made (of|from|by) {stuff}" },
    { right = { "Is Jupiter made of gas?", "is this made of rock" }, form = { "is Mars made by rock" } },
    function(name, facts, a)
      if facts.stuff:find(a.stuff, 1, true) then return "Yes, it is." end
      return ("No, %s is mostly made of %s."):format(called(name), facts.stuff)
    end, { stuff = { "rock|stone", "iron", "gas", "hydrogen", "helium", "ice", "water", "wood", "fire" } })

  knows("is_bigger",
    { "is {planet} <comparative:{how}> than {planet:other}", "is it <comparative:{how}> than {planet:other}" }, {},
    { right = { "Is Mars bigger than the Earth?", "is it smaller than Jupiter", "is Jupiter heavier than Saturn", "is Venus hotter than Mercury" },
      form = { "is Mars more big than the Earth" } },
    function(name, facts, a)
      if name == a.other then return "That is one and the same planet." end
      local of = (a.how == "heavy" or a.how == "light") and "mass" or (a.how == "hot" or a.how == "cold") and "celsius" or "radius"
      local sign = (a.how == "big" or a.how == "heavy" or a.how == "hot") and 1 or -1
      return sign * facts[of] > sign * known.facts(a.other)[of] and "Yes, it is." or "No, it isn't."
    end, { how = { "big|large", "small", "heavy", "light", "hot|warm", "cold" } })

  -- The mean from the Sun; from any other as both stand today.
  local function apart(name, other, day)
    if name == "Moon" or other == "Moon" then return (name == "Earth" or other == "Earth") and 0.3844 or nil end
    if name == "Pluto" or other == "Pluto" then return nil end
    local x, y, z = planets.place(name, day)
    local u, v, w = planets.place(other, day)
    return math.sqrt((x - u) ^ 2 + (y - v) ^ 2 + (z - w) ^ 2) * planets.astronomical_unit / 1e9
  end

  knows("distance",
    { "how far is {planet} [away] [from {planet:other}]", "how far away is {planet} [from {planet:other}]", "how far [away] is it [from {planet:other}]",
      "what is the distance (of|from|between) {planet} (from|to|and) {planet:other}", "<lead> how far [away] <one> is [from {planet:other}]" },
    { "how far {planet} [is] [from {planet:other}]" },
    { right = { "How far is Neptune from the Sun?", "how far is it from the sun", "How far away is Mars from the Earth?", "what is the distance of Mars from the Sun" },
      form = { "how far Mars is from the Sun" } },
    function(name, facts, a, world)
      local other = a.other or (name == "Sun" or name == "Moon") and "Earth" or "Sun"
      if name == other then return "That is one and the same." end
      local from = name == "Sun" and known.facts(other) or other == "Sun" and facts
      if from and from.distance then
        return ("%s is %.0f million kilometres from %s."):format(named(name), from.distance / 1e9, called(other))
      end
      if name == "Sun" then name, other = other, name end
      if other == "Sun" and name == "Moon" then return "The Moon is as far from the Sun as the Earth is: 150 million kilometres." end
      local away = apart(name, other, world.day)
      if not away then return nil end
      if away < 1 then return ("%s is %.0f kilometres from %s."):format(named(name), away * 1e6, called(other)) end
      return ("Today %s is %.0f million kilometres from %s."):format(called(name), away, called(other))
    end)

  knows("year",
    { "how long is (a|one) year <there>", "how long does {planet} (need|take) to go round the Sun", "how many days does (a|one) year <there> have" },
    { "how long (year|a year) (on|in) {planet}", "how long is (year|the year) (on|in) {planet}" },
    { right = { "How long is a year on Mars?", "how long does Mars take to go round the Sun" }, form = { "how long is year on Mars" } },
    function(name, facts)
      if name == "Moon" then return "The Moon goes round the Earth in 27 days." end
      return facts.year and ("A year on %s has %.0f of our days."):format(called(name), facts.year) or nil
    end)

  knows("day",
    { "how long is (a|one) day <there>", "how fast does <one> (turn|spin)", "how many hours does (a|one) day <there> have" },
    { "how long (day|a day) (on|in) {planet}", "how long is (day|the day) (on|in) {planet}", "how fast {planet} (turn|turns|spin|spins)" },
    { right = { "How long is a day on Jupiter?", "how fast does the Earth turn" }, form = { "how long is day on Mars" } },
    function(name, facts) return ("%s turns round once in %s."):format(named(name), known.hours(facts.day)) end)

  require "asked_more" (L, knows)

  L:knows "shown" {
    asked = joined { "which planet is (this|that|it)", "what is (this|that)", "what planet is (this|that|it)", "what is (this|that) [planet] called" },
    examples = { right = { "What is this?", "which planet is that" }, other = { "what is this made of" } },
    answer = function()
      local name = shown()
      return name and ("This is %s."):format(called(name)) or "Those are the Sun and its eight planets."
    end,
  }

  return function(id, name, world) return answers[id](name, known.facts(name), {}, world) end, function() return n_told end
end
