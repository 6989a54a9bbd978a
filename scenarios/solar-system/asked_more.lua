-- What else a pupil may ask about the planets: how hot and of what colour they are, their rings, which one has most of something.
-- `knows` is that of asked.lua.

local known = require "known"
local planets = require "planets"

local called, named = known.called, known.named

return function(L, knows)
  knows("temperature",
    { "how (hot|warm|cold) is {planet}", "how (hot|warm|cold) is it [<there>]", "what is the temperature (on|of) {planet}", "what temperature is it <there>" },
    { "how (hot|warm|cold) {planet} [is]" },
    { right = { "How hot is Venus?", "How cold is it on Neptune?", "what is the temperature on Mars" }, form = { "how hot Venus is" } },
    function(name, facts) return ("On %s it is about %s."):format(called(name), known.degrees(facts.celsius)) end)

  knows("is_hot",
    { "is {planet} [(very|too)] {heat}", "is it [(very|too)] {heat} [<there>]" }, { "{planet} is {heat}", "(has|does|do) {planet} {heat}" },
    { right = { "Is Venus hot?", "Is it cold on Mars?" } },
    function(name, facts, a)
      local heat = facts.celsius > 50 and "hot" or facts.celsius > 0 and "warm" or "cold"
      return ("%s On %s it is about %s."):format(heat == a.heat and "Yes, it is." or "No, it isn't.", called(name), known.degrees(facts.celsius))
    end, { heat = { "hot", "warm", "cold|icy" } })

  local colours = { "red", "blue", "grey", "yellow", "white", "brown|orange", "green", "black" }
  knows("colour",
    { "(what|which) colour is {planet}", "(what|which) colour is it", "what is the colour of <one>", "what colour does {planet} have" }, { "(what|which) colour (has {planet}|{planet} is)" },
    { right = { "What colour is Mars?", "what color is Saturn" }, form = { "what colour has Mars" } },
    function(name, facts) return ("%s is %s."):format(named(name), facts.colour) end)

  knows("is_colour",
    { "is <one> {colour}", "is <one> a {colour} planet" }, {}, { right = { "Is Mars red?", "is the Earth blue" } },
    function(name, facts, a)
      return facts.colour:find(a.colour, 1, true) and "Yes, it is." or ("No, %s is %s."):format(called(name), facts.colour)
    end, { colour = colours })

  knows("why_colour",
    { "why is <one> [so] {colour}", "why does <one> look {colour}" }, { "why {planet} is [so] {colour}" },
    { right = { "Why is Mars red?" }, form = { "why Mars is red" } },
    function(name, facts, a)
      if not facts.colour:find(a.colour, 1, true) then return ("It isn't: %s is %s."):format(called(name), facts.colour) end
      if not facts.why then return nil end
      return ("%s is %s because %s."):format(named(name), facts.colour, facts.why)
    end, { colour = colours })

  knows("rings",
    { "does <one> have (rings|a ring|any rings)", "has <one> got (rings|a ring|any rings)", "how many rings does <one> have", "are there [any] rings (around|round) <one>",
      "what are the rings of <one> [made of]" },
    { "(do|is|has) {planet} (have|has) [(a|any)] (ring|rings)", "does {planet} (has|have) [any] ring", "how many (ring|rings) (has|have) {planet}", "how many (ring|rings) {planet} (has|have)" },
    { right = { "Does Saturn have rings?", "how many rings does Uranus have" }, form = { "do Saturn have rings", "how many rings Saturn has" } },
    function(name, facts)
      return facts.rings and ("%s has %s."):format(named(name), facts.rings) or ("%s has no rings."):format(named(name))
    end)

  knows("why_hot", { "why is <one> so {heat}", "why is it so {heat} <there>" }, { "why {planet} is so {heat}" }, { right = { "Why is Neptune so cold?" } },
    function(name, facts, a)
      if name == "Venus" and a.heat == "hot" then return "Its thick clouds and its air keep the heat in." end
      if name == "Mercury" and a.heat == "hot" then return "It is so near to the Sun." end
      if a.heat == "cold" and facts.celsius < 0 and name ~= "Moon" then return "It is so far from the Sun." end
      return nil
    end, { heat = { "hot", "warm", "cold|icy" } })

  local most = {
    big = { "radius", 1 }, small = { "radius", -1 }, heavy = { "mass", 1 }, light = { "mass", -1 }, hot = { "celsius", 1 }, cold = { "celsius", -1 },
    near = { "distance", -1 }, far = { "distance", 1 },
  }
  L:knows "most" {
    asked = { "which planet is the <superlative:{most}> [(to|from) the Sun]", "what is the <superlative:{most}> planet [(to|from) the Sun]",
              "which is the <superlative:{most}> planet [(to|from) the Sun]" },
    nearly = { "which planet is <superlative:{most}> [(to|from) the Sun]", "what planet is [the] <superlative:{most}>" },
    lists = { most = { "big|large", "small", "heavy", "light", "hot|warm", "cold", "near|close", "far" } },
    examples = { right = { "Which planet is the biggest?", "What is the hottest planet?", "which planet is the farthest from the Sun" },
                 form = { "which planet is the most big", "which planet is biggest" } },
    answer = function(a)
      local of, sign = table.unpack(most[a.most])
      return named(known.extreme(function(facts) return facts[of] end, sign)) .. " is."
    end,
  }

  L:knows "has_most" {
    asked = { "which planet has (the most|most) {of_what}", "which planet has the ((longest|longer) {long}|(shortest|shorter) {short})", "which (planet has|planets have) rings" },
    lists = { of_what = { "moons" }, long = { "day", "year" }, short = { "day", "year" } },
    examples = { right = { "Which planet has the most moons?", "which planet has the longest year" } },
    answer = function(a)
      local of = a.of_what or a.long or a.short
      if not of then return "Jupiter, Saturn, Uranus and Neptune have rings." end
      return named(known.extreme(function(facts) return facts[of] end, a.short and -1 or 1)) .. " has."
    end,
  }

  knows("kind",
    { "is <one> a {kind}", "is <one> really a {kind}", "why is (<one> not|not <one>) a {kind}" }, { "{planet} is a {kind}", "is {planet} {kind}" },
    { right = { "Is Pluto a planet?", "is the Sun a star" } },
    function(name, facts, a)
      if facts.kind == a.kind then return "Yes, it is." end
      if name == "Pluto" then return "Pluto is a dwarf planet: it is small, and other bodies go round the Sun near it." end
      return ("No, %s is a %s."):format(called(name), facts.kind)
    end, { kind = { "planet", "dwarf planet", "star", "moon" } })

  knows("age",
    { "how old is <one>", "what is the age of <one>" }, { "how old {planet} [is]", "how old (has|have) {planet}" }, { right = { "How old is the Earth?" }, form = { "how old Mars is" } },
    function(name) return name ~= "Pluto" and ("%s is about 4500 million years old."):format(named(name)) or nil end)

  knows("gravity",
    { "how strong is [the] gravity <there>", "what is the gravity (on|of) {planet}", "how much (would|do|will) I weigh <there>", "how heavy would I be <there>" }, {},
    { right = { "How strong is gravity on Mars?", "how much would I weigh on the Moon" } },
    function(name, facts)
      if name == "Earth" then return "One kilogram weighs 9.8 newtons on the Earth." end
      return ("One kilogram weighs %.1f newtons on %s, and 9.8 newtons on the Earth."):format(facts.gravity, called(name))
    end)

  knows("speed",
    { "how fast does <one> (move|go|travel|fly) [round the Sun]", "how fast is <one>" }, { "how fast {planet} (move|moves|go|goes|is)" },
    { right = { "How fast does the Earth move?" }, form = { "how fast Mars moves" } },
    function(name, facts)
      if name == "Moon" then return "The Moon goes round the Earth at about 1 kilometre a second." end
      if not facts.year then return nil end
      return ("%s goes round the Sun at about %.0f kilometres a second."):format(named(name), 2 * math.pi * facts.distance / 1000 / (facts.year * 86400))
    end)

  knows("life",
    { "is there [any] {alive} <there>", "are there [any] {beings} <there>", "does (anybody|anyone) live <there>", "can (we|I|you|people) live <there>" }, {},
    { right = { "Is there life on Mars?", "can people live on Venus" } },
    function(name, _, a)
      if a.alive == "water" then
        return name == "Earth" and "Yes, its seas are water." or name == "Mars" and "Yes, but it is ice." or nil
      end
      return name == "Earth" and "Yes: we live here." or ("Nobody has found life on %s."):format(called(name))
    end, { alive = { "life", "water" }, beings = { "people", "animals", "plants", "aliens" } })

  knows("surface",
    { "does <one> have a [(solid|hard)] (surface|ground)", "can (we|I|you|people) (stand|land|walk) <there>" }, {}, { right = { "Does Jupiter have a surface?" } },
    function(name, facts)
      if facts.stuff:find("gas", 1, true) then return ("No, %s is mostly made of %s."):format(called(name), facts.stuff) end
      return ("Yes, %s is made of %s."):format(called(name), facts.stuff)
    end)

  L:knows "how_many" {
    asked = { "how many planets are there [(in the solar system|round the Sun)]", "how many planets ((go|move) (round|around) the Sun|does the Sun have)" },
    examples = { right = { "How many planets are there?" } },
    answer = function() return ("There are %d planets."):format(#planets.names) end,
  }
end
