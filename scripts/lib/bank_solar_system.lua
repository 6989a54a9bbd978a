--- Questions for revision on the planets: the solar system lesson's, asked again elsewhere. See `bank`.

local numbers = require "numbers"
local planets = require "planets"

local how_many = numbers.words(0, 30)

local names = {}
for i, name in ipairs(planets.names) do names[i] = name == "Earth" and "Earth|the Earth" or name end

local function called(name) return name == "Earth" and "the Earth" or name end

local function upper(text) return (text:gsub("^%l", string.upper)) end

-- The planet with the most (sign 1) or the least (-1) of what `of` gives.
local function extreme(of, sign)
  local best = planets.names[1]
  for _, name in ipairs(planets.names) do
    if sign * of(name) > sign * of(best) then best = name end
  end
  return best
end

local function radius(name) return planets.facts(name).radius end
local function distance(name) return planets.facts(name).distance end
local function mass(name) return planets.facts(name).mass end

-- "How many moons does Mars have?"
local function moons(name)
  local n = planets.facts(name).moons
  local words = numbers.word(n)
  local thing = n == 1 and "moon" or "moons"
  local named = name == "Earth" and "[the] Earth" or name
  return {
    id = "solar_moons_" .. name:lower(), like = { "moons_" .. name:lower(), "your_turn" }, point = "noun_number", idea = "planets",
    prompt = ("How many moons does %s have?"):format(called(name)),
    answers = { called(name) .. " has {number} <plural:moon>", "(it|" .. named .. ") has [got] {number} <plural:moon>",
                "there are {number} <plural:moon>", "{number} <plural:moon>",
                "(it|" .. named .. ") (doesn't have|hasn't got) {none}", "there aren't {none}", "{zero}", "{many}", "(it|" .. named .. ") has {many}" },
    nearly = { "(it|there|[the] " .. name .. ") [(is|are|has|have)] {number} [(moon|moons)]", "[it] (have|is|are) {number} [(moon|moons)]",
               "(it|[the] " .. name .. ") (have not|not have|don't have|haven't|doesn't has) {none}" },
    lists = { number = how_many, none = { "any moons|any|a moon" }, zero = { "nothing" }, many = { "many moons|many|lots of moons|a lot of moons" } },
    right = function(a)
      if a.many then return false end
      return ((a.none or a.zero) and 0 or numbers.value(a.number)) == n
    end,
    hint = "Remember what goes round it. Say a number.",
    solution = ("%s has %s %s."):format(upper(called(name)), words, thing),
    examples = {
      right = { ("%s has %s %s"):format(called(name), words, thing), n == 0 and "it doesn't have any moons" or ("it has %s"):format(words),
                n == 0 and called(name) .. " has none" or words },
      wrong = { ("%s has %s moons"):format(called(name), numbers.word(n + 3)), n > 0 and "it doesn't have any moons" or "it has one moon" },
      form = { ("%s have %s %s"):format(called(name), words, thing) },
    },
  }
end

-- Said for another adjective as well as that.
local alike = { big = "large", near = "close", hard = "difficult" }

local function degree(form, adjective)
  local first = ("<%s:%s>"):format(form, adjective)
  return alike[adjective] and ("(%s|<%s:%s>)"):format(first, form, alike[adjective]) or first
end

-- "Which planet is the biggest?"
local function most(id, adjective, superlative, of, sign, tail)
  local right = extreme(of, sign)
  local wrong = extreme(of, -sign)
  return {
    id = "solar_" .. id, like = { "planets", "your_turn" }, point = "comparison", idea = "planets",
    prompt = ("Which planet is %s?"):format(superlative),
    answers = { "[the] {planet} is the " .. degree("superlative", adjective) .. " [planet|one]" .. (tail and " [" .. tail .. "]" or "")
                  .. " [(of all|of them all|of all the planets|in (our|the) solar system)]", "[the] {planet} is", "[it is] [the] {planet}", "{no_planet} [is]", "{no_planet} is the " .. degree("superlative", adjective),
                "the " .. degree("superlative", adjective) .. " [planet|one]" .. (tail and " [" .. tail .. "]" or "") .. " is [the] {planet}",
                "[the] {planet} is " .. degree("comparative", adjective) .. (tail and " [" .. tail .. "]" or "") .. " than (all the|the|any) other (planets|planet)" },
    nearly = tail and { "[the] {planet} is [the] <superlative:" .. adjective .. "> of the Sun" } or nil,
    lists = { planet = names, no_planet = { "the Sun", "the Moon", "Pluto" } },
    right = function(a) return a.planet == right end,
    hint = "Remember how they go round the Sun, and how they look from near.",
    solution = ("%s is %s."):format(upper(called(right)), superlative),
    examples = {
      right = { ("%s is %s"):format(called(right), superlative), called(right) .. " is", right, ("%s is %s"):format(superlative, called(right)) },
      wrong = { ("%s is %s"):format(called(wrong), superlative) },
      form = { ("%s is most %s"):format(called(right), adjective), ("%s is more %s"):format(called(right), (superlative:gsub("^the (%a+)est.*", "%1er"))) },
    },
  }
