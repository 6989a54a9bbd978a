--- The Sun's eight planets: where each is on a day, and what is known of it.
---
---   local planets = require "planets"
---   local today = planets.day(2026, 3, 20)
---   local x, y, z = planets.place("Earth", today)    -- astronomical units; x to the spring point, z to the north
---   print(planets.facts "Mars".moons)                -- 2
---
--- Places are those of E. M. Standish, "Keplerian Elements for Approximate Positions of the Major Planets" (JPL/Caltech),
--- table 1: an ellipse whose six elements change evenly with time, fitted for the years 1800 to 2050; outside them it is
--- refused. Against the theory VSOP87 it errs by 0.2° at most (Saturn), Jupiter by 0.13° and the others by less than 0.04°.
---
--- Numbers are SI units, days or astronomical units as each name says. Facts: NASA's Planetary Fact Sheets (D. R. Williams,
--- NSSDCA). Moons: those that the International Astronomical Union had recognised by June 2025 (NASA, JPL Solar System
--- Dynamics); new small ones of the outer planets are still being found.

-- What the program gives to the shared library: mistakes are told at the lesson's own line.
local module_name, program = ...
local mistake, shown = program.mistake, program.shown

local planets = {}

--- From the Sun outwards.
planets.names = { "Mercury", "Venus", "Earth", "Mars", "Jupiter", "Saturn", "Uranus", "Neptune" }

--- When the moons were counted.
planets.moons_counted = "June 2025"

--- One astronomical unit in metres (International Astronomical Union 2012, resolution B2).
planets.astronomical_unit = 149597870700

-- Standish's table 1, mean ecliptic and equinox of J2000: semi-major axis (au), eccentricity, inclination, mean longitude,
-- longitude of perihelion, longitude of the ascending node (degrees); below it what each changes in a century of 36525
-- days. "Earth" is the point that Earth and Moon go round together, at most 4700 km off the Earth's middle.
local elements = {
  Mercury = { { 0.38709927, 0.20563593, 7.00497902, 252.25032350, 77.45779628, 48.33076593 },
              { 0.00000037, 0.00001906, -0.00594749, 149472.67411175, 0.16047689, -0.12534081 } },
  Venus   = { { 0.72333566, 0.00677672, 3.39467605, 181.97909950, 131.60246718, 76.67984255 },
              { 0.00000390, -0.00004107, -0.00078890, 58517.81538729, 0.00268329, -0.27769418 } },
  Earth   = { { 1.00000261, 0.01671123, -0.00001531, 100.46457166, 102.93768193, 0.0 },
              { 0.00000562, -0.00004392, -0.01294668, 35999.37244981, 0.32327364, 0.0 } },
  Mars    = { { 1.52371034, 0.09339410, 1.84969142, -4.55343205, -23.94362959, 49.55953891 },
              { 0.00001847, 0.00007882, -0.00813131, 19140.30268499, 0.44441088, -0.29257343 } },
  Jupiter = { { 5.20288700, 0.04838624, 1.30439695, 34.39644051, 14.72847983, 100.47390909 },
              { -0.00011607, -0.00013253, -0.00183714, 3034.74612775, 0.21252668, 0.20469106 } },
  Saturn  = { { 9.53667594, 0.05386179, 2.48599187, 49.95424423, 92.59887831, 113.66242448 },
              { -0.00125060, -0.00050991, 0.00193609, 1222.49362201, -0.41897216, -0.28867794 } },
  Uranus  = { { 19.18916464, 0.04725744, 0.77263783, 313.23810451, 170.95427630, 74.01692503 },
              { -0.00196176, -0.00004397, -0.00242939, 428.48202785, 0.40805281, 0.04240589 } },
  Neptune = { { 30.06992276, 0.00859048, 1.77004347, -55.12002969, 44.96476227, 131.78422574 },
              { 0.00026291, 0.00005105, 0.00035372, 218.45945325, -0.32241464, -0.00508664 } },
}

