--- Questions for revision on weight: the gravity game's, asked again elsewhere. See `bank`.

local numbers = require "numbers"

-- Kilograms, as the toy fruit of the gravity game weigh.
local mass = { watermelon = 3, apple = 0.2039, banana = 0.12, egg = 0.0612 }
local fruit = { "watermelon", "apple", "banana", "egg" }

local function heaviest(names, sign)
  local best = names[1]
  for _, name in ipairs(names) do
    if sign * mass[name] > sign * mass[best] then best = name end
  end
  return best
end

local function one(name) return (name:match "^[aeiou]" and "an " or "a ") .. name end

local both = "(they [both]|both|[both] (an|the) apple and (a|the) watermelon) [begin to]"

-- "Which one is the heaviest?", of all four.
local function superlative(adjective, sign, most)
  local right = heaviest(fruit, sign)
  local wrong = heaviest(fruit, -sign)
  return {
    id = "gravity_" .. most, like = { most }, point = "comparison", idea = "weight",
    prompt = ("A watermelon, an apple, a banana and an egg: which one is the %s?"):format(most),
    answers = { "[a|an|the] {thing} is the <superlative:" .. adjective .. "> [one|thing|fruit] [of (all|them all|the four)]",
                "the <superlative:" .. adjective .. "> [one|thing|fruit] [of (all|them all|the four)] is [a|an|the] {thing}", "[a|an|the] {thing} is" },
    lists = { thing = fruit },
    right = function(a) return a.thing ~= nil and heaviest(fruit, sign) == a.thing end,
    hint = "Think of the four in your bucket.",
    solution = ("%s is the %s."):format(one(right):gsub("^%l", string.upper), most),
    examples = {
      right = { one(right) .. " is the " .. most, "the " .. right, ("the %s is the %s"):format(most, right), "the " .. right .. " is" },
      wrong = { one(wrong) .. " is the " .. most },
      form = { right .. " is the " .. most, one(right) .. " is most " .. adjective, "it is " .. right .. "s", right .. " is" },
    },
  }
end

-- "Which one is heavier, an apple or an egg?"
local function comparative(adjective, sign, more, first, second)
  local amount = sign > 0 and "more" or "less"
  local right = heaviest({ first, second }, sign)
  local wrong = right == first and second or first
  return {
    id = ("gravity_%s_%s_%s"):format(more, first, second), like = { "heavier", "lightest" }, point = "comparison", idea = "weight",
    prompt = ("Which one is %s, %s or %s?"):format(more, one(first), one(second)),
    answers = { "[a|an|the] {thing} is <comparative:" .. adjective .. "> [than [a|an|the] {other}]",
                "[a|an|the] {thing} is the <comparative:" .. adjective .. "> (one|fruit)",
                "the <comparative:" .. adjective .. "> (one|thing) is [a|an|the] {thing}", "[a|an|the] {thing} is",
                "[a|an|the] {thing} weighs " .. amount .. " [than [a|an|the] {other}]" },
    lists = { thing = { first, second }, other = { first, second } },
    right = function(a) return a.thing == right and a.other ~= right end,
    hint = "Which one pulled your hand down more?",
    solution = ("%s is %s than %s."):format(one(right):gsub("^%l", string.upper), more, one(wrong)),
    examples = {
      right = { ("%s is %s than %s"):format(one(right), more, one(wrong)), one(right), ("the %s is the %s of the two"):format(right, more),
                ("the %s one is the %s"):format(more, right), ("the %s weighs %s than the %s"):format(right, amount, wrong) },
      wrong = { ("%s is %s than %s"):format(one(wrong), more, one(right)) },
      form = { ("%s is more %s than %s"):format(one(right), more, one(wrong)), ("the %s one is %ss"):format(more, right) },
    },
  }
end