end

-- "Which one is bigger: the Earth or Mars?"
local function compare(id, adjective, comparative, of, sign, first, second, tail)
  local right, wrong = first, second
  if sign * of(second) > sign * of(first) then right, wrong = second, first end
  local after = tail and (" " .. tail) or ""
  -- "It is harder to turn Jupiter."
  local is_turning = tail == "to turn"
  local away = tail == "from the Sun"
  local to_turn = away and { "[the] {planet} is <comparative:far> away [from the Sun] [than [the] {other}]" } or is_turning and { "it is " .. degree("comparative", adjective) .. " to turn [the] {planet} [than [the] {other}]" } or {}
  return {
    id = ("solar_%s_%s_%s"):format(id, first:lower(), second:lower()), like = { "harder", "your_turn" }, point = "comparison",
    idea = id == "turn" and "turning" or "planets",
    prompt = ("Which one is %s%s: %s or %s?"):format(comparative, after, called(first), called(second)),
    answers = { "[the] {planet} is " .. degree("comparative", adjective) .. (tail and " [" .. tail .. "]" or "") .. " [than [the] {other}]",
                "[the] {planet} is", "[it is] [the] {planet}",
                "the " .. degree("comparative", adjective) .. " (one|planet)" .. (tail and " [" .. tail .. "]" or "") .. " is [the] {planet}",
                table.unpack(to_turn) },
    nearly = is_turning and { "[the] {planet} is more (easily|hardly) to turn" } or nil,
    lists = { planet = { first, second }, other = { first, second } },
    right = function(a) return a.planet == right and a.other ~= right end,
    hint = "Remember how they looked and how they turned.",
    solution = ("%s is %s%s than %s."):format(upper(called(right)), comparative, after, called(wrong)),
    examples = {
      right = { ("%s is %s%s than %s"):format(called(right), comparative, after, called(wrong)), called(right),
                ("the %s one is %s"):format(comparative, called(right)),
                is_turning and ("it is %s to turn %s"):format(comparative, called(right)) or called(right) .. " is" },
      wrong = { ("%s is %s%s than %s"):format(called(wrong), comparative, after, called(right)) },
      form = { ("%s is more %s%s than %s"):format(called(right), comparative, after, called(wrong)) },
    },
  }
end