-- radius: mean, metres. mass: kilograms. day: seconds of one turn among the stars. tilt: degrees between its axis and that
-- of its way round the Sun; beyond 90 it turns the other way round.
local facts = {
  Sun     = { radius = 695.7e6,   mass = 1.98841e30, day = 609.12 * 3600,  tilt = 7.25,   moons = 0 },
  Mercury = { radius = 2.4397e6,  mass = 3.3010e23,  day = 1407.6 * 3600,  tilt = 0.034,  moons = 0 },
  Venus   = { radius = 6.0518e6,  mass = 4.8673e24,  day = 5832.6 * 3600,  tilt = 177.36, moons = 0 },
  Earth   = { radius = 6.3710e6,  mass = 5.9722e24,  day = 23.9345 * 3600, tilt = 23.44,  moons = 1 },
  Mars    = { radius = 3.3895e6,  mass = 6.4169e23,  day = 24.6229 * 3600, tilt = 25.19,  moons = 2 },
  Jupiter = { radius = 69.911e6,  mass = 1.89813e27, day = 9.9250 * 3600,  tilt = 3.13,   moons = 97 },
  Saturn  = { radius = 58.232e6,  mass = 5.6832e26,  day = 10.656 * 3600,  tilt = 26.73,  moons = 274 },
  Uranus  = { radius = 25.362e6,  mass = 8.6811e25,  day = 17.24 * 3600,   tilt = 97.77,  moons = 28 },
  Neptune = { radius = 24.622e6,  mass = 1.02409e26, day = 16.11 * 3600,   tilt = 28.32,  moons = 16 },
}

local days_a_century = 36525
local first_day, last_day = -73048.5, 18627.5   -- 1 January 1800 and 1 January 2051, midnight

local function check_number(called, value)
  if type(value) ~= "number" or value ~= value then mistake(called .. " takes numbers; got " .. shown(value)) end
end

local function elements_of(called, name)
  local found = elements[name]
  if not found then
    mistake(called .. " takes the name of a planet, " .. table.concat(planets.names, ", ") .. "; got " .. shown(name))
  end
  return found
end

--- What is known of a planet, or of the Sun: `radius` (metres), `mass` (kilograms), `day` (seconds of one turn among the
--- stars), `tilt` (degrees, beyond 90 it turns the other way round), `moons`, and for a planet `distance` (metres from the
--- Sun, the mean) and `year` (days).
---@param name string
---@return table
function planets.facts(name)
  local known = facts[name]
  if not known then
    mistake("planets.facts takes \"Sun\" or the name of a planet, " .. table.concat(planets.names, ", ") .. "; got "
      .. shown(name))
  end
  local copy = { name = name }
  for field, value in pairs(known) do copy[field] = value end
  local of = elements[name]
  if of then
    copy.distance = of[1][1] * planets.astronomical_unit
    copy.year = days_a_century * 360 / of[2][4]
  end
  return copy
end

--- The number of a day: days since noon of 1 January 2000, by the Gregorian calendar.
---@param year integer
---@param month integer 1 to 12
---@param day number 1 to 31
---@param hour number|nil of Greenwich; noon by default
---@return number
function planets.day(year, month, day, hour)
  check_number("planets.day", year)
  check_number("planets.day", month)
  check_number("planets.day", day)
  if hour ~= nil then check_number("planets.day", hour) end
  if month < 1 or month > 12 or day < 1 or day >= 32 then
    mistake("planets.day takes year, month and day, such as 2026, 3, 20; got " .. shown(year) .. ", " .. shown(month)
      .. ", " .. shown(day))
  end
  -- Years that begin in March: the leap day is their last.
  local y = month > 2 and year or year - 1
  local m = (month + 9) % 12
  local whole = 365 * y + y // 4 - y // 100 + y // 400 + (153 * m + 2) // 5 + day - 1
  return whole - 730425 + ((hour or 12) - 12) / 24
end

