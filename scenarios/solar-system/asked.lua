-- What a pupil may ask about the planets; `shown` gives the name of the one that is seen from near, or nil. "It" is that one.

local numbers = require "numbers"
local planets = require "planets"

-- NASA's Planetary Fact Sheets and "Solar System Exploration": what most of each is. The ices of Uranus and Neptune are water, ammonia and methane.
local stuff = {
  Mercury = "rock and iron", Venus = "rock and iron", Earth = "rock and iron", Mars = "rock and iron",
  Jupiter = "gas, hydrogen and helium", Saturn = "gas, hydrogen and helium",
  Uranus = "ice and gas", Neptune = "ice and gas",
}

return function(L, shown)
  local asked_of = {}
  for i, name in ipairs(planets.names) do asked_of[i] = name == "Earth" and "Earth|the Earth" or name end

  local function called(name) return name == "Earth" and "the Earth" or name end
  local function named(name) return name == "Earth" and "The Earth" or name end

  -- Something that is known of each planet: `tell` is given its name.
  local function knows(id, asked, nearly, examples, tell)
    L:knows(id) {
      asked = asked, nearly = nearly, lists = { planet = asked_of }, examples = examples,
      answer = function(a)
        local name = a.planet or shown()
        return name and tell(name, planets.facts(name)) or "Which planet? Ask for instance: How big is Mars?"
      end,
    }
  end

  knows("moons",
    { "how many <plural:moon> does {planet} have", "how many <plural:moon> does it have", "how many <plural:moon> has {planet} got",
      "how many <plural:moon> has {planet}", "how many <plural:moon> (are there around|go round) {planet}", "does {planet} have (moons|a moon)" },
    { "how (many|much) (moon|moons) {planet} (has|have|got)", "how (many|much) (moon|moons) (have|do|is) {planet} [have]",
      "{planet} (has|have) how many (moon|moons)" },
    { right = { "How many moons does Jupiter have?", "how many moons has the Earth got", "does Venus have a moon" },
      form = { "how many moon does Mars have", "how many moons Saturn has", "how much moons has Mars" },
      other = { "how big is Jupiter" } },
    function(name, facts)
      return ("%s has %s %s."):format(named(name), numbers.word(facts.moons), facts.moons == 1 and "moon" or "moons")
    end)

  knows("size",
    { "how (big|large|wide) is {planet}", "how (big|large|wide) is it", "what is the size of {planet}", "what size is {planet}" },
    { "how (big|large|wide) {planet} [is]" },
    { right = { "How big is Mars?", "how large is the Earth", "what size is Neptune" }, form = { "how big Mars is" } },
    function(name, facts) return ("%s is %.0f kilometres wide."):format(named(name), 2 * facts.radius / 1000) end)

  knows("mass",
    { "how heavy is {planet}", "how heavy is it", "how much does {planet} weigh", "what is the mass of {planet}" },
    { "how heavy {planet} [is]", "how much (weigh|weighs) {planet}" },
    { right = { "How heavy is Jupiter?", "what is the mass of Saturn" }, form = { "how heavy Jupiter is" } },
    function(name, facts)
      if name == "Earth" then return ("The Earth has a mass of %.0f million million million tonnes."):format(facts.mass / 1e21) end
      return ("%s has %.3g times the mass of the Earth."):format(name, facts.mass / planets.facts("Earth").mass)
    end)

  knows("made_of",
    { "what is {planet} made of", "what is (it|this|that) made of", "what is {planet}" },
    { "what {planet} [is] made of", "what is {planet} (make|made) (of|from|by)" },
    { right = { "What is Jupiter made of?", "what is this made of" }, form = { "what is Mars make of" } },
    function(name) return ("%s is mostly made of %s."):format(named(name), stuff[name]) end)

  knows("distance",
    { "how far is {planet} [away] [from the Sun]", "how far away is {planet} [from the Sun]", "how far is it from the Sun" },
    { "how far {planet} [is] [from the Sun]" },
    { right = { "How far is Neptune from the Sun?", "how far is it from the sun" }, form = { "how far Mars is from the Sun" } },
    function(name, facts) return ("%s is %.0f million kilometres from the Sun."):format(named(name), facts.distance / 1e9) end)

  knows("year",
    { "how long is (a|one) year on {planet}", "how long is (a|one) year there", "how long does {planet} (need|take) to go round the Sun" },
    { "how long (year|a year) (on|in) {planet}", "how long is (year|the year) (on|in) {planet}" },
    { right = { "How long is a year on Mars?", "how long does Mars take to go round the Sun" }, form = { "how long is year on Mars" } },
    function(name, facts) return ("A year on %s has %.0f of our days."):format(called(name), facts.year) end)

  knows("day",
    { "how long is (a|one) day on {planet}", "how long is (a|one) day there", "how fast does {planet} turn", "how fast does it turn" },
    { "how long (day|a day) (on|in) {planet}", "how long is (day|the day) (on|in) {planet}", "how fast {planet} (turn|turns)" },
    { right = { "How long is a day on Jupiter?", "how fast does the Earth turn" }, form = { "how long is day on Mars" } },
    function(name, facts)
      local hours = facts.day / 3600
      local turns = named(name) .. " turns round once in "
      return turns .. (hours < 48 and ("%.0f hours."):format(hours) or ("%.0f of our days."):format(hours / 24))
    end)

  L:knows "shown" {
    asked = { "which planet is (this|that|it)", "what is (this|that)", "what planet is (this|that|it)", "what is (this|that) [planet] called" },
    examples = { right = { "What is this?", "which planet is that" }, other = { "what is this made of" } },
    answer = function()
      local name = shown()
      return name and ("This is %s."):format(called(name)) or "Those are the Sun and its eight planets."
    end,
  }
end
