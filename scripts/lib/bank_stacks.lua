--- Questions for revision on where things are and what is stacked: the lesson with blocks, asked again elsewhere. See `bank`.

-- What is said with another preposition than the right one, "on top the blue block", "next of it", is said back with the right one: each of
-- the three places has an answer of its own, with a slot of its own.
local slips = {
  "(on top|on top from|on top to|on the top from|up|up of|up from|onto|in) [the] {thing:lower}", "(down|down of|down from|down to|below of|below from) [the] {thing:upper}",
  "(next|next of|next from|next by|next at|near of|near from|besides|besides of) [the] {thing:side}", "{place} (of|from|to) [the] {thing}",
}
local without_it = { "is on top of [the] {thing:lower}", "is below [the] {thing:upper}", "is next to [the] {thing:side}", "is {place} [the] {thing}" }

-- Where that is, as the questions call it.
local function place_said(a)
  local alone = { ["on top"] = "on top of", ["on top of it"] = "on top of", below = "under", ["below it"] = "under", ["next to it"] = "next to" }
  return alone[a.alone or a.it] or a.lower and "on top of" or a.upper and "under" or a.side and "next to" or a.place == "on" and "on top of" or a.place == "beside" and "next to" or a.place
end

-- "The red block is on the blue block. Where is the blue block?"
local function where(id, told, asked, place, other, wrong, wrongly)
  local it = "(it|the " .. asked .. " (block|one))"
  local nearly = { it .. " [is] {place} [the] {thing}", "{place} {thing}", table.unpack(without_it) }
  for _, slip in ipairs(slips) do nearly[#nearly + 1] = "[[" .. it .. "] is] " .. slip end
  return {
    id = "stacks_" .. id, like = { "on_top", "between" }, point = "preposition", idea = "place",
    prompt = ("%s Where is the %s block?"):format(told, asked),
    answers = { it .. " (is|stands|lies|sits) {place} the {thing}", "[it is] {place} the {thing}",
                "[" .. it .. " (is|stands|lies|sits)] on top of the {thing:lower}", "[" .. it .. " (is|stands|lies|sits)] below the {thing:upper}",
                "[" .. it .. " (is|stands|lies|sits)] next to the {thing:side}", "[" .. it .. " (is|stands|lies|sits)] {alone}", "[it (is|stands|lies|sits)] {it}",
                "[" .. it .. " is] at the {end}", "[it is] {elsewhere}", "the {thing} is {placed} it" },
    nearly = nearly,
    lists = { place = { "on|above|over", "under|underneath|beneath", "beside|near", "in front of", "behind", "inside" },
              placed = { "on|on top of|above|over", "under|below|underneath|beneath", "next to|beside|near" },
              thing = { "red block|red one", "blue block|blue one", "green block|green one", "yellow block|yellow one" },
              alone = { "on top", "below" }, it = { "on top of it", "below it", "next to it" },
              ["end"] = { "top", "bottom" }, elsewhere = { "in the middle|in between", "on the ground|on the floor", "on the left|to the left", "on the right|to the right" } },
    right = function(a)
      if a["end"] then return (a["end"] == "top" and "on top of" or "under") == place end
      if a.alone or a.it then return place_said(a) == place end
      if a.placed then   -- "The red block is on it."
        local same, turned = { on = "on top of", under = "under", ["next to"] = "next to" }, { on = "under", under = "on top of", ["next to"] = "next to" }
        if a.thing == asked .. " block" then return same[a.placed] == place end
        return turned[a.placed] == place and a.thing == other .. " block"
      end
      return place_said(a) == place and (a.thing or a.lower or a.upper or a.side) == other .. " block"
    end,
    hint = "Draw it in your head.",
    solution = ("It is %s the %s block."):format(place, other),
    examples = {
      right = { ("it is %s the %s block"):format(place, other), ("the %s block is %s the %s one"):format(asked, place, other),
                ("it stands %s it"):format(place), ("it lies %s it"):format(place), ("it sits %s it"):format(place) },
      wrong = { ("it is %s the %s block"):format(wrong, other) },
      form = { ("it is %s %s block"):format(place, other), ("is %s the %s block"):format(place, other), table.unpack(wrongly or {}) },
    },
  }
end

local height = { red = 0.1, blue = 0.2, green = 0.3 }   -- metres

return {
  where("under", "The red block is on the blue block.", "blue", "under", "red", "next to", { "it is under of the red block", "it is down the red block" }),
  where("on", "The green block is under the yellow block.", "yellow", "on top of", "green", "under", { "on top the green block", "it is up the green block", "in the green block" }),
  where("next", "The blue block is next to the green block.", "green", "next to", "blue", "under", { "next the blue block", "it is next of the blue block" }),
  {
    id = "stacks_between", like = { "between" }, point = "preposition", idea = "place",
    prompt = "A red, a blue and a green block stand in a row. Which one is between the others?",
    answers = { "the {colour} (block|one) is between (them|the others|the two|the other (two|ones|blocks)|the red [(block|one)] and the green (block|one)|the green [(block|one)] and the red (block|one))", "it is the {colour} (block|one)", "the {colour} (block|one) [is]", "the {colour} (block|one) is (in the middle|in between)", "the (block|one) in the middle is the {colour} (block|one)",
                "{none} [is between them]" },
    nearly = { "[it is] [the] {colour}", "{colour} block", "[the] {colour} (block|one) is between", "{colour} block is between them",
               "[the] {colour} [(block|one)] is between [the] (red|green) [(block|one)] and [the] (red|green) [(block|one)]" },
    lists = { colour = { "red", "blue", "green" }, none = { "neither|neither of them|none|none of them" } },
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
    answers = { "(it|the heavy (block|one)) (should|must) (be|go) (at|on) the {place}", "(it|the heavy (block|one)) (has to|needs to) (be|go) (at|on) the {place}", "(at|on) the {place}",
                "(I|you|we) (should|must|would) put (it|the heavy block) (at|on) the {place}", "put (it|the heavy block) (at|on) the {place}",
                "(it|the heavy (block|one)) (goes|belongs) (at|on) the {place}", "the {place}" },
    nearly = { "(it|the heavy block|heavy block) (should|must) [(be|to be|is)] (in|on|at) [the] {place}", "in [the] {place}" },
    lists = { place = { "bottom", "top" } },
    right = function(a) return a.place == "bottom" end,
    hint = "A tower with a heavy top falls easily.",
    solution = "It should be at the bottom.",
    examples = { right = { "it should be at the bottom", "the heavy block has to be at the bottom", "at the bottom" }, wrong = { "at the top" }, form = { "it should in the bottom" } },
  },
  {
    id = "stacks_heavier", like = { "heavier" }, point = "comparison", idea = "weight",
    prompt = "Two blocks have the same size, one of wood and one of metal. Which block is heavier?",
    answers = { "[the] {thing} is <comparative:heavy> [than [the] {other}]", "it is the {thing}", "the {thing} [is]",
                "the <comparative:heavy> (block|one) is the {thing}" },
    nearly = { "{thing}", "{thing} is heavier", "the {thing} is heavy" },
    lists = { thing = { "metal block|metal one|one of metal|metal", "wooden block|wooden one|one of wood|wood" }, other = { "metal block|metal one|metal", "wooden block|wooden one|wood" } },
    right = function(a) return a.thing == "metal block" and a.other ~= "metal block" end,
    hint = "Remember both in your hand.",
    solution = "The metal block is heavier.",
    examples = { right = { "the metal block is heavier than the wooden block", "the metal one" }, wrong = { "the wooden block is heavier" },
                 form = { "the metal block is more heavy", "metal block is heavier" } },
  },
  {
    id = "stacks_made", like = { "heavier" }, point = "passive_voice", idea = "materials",
    prompt = "What is a wooden block made of?",
    answers = { "[a|an|the] {thing} <made_of:{material}>", "the material is {material}",
                "[(it|a wooden block|the block) is made of] {material} from (a tree|trees)", "it comes from (a {source}|{source})" },
    lists = { thing = { "wooden block", "block" }, material = { "metal", "wood", "rock|stone", "rubber", "plastic", "paper", "glass" }, source = { "tree|trees" } },
    right = function(a) return a.material == "wood" or a.source ~= nil end,
    hint = "It was a tree.",
    solution = "A wooden block is made of wood.",
    examples = { right = { "a wooden block is made of wood", "wood", "it is made of wood" }, wrong = { "it is made of metal" },
                 form = { "it is made by wood", "it made of wood" } },
  },
}
