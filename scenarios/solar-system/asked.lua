-- What a pupil may ask about the planets; `shown` gives the name of the one that is seen from near, or nil.

local numbers = require "numbers"
local planets = require "planets"

return function(L, shown)
  local asked_of = {}
  for i, name in ipairs(planets.names) do asked_of[i] = name == "Earth" and "Earth|the Earth" or name end

  local function named(name) return name == "Earth" and "The Earth" or name end

  L:knows "moons" {
    asked = { "how many <plural:moon> does {planet} have", "how many <plural:moon> has {planet} got", "how many <plural:moon> has {planet}" },
    lists = { planet = asked_of },
    answer = function(asked)
      local n = planets.facts(asked.planet).moons
      return ("%s has %s %s."):format(named(asked.planet), numbers.word(n), n == 1 and "moon" or "moons")
    end,
  }

  L:knows "size" {
    asked = { "how (big|large|wide) is {planet}" },
    answer = function(asked)
      return ("%s is %.0f kilometres wide."):format(named(asked.planet), 2 * planets.facts(asked.planet).radius / 1000)
    end,
  }

  L:knows "distance" {
    asked = { "how far is {planet} [away] [from the Sun]" },
    answer = function(asked)
      return ("%s is %.0f million kilometres from the Sun."):format(named(asked.planet), planets.facts(asked.planet).distance / 1e9)
    end,
  }

  L:knows "year" {
    asked = { "how long is a year on {planet}" },
    answer = function(asked)
      return ("A year on %s has %.0f of our days."):format(asked.planet == "Earth" and "the Earth" or asked.planet, planets.facts(asked.planet).year)
    end,
  }

  L:knows "day" {
    asked = { "how long is a day on {planet}" },
    answer = function(asked)
      local hours = planets.facts(asked.planet).day / 3600
      local turns = named(asked.planet) .. " turns round once in "
      return turns .. (hours < 48 and ("%.0f hours."):format(hours) or ("%.0f of our days."):format(hours / 24))
    end,
  }

  L:knows "shown" {
    asked = { "which planet is (this|that|it)", "what is (this|that)" },
    answer = function()
      local name = shown()
      return name and ("This is %s."):format(name == "Earth" and "the Earth" or name)
    end,
  }
end