return {
  {
    id = "solar_planets", like = { "planets" }, point = "noun_number", idea = "planets",
    prompt = "How many planets are there in our solar system?",
    answers = { "there are {number} <plural:planet> [in (our|the) solar system]",
                "(there are|we have|the Sun has|it has) {number} <plural:planet> [in (our|the) solar system]",
                "(our|the) solar system has {number} <plural:planet>", "in (our|the) solar system there are {number} <plural:planet>",
                "{number} <plural:planet>" },
    nearly = { "(it|they|here|there|in solar system) (is|are|has|have) {number} [(planet|planets)]" },
    lists = { number = how_many },
    right = function(a) return numbers.value(a.number) == #planets.names end,
    hint = "Mercury, Venus, Earth, Mars, and the big ones.",
    solution = "There are eight planets.",
    examples = { right = { "there are eight planets", "eight", "our solar system has eight planets" }, wrong = { "there are nine planets" },
                 form = { "there are eight planet", "there is eight planets" } },
  },
  moons "Earth", moons "Mars", moons "Venus", moons "Neptune",
  most("biggest", "big", "the biggest", radius, 1),
  most("smallest", "small", "the smallest", radius, -1),
  most("nearest", "near", "the nearest to the Sun", distance, -1, "to the Sun"),
  compare("bigger", "big", "bigger", radius, 1, "Earth", "Mars"),
  compare("smaller", "small", "smaller", radius, -1, "Venus", "Jupiter"),
  compare("farther", "far", "farther", distance, 1, "Saturn", "Jupiter", "from the Sun"),
  compare("turn", "hard", "harder", mass, 1, "Earth", "Jupiter", "to turn"),
  compare("turn", "easy", "easier", mass, -1, "Mars", "Saturn", "to turn"),
  {
    id = "solar_side", like = { "side_or_pole" }, point = "verb", idea = "turning",
    prompt = "Where does the same push make a planet turn faster: at the side or near the pole?",
    answers = { "it turns (faster|more) [(when|if) (I|you|we) push [it]] (at|near|on) the {place}", "(at|near|on) the {place}", "the {place}",
                "(at|near|on) the {place} it turns (faster|more)", "far from the {other}", "not (at|near|on) the {other}", "at the same {speed}",
                "(when|if) (I|you|we) push [it] (at|near|on) the {place}" },
    nearly = { "(at|near|on) [the] {place} [it] (turns|turn) [it] (faster|more)", "(it|planet|the planet) (turn|turning|is turning) [(more|faster|fast)] (at|near|on|in) [the] {place}", "in [the] {place}" },
    lists = { place = { "side|rim|equator|edge", "pole|north pole|top" }, other = { "side|rim|equator|edge", "pole|north pole|top" }, speed = { "speed" } },
    right = function(a) return a.place == "side" or a.other == "pole" end,
    hint = "A longer arm turns more.",
    solution = "It turns faster at the side: the arm is longer there.",
    examples = { right = { "it turns faster at the side", "at the side", "it turns faster when I push at the side" }, wrong = { "near the pole" },
                 form = { "it turn faster at the side" } },
  },
  {
    id = "solar_round", like = { "planets" }, point = "preposition", idea = "planets",
    prompt = "What do all the planets go round?",
    answers = { "they go (round|around) [the] {star}", "they all go (round|around) [the] {star}", "they [all] (move|travel|turn) (round|around) [the] {star}", "they [all] (orbit|circle) [the] {star}", "[all] [the] planets (go|move|travel) (round|around) [the] {star}", "[all] [the] planets (orbit|circle) [the] {star}",
                "[it is] [the] {star}", "(round|around) the {star}" },
    nearly = { "(they|planets|the planets) (go|goes) (round|around) (of|to) [the] {star}", "(they|planets|the planets) (goes|going|is go|are go|turn) [(round|around)] [the] {star}" },
    lists = { star = { "Sun", "Moon", "Earth" } },
    right = function(a) return a.star == "Sun" end,
    hint = "It is in the middle, and it is hot.",
    solution = "They go round the Sun.",
    examples = { right = { "they go round the Sun", "the Sun", "they orbit the Sun" }, wrong = { "they go round the moon" },
                 form = { "they goes round the Sun" } },
  },
  {
    id = "solar_day", like = { "your_turn" }, point = "noun_number", idea = "planets",
    prompt = "How many hours does it take the Earth to turn round once?",
    answers = { "it takes [(it|the Earth)] [about] {number} (<plural:hour>|h) [to turn round [once]]", "(it|the Earth) (needs|takes) [about] {number} (<plural:hour>|h)",
                "[about] {number} (<plural:hour>|h)", "a {long}", "one {long}", "it (takes|needs) a {long}", "it (takes|needs) one {long}", "{days} days", "it (takes|needs) {days} days",
                "one day [or] {number} (<plural:hour>|h)" },
    nearly = { "(it|Earth|the Earth) (need|take|is|has) {number} (hour|hours)" },
    lists = { number = how_many, days = { "365", "30", "28", "7|seven", "2|two" }, long = { "day", "week", "month", "year" } },
    right = function(a) return a.long == "day" or (a.number ~= nil and numbers.value(a.number) == math.floor(planets.facts("Earth").day / 3600 + 0.5)) end,
    hint = "It is a day and a night.",
    solution = "It takes twenty-four hours.",
    examples = { right = { "it takes twenty-four hours", "it needs twenty four hours", "24 hours" }, wrong = { "it takes twelve hours" },
                 form = { "it takes 24 hour" } },
  },
}
