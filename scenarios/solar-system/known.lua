-- What is known of the planets, the Sun, the Moon and Pluto beside what `planets` knows, and how it is told.
--
-- Numbers: NASA's Planetary Fact Sheets (D. R. Williams, NSSDCA), the metric one, and those of the Sun, the Moon and Pluto: mean
-- temperature in degrees Celsius (the Sun's of its surface, 5772 K), gravity in metres a second squared. Colours, rings, moons' names and
-- what they are made of: NASA, "Solar System Exploration". Ages: G. B. Dalrymple, "The age of the Earth in the twentieth century", 2001.

local planets = require "planets"

-- The ices of Uranus and Neptune are water, ammonia and methane.
local also = {
  Mercury = { celsius = 167, gravity = 3.7, colour = "grey", stuff = "rock and iron" },
  Venus = { celsius = 464, gravity = 8.9, colour = "yellow", stuff = "rock and iron", why = "of its thick clouds" },
  Earth = { celsius = 15, gravity = 9.8, colour = "blue", stuff = "rock and iron", why = "of its seas", moons_called = "the Moon" },
  Mars = { celsius = -65, gravity = 3.7, colour = "red", stuff = "rock and iron", why = "there is rust on its ground", moons_called = "Phobos and Deimos" },
  Jupiter = { celsius = -110, gravity = 23.1, colour = "brown and white", stuff = "gas, hydrogen and helium", why = "of its clouds",
              rings = "thin rings of dust", moons_called = "Io, Europa, Ganymede and Callisto" },
  Saturn = { celsius = -140, gravity = 9.0, colour = "yellow", stuff = "gas, hydrogen and helium", why = "of its clouds",
             rings = "big rings of ice and stones", moons_called = "Titan, Rhea, Iapetus and Dione" },
  Uranus = { celsius = -195, gravity = 8.7, colour = "blue-green", stuff = "ice and gas", why = "there is methane in its air",
             rings = "thirteen thin, dark rings", moons_called = "Titania, Oberon, Umbriel, Ariel and Miranda" },
  Neptune = { celsius = -200, gravity = 11.0, colour = "blue", stuff = "ice and gas", why = "there is methane in its air",
              rings = "five thin, dark rings", moons_called = "Triton, Proteus and Nereid" },
  Sun = { celsius = 5500, gravity = 274, colour = "white", stuff = "hot gas, hydrogen and helium", kind = "star" },
  Moon = { celsius = -20, gravity = 1.6, colour = "grey", stuff = "rock", kind = "moon",
           radius = 1.7375e6, mass = 7.3e22, day = 655.7 * 3600, moons = 0 },
  Pluto = { celsius = -225, gravity = 0.7, colour = "brown", stuff = "rock and ice", kind = "dwarf planet", moons_called = "Charon, Nix, Hydra, Kerberos and Styx",
            radius = 1.188e6, mass = 1.303e22, day = 153.3 * 3600, moons = 5, distance = 5.9064e12, year = 90560 },
}

local known = {}

known.names = {}
for i, name in ipairs(planets.names) do known.names[i] = name end
table.move({ "Sun", "Moon", "Pluto" }, 1, 3, #known.names + 1, known.names)

local facts = {}
for _, name in ipairs(known.names) do
  local own = also[name]
  if not own.radius then
    for field, value in pairs(planets.facts(name)) do own[field] = value end
  end
  own.kind = own.kind or "planet"
  facts[name] = own
end
function known.facts(name) return facts[name] end

local takes_the = { Earth = true, Sun = true, Moon = true }
function known.called(name) return takes_the[name] and "the " .. name or name end
function known.named(name) return takes_the[name] and "The " .. name or name end

-- The planet with the most (sign 1) or the least (-1) of what `of` gives.
function known.extreme(of, sign)
  local best
  for _, name in ipairs(planets.names) do
    local value = of(facts[name])
    if value and (not best or sign * value > sign * of(facts[best])) then best = name end
  end
  return best
end

-- Three digits, and not a million million of them.
function known.rounded(value) return (value < 100 and "%.3g" or "%.0f"):format(value) end

function known.hours(seconds)
  local hours = seconds / 3600
  return hours < 48 and ("%.0f hours"):format(hours) or ("%.0f of our days"):format(hours / 24)
end

function known.degrees(celsius)
  return celsius < 0 and ("%d degrees Celsius below zero"):format(-celsius) or ("%d degrees Celsius"):format(celsius)
end

return known
