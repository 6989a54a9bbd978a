--- Questions for revision on where things are and what is stacked: the lesson with blocks, asked again elsewhere. See `bank`.

-- "The red block is on the blue block. Where is the blue block?"
local function where(id, told, asked, place, other, wrong)
  return {
    id = "stacks_" .. id, like = { "on_top", "between" }, point = "preposition", idea = "place",
    prompt = ("%s Where is the %s block?"):format(told, asked),
    answers = { "(it|the " .. asked .. " block) is {place} the {thing}", "[it is] {place} the {thing}" },
    nearly = { "(it|" .. asked .. " block) [is] {place} [the] {thing}", "{place} {thing}" },
    lists = { place = { "on top of|on|above|over", "under|below|underneath|beneath", "next to|beside|near" },
              thing = { "red block|red one", "blue block|blue one", "green block|green one", "yellow block|yellow one" } },
    right = function(a) return a.place == place and a.thing == other .. " block" end,
    hint = "Draw it in your head.",
    solution = ("It is %s the %s block."):format(place, other),
    examples = {
      right = { ("it is %s the %s block"):format(place, other), ("the %s block is %s the %s one"):format(asked, place, other) },
      wrong = { ("it is %s the %s block"):format(wrong, other) },
      form = { ("it is %s %s block"):format(place, other) },
    },
  }
end

local height = { red = 0.1, blue = 0.2, green = 0.3 }   -- metres

return {
  where("under", "The red block is on the blue block.", "blue", "under", "red", "next to"),
  where("on", "The green block is under the yellow block.", "yellow", "on top of", "green", "under"),
  where("next", "The blue block is next to the green block.", "green", "next to", "blue", "under"),
  {
    id = "stacks_between", like = { "between" }, point = "preposition", idea = "place",
    prompt = "A red, a blue and a green block stand in a row. Which one is between the others?",
    answers = { "the {colour} (block|one) is between (them|the others|the other blocks|the red [(block|one)] and the green (block|one))", "it is the {colour} (block|one)", "the {colour} (block|one) [is]", "the {colour} (block|one) is in the middle" },
    nearly = { "[it is] [the] {colour}", "{colour} block", "[the] {colour} (block|one) is between", "{colour} block is between them" },
    lists = { colour = { "red", "blue", "green" } },
    right = function(a) return a.colour == "blue" end,
    hint = "It is in the middle.",
    solution = "The blue block is between them.",
    examples = { right = { "the blue block is between them", "the blue one", "the blue one is in the middle" }, wrong = { "it is the red block" },
                 form = { "blue block is between them" } },
  },
  {
    id = "stacks_tallest", like = { "taller" }, point = "comparison", idea = "place",
    prompt = "The red block is 10 centimetres tall, the blue one 20 and the green one 30. Which block is the tallest?",
    answers = { "the {colour} (block|one) is the <superlative:tall> [(block|one)] [of (all|them all|the three)]", "it is the {colour} (block|one)", "the {colour} (block|one) [is]",
                "the <superlative:tall> [(block|one)] is the {colour} (block|one)" },
    nearly = { "[the] {colour} [block]", "{colour} block is the tallest" },
    lists = { colour = { "red", "blue", "green" } },
    right = function(a) return a.colour ~= nil and height[a.colour] == 0.3 end,
    hint = "Which number is the biggest?",
    solution = "The green block is the tallest.",
    examples = { right = { "the green block is the tallest", "the green one", "the tallest is the green one" },
                 wrong = { "the red block is the tallest" }, form = { "the green block is most tall", "the green block is more taller" } },
  },
  {
    id = "stacks_bottom", like = { "on_top" }, point = "preposition", idea = "weight",
    prompt = "You build a tower. Should the heavy block be at the top or at the bottom?",
    answers = { "(it|the heavy block) (should|must) be at the {place}", "at the {place}", "(I|you|we) should put (it|the heavy block) at the {place}", "the {place}" },
    nearly = { "(it|the heavy block|heavy block) (should|must) [be] (in|on|at) [the] {place}", "(in|on) [the] {place}" },
    lists = { place = { "bottom", "top" } },
    right = function(a) return a.place == "bottom" end,
    hint = "A tower with a heavy top falls easily.",
    solution = "It should be at the bottom.",
    examples = { right = { "it should be at the bottom", "at the bottom" }, wrong = { "at the top" }, form = { "it should in the bottom" } },
  },
  {
    id = "stacks_heavier", like = { "heavier" }, point = "comparison", idea = "weight",
    prompt = "Two blocks have the same size, one of wood and one of metal. Which block is heavier?",
    answers = { "the {thing} is <comparative:heavy> [than the {other}]", "it is the {thing}", "the {thing} [is]",
                "the <comparative:heavy> (block|one) is the {thing}" },
    nearly = { "{thing}", "{thing} is heavier", "the {thing} is heavy" },
    lists = { thing = { "metal block|metal one|block of metal", "wooden block|wooden one|block of wood|wood block" },
              other = { "metal block|metal one", "wooden block|wooden one" } },
    right = function(a) return a.thing == "metal block" and a.other ~= "metal block" end,
    hint = "Remember both in your hand.",
    solution = "The metal block is heavier.",
    examples = { right = { "the metal block is heavier than the wooden block", "the metal one" }, wrong = { "the wooden block is heavier" },
                 form = { "the metal block is more heavy", "metal block is heavier" } },
  },
  {
    id = "stacks_made", like = { "heavier" }, point = "passive_voice", idea = "materials",
    prompt = "What is a wooden block made of?",
    answers = { "[a|an|the] {thing} <made_of:{material}>" },
    lists = { thing = { "wooden block", "block" }, material = { "metal", "wood", "rock|stone", "rubber" } },
    right = function(a) return a.material == "wood" end,
    hint = "It was a tree.",
    solution = "A wooden block is made of wood.",
    examples = { right = { "a wooden block is made of wood", "wood", "it is made of wood" }, wrong = { "it is made of metal" },
                 form = { "it is made by wood", "it made of wood" } },
  },
}