--- Kepler's equation E - e sin E = M, solved for E by Newton's steps from E = M + e sin M: at most five up to e = 0.21.
---@param mean number the mean anomaly M, radians
---@param eccentricity number e, 0 to 0.9
---@return number E the eccentric anomaly, radians
function planets.kepler(mean, eccentricity)
  check_number("planets.kepler", mean)
  check_number("planets.kepler", eccentricity)
  if eccentricity < 0 or eccentricity > 0.9 then
    mistake("planets.kepler takes an eccentricity from 0 to 0.9; got " .. shown(eccentricity))
  end
  local e = eccentricity
  local E = mean + e * math.sin(mean)
  for _ = 1, 30 do
    local step = (E - e * math.sin(E) - mean) / (1 - e * math.cos(E))
    E = E - step
    if math.abs(step) < 1e-13 then break end
  end
  return E
end

-- A point of the orbit's own plane, turned into the ecliptic: by the argument of perihelion, the inclination, the node.
local function turn(px, py, peri, inclination, node)
  local w, i, n = math.rad(peri - node), math.rad(inclination), math.rad(node)
  local cw, sw, ci, si, cn, sn = math.cos(w), math.sin(w), math.cos(i), math.sin(i), math.cos(n), math.sin(n)
  return (cw * cn - sw * sn * ci) * px - (sw * cn + cw * sn * ci) * py,
         (cw * sn + sw * cn * ci) * px - (sw * sn - cw * cn * ci) * py,
         sw * si * px + cw * si * py
end

local methods = {}

-- Round the Sun evenly, in the plane of the Earth's way.
function methods.circle(of, t)
  local a, L = of[1][1], math.rad(of[1][4] + of[2][4] * t)
  return a * math.cos(L), a * math.sin(L), 0.0
end

local function on_ellipse(a, e, i, L, peri, node)
  local mean = math.rad((L - peri + 180) % 360 - 180)
  local E = planets.kepler(mean, e)
  return turn(a * (math.cos(E) - e), a * math.sqrt(1 - e * e) * math.sin(E), peri, i, node)
end

-- The ellipse of the year 2000 for ever.
function methods.ellipse(of, t)
  local e = of[1]
  return on_ellipse(e[1], e[2], e[3], e[4] + of[2][4] * t, e[5], e[6])
end

-- The ellipse that changes.
function methods.elements(of, t)
  local e, r = of[1], of[2]
  return on_ellipse(e[1] + r[1] * t, e[2] + r[2] * t, e[3] + r[3] * t, e[4] + r[4] * t, e[5] + r[5] * t, e[6] + r[6] * t)
end

--- Where a planet is on a day, seen from the Sun: astronomical units in the mean ecliptic of the year 2000, x towards the
--- spring point, z towards the north. The method is "elements" (Standish's, the most accurate), "ellipse" (that of the year
--- 2000 for ever) or "circle" (evenly round the Sun, all in one plane): what accuracy costs is drawn by
--- `./fulcrum bench planets`.
---@param name string
---@param day number see planets.day
---@param method string|nil "elements" by default
---@return number x, number y, number z
function planets.place(name, day, method)
  local of = elements_of("planets.place", name)
  check_number("planets.place", day)
  local compute = methods[method or "elements"]
  if not compute then
    mistake("planets.place knows the methods circle, ellipse and elements; got " .. shown(method))
  end
  if day < first_day or day > last_day then
    mistake("planets.place knows the years 1800 to 2050, the days " .. first_day .. " to " .. last_day .. "; got "
      .. shown(day))
  end
  return compute(of, day / days_a_century)
end

--- Its longitude seen from the Sun: degrees from the spring point of the year 2000, 0 to 360.
---@param name string
---@param day number see planets.day
---@param method string|nil see planets.place
---@return number
function planets.longitude(name, day, method)
  local x, y = planets.place(name, day, method)
  return math.deg(math.atan(y, x)) % 360
end

return setmetatable(planets, {
  __index = function(_, field) program.unknown(module_name, planets, field) end,
})