return {
  superlative("heavy", 1, "heaviest"),
  superlative("light", -1, "lightest"),
  comparative("heavy", 1, "heavier", "apple", "egg"),
  comparative("heavy", 1, "heavier", "banana", "watermelon"),
  comparative("light", -1, "lighter", "egg", "banana"),
  comparative("light", -1, "lighter", "watermelon", "apple"),
  {
    id = "gravity_together", like = { "heavier" }, point = "verb", idea = "weight",
    prompt = "There is no air. An apple and a watermelon begin to fall at the same time. Which one is faster, or do they fall together?",
    answers = { both .. " (fall|land|are falling) {together}", both .. " (fall|land) (at|with) the {same}", "(at|with) the {same}", both .. " (fall|land) at {same_one}", both .. " do not fall {apart}", "(they|both) are {equal}", both .. " are falling (at|with) the {same}", "{neither} is <comparative:fast>",
                "[a|an|the] {thing} is <comparative:fast> [than [a|an|the] {other}]",
                "[a|an|the] {thing} falls <comparative:fast> [than [a|an|the] {other}]" },
    lists = { together = { "together|equally fast|just as fast" }, apart = { "together|equally fast|just as fast|at the same time|at the same speed" },
              same = { "same speed", "same time" }, same_one = { "one speed" }, other = { "apple", "watermelon" }, equal = { "equally fast|just as fast" },
              neither = { "neither|neither of them|none of them|no one" }, thing = { "apple", "watermelon" } },
    nearly = { both .. " (fall|land|are falling|falling) in the {same}", "in the {same}" },
    right = function(a) return (a.together or a.same or a.same_one or a.equal or a.neither) ~= nil end,
    hint = "Without air nothing slows them down.",
    solution = "They fall together: without air all things fall equally fast.",
    examples = { right = { "they fall together", "they fall at the same speed", "they are equally fast", "none of them is faster" },
                 wrong = { "the watermelon is faster" }, form = { "they falls together", "they are an equally fast" } },
  },
  {
    id = "gravity_pulls", like = { "heaviest" }, point = "verb", idea = "weight",
    prompt = "What pulls an apple down?",
    answers = { "[the] {puller} pulls (it|an apple|the apple|apples|things) down", "[the] {puller} pulls (it|an apple|the apple)",
                "it is [the] {puller}", "[the] {puller} [does]", "[the] {puller} pulls down (an apple|the apple|apples)" },
    nearly = { "[the] {puller} (pull|pulls) down it", "[the] {puller} force [of [the] Earth]", "[the] {puller} (pull|pulling|is pull|is pulling) (it|apple|the apple|an apple) [down]" },
    lists = { puller = { "Earth|Earth's gravity|gravity of the Earth", "gravity|force of gravity|weight", "wind", "Moon", "tree", "air" } },
    right = function(a) return a.puller == "Earth" or a.puller == "gravity" end,
    hint = "What is under our feet?",
    solution = "The Earth pulls it down. That is gravity.",
    examples = { right = { "the Earth pulls it down", "gravity", "the Earth's gravity pulls it down" }, wrong = { "the wind pulls it down" },
                 form = { "the Earth pull it down" } },
  },
  {
    id = "gravity_moon", like = { "heavier", "lightest" }, point = "comparison", idea = "weight",
    prompt = "Where does an apple weigh less: on the Earth or on the Moon?",
    answers = { "(it|an apple|the apple) weighs less on the {place} [than on the {other}]",
                "(it|an apple|the apple) is <comparative:light> on the {place} [than on the {other}]", "on the {place} [it (weighs less|is <comparative:light>)]",
                "(it|an apple|the apple) weighs more on the {heavy} [than on the {other}]",
                "(it|an apple|the apple) is <comparative:heavy> on the {heavy} [than on the {other}]",
                "(it|an apple|the apple) does not weigh as much on the {place} [as on the {other}]",
                "(it|an apple|the apple) is not as <adjective:heavy> on the {place} [as on the {other}]",
                "(it|an apple|the apple) weighs {same} [on both]", "(they|both) are {same}" },
    nearly = { "(it|apple|the apple) (weigh|is weigh) less (on|in|at) [the] {place}", "(in|at) [the] {place}" },
    lists = { place = { "Earth", "Moon" }, other = { "Earth", "Moon" }, heavy = { "Earth", "Moon" }, same = { "the same" } },
    right = function(a) return (a.place == "Moon" and a.other ~= "Moon") or (a.heavy == "Earth" and a.other ~= "Earth") end,
    hint = "The Moon pulls only a sixth as hard as the Earth.",
    solution = "It weighs less on the Moon.",
    examples = { right = { "it weighs less on the Moon", "on the moon" }, wrong = { "it weighs less on the Earth" },
                 form = { "it is more light on the moon", "it weigh less on the moon", "it is the lighter on the moon" } },
  },
  {
    id = "gravity_unit", like = { "heaviest" }, point = "noun_number", idea = "weight",
    prompt = "What do we measure weight in: newtons, metres or seconds?",
    answers = { "(we|you|people) measure (it|weight|the weight) in {unit}", "(weight|it) is [measured] in {unit}", "[in] {unit}", "(we|you|people) weigh things in {unit}",
                "the unit [(of|for) weight] is the newton", "(we|you) use {unit}" },
    nearly = { "(we|you) (measures|are measure|measuring) [the] (it|weight) (in|with|by) {unit}", "[(we|you) measure (it|weight|the weight)] (with|by) {unit}" },
    lists = { unit = { "newtons|N", "metres", "seconds", "kilograms|kilos", "grams", "hours" } },
    right = function(a) return a.unit == nil or a.unit == "newtons" end,
    hint = "The arrow under the bucket says it.",
    solution = "We measure weight in newtons.",
    examples = { right = { "we measure weight in newtons", "in newtons", "you use newtons" }, wrong = { "we measure it in metres" },
                 form = { "we measure weight with newtons", "you use this newtons", "in the newtons", "we use a newton" } },
  },
  {
    id = "gravity_three", like = { "heavier" }, point = "noun_number", idea = "weight",
    prompt = "A toy egg weighs one newton. How many newtons do four toy eggs weigh?",
    answers = { "[together] they weigh {number} (<plural:newton>|N)", "([the] four [toy] eggs|the eggs) weigh {number} (<plural:newton>|N)",
                "it is {number} (<plural:newton>|N)", "{number} (<plural:newton>|N)" },
    nearly = { "(they|eggs|it) (weighs|is|are|have|has) {number} (newton|newtons)" },
    lists = { number = numbers.words(0, 12) },
    right = function(a) return numbers.value(a.number) == 4 end,
    hint = "One and one and one and one.",
    solution = "They weigh four newtons.",
    examples = { right = { "they weigh four newtons", "4 newtons" }, wrong = { "they weigh three newtons" },
                 form = { "they weigh four newton", "this four eggs weigh four newtons" } },
  },
  {
    id = "gravity_yes", like = { "heavier" }, point = "comparison", idea = "weight",
    prompt = "Is a watermelon heavier than an egg?",
    answers = { "{yes} it is", "{yes} [it is [<comparative:heavy> [than (an egg|the egg)]]]", "{yes} [(much|a lot|far)] <comparative:heavy>", "of course", "{yes} (a|the) watermelon is <comparative:heavy> [than (an|the) egg]",
                "{no} [(it isn't|it is not)]", "(it|a watermelon|the watermelon) is <comparative:heavy> [than (an|the) egg]",
                "[{yes}] (it|a watermelon|the watermelon) weighs more [than (an|the) egg]", "[{yes}] (an|the) egg is not as <adjective:heavy> as (a|the) watermelon",
                "[{yes}] (an|the) egg is <comparative:light> [than (a|the) watermelon]", "{yes} of course [it is]", "of course it is", "the watermelon [is]",
                "[{no}] (an|the) {egg} is <comparative:heavy> [than (a|the) watermelon]", "[{no}] they weigh {same}", "[{no}] they are {same}" },
    nearly = { "{yes} (it does|is [heavier])", "{no} (it doesn't|is not)" },
    lists = { yes = { "yes|yeah|sure" }, no = { "no" }, egg = { "egg" }, same = { "the same" } },
    right = function(a) return a.no == nil and a.egg == nil and a.same == nil end,
    hint = "Remember both in your bucket.",
    solution = "Yes, it is.",
    examples = { right = { "yes, it is", "yes", "a watermelon is heavier than an egg" }, wrong = { "no, it isn't" },
                 form = { "a watermelon is more heavy than an egg" } },
  },
}
