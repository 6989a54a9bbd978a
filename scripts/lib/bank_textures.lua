--- Questions for revision on materials: the texture lesson's, asked again elsewhere. See `bank`.

-- What each is like: as `body.material` says it of the program's own materials (hardness, roughness and slipperiness).
local like = {
  metal = { hard = true, smooth = true, slippery = true },
  wood = { hard = true, rough = true },
  rock = { hard = true, rough = true },
}
-- The materials in order, the most so first.
local order = {
  hard = { "metal", "rock", "wood" },
  rough = { "rock", "wood", "metal" },
  slippery = { "metal", "wood", "rock" },
}
local adjectives = { "hard", "soft", "smooth", "rough", "slippery", "sticky" }
local called = { "metal", "wood", "rock|stone", "rubber", "glass", "sandpaper" }

local function place_in(list, name)
  for i, each in ipairs(list) do
    if each == name then return i end
  end
end

-- "What is metal like?"
local function what_like(name, first, second, wrong, slip)
  local known = like[name]
  return {
    id = "textures_like_" .. name, like = { "like_" .. name }, point = "adjective", idea = "materials",
    prompt = ("What is %s like?"):format(name),
    answers = { "{material} is <adjective:{feel}> [and <adjective:{feel:also}>]",
                "{material} (is|feels) <adjective:{feel}> [and <adjective:{feel:also}>]",
                "(it|this) feels <adjective:{feel}> [and <adjective:{feel:also}>]" },
    lists = { material = called, feel = adjectives },
    right = function(a)
      return (a.material or name) == name and known[a.feel] == true and (a.also == nil or known[a.also] == true and a.also ~= a.feel)
    end,
    hint = "Is it hard or soft? Is it smooth or rough?",
    solution = ("%s is %s and %s."):format(name:gsub("^%l", string.upper), first, second),
    examples = {
      right = { ("%s is %s and %s"):format(name, first, second), "it is " .. first, first .. " and " .. second },
      wrong = { ("%s is %s"):format(name, wrong), ("%s is %s and %s"):format(name, first, first) },
      form = { slip },
    },
  }
end

-- "Which is harder: metal or rubber?"
local function which(adjective, more, first, second)
  local best = order[adjective]
  local right, wrong = first, second
  if place_in(best, second) < place_in(best, first) then right, wrong = second, first end
  return {
    id = ("textures_%s_%s_%s"):format(adjective, first, second), like = { "like_" .. first, "like_" .. second },
    point = "comparison", idea = "materials",
    prompt = ("Which one is %s: %s or %s?"):format(more, first, second),
    answers = { "{material} is <comparative:" .. adjective .. "> [than {other}]", "it is {material}", "{material} is",
                "the <comparative:" .. adjective .. "> (one|material) is {material}" },
    lists = { material = { first, second }, other = { first, second } },
    right = function(a) return a.material == right and a.other ~= right end,
    hint = ("Remember how %s and %s felt."):format(first, second),
    solution = ("%s is %s than %s."):format(right:gsub("^%l", string.upper), more, wrong),
    examples = {
      right = { ("%s is %s than %s"):format(right, more, wrong), right, right .. " is", ("the %s one is %s"):format(more, right) },
      wrong = { ("%s is %s than %s"):format(wrong, more, right) },
      form = { ("%s is the %s than %s"):format(right, more, wrong) },
    },
  }
end

-- "A spaceship is … What is it made of?"
local function made_of(name, told, material, wrong, wooden)
  local thing = name:gsub("^a ", "")
  return {
    id = "textures_made_" .. thing, like = { "made_" .. thing }, point = "passive_voice", idea = "materials",
    prompt = told .. " What is it made of?",
    answers = { "[a|an|the] {thing} <made_of:{material}>", "it is {wooden}" },
    lists = { thing = { thing }, material = called, wooden = { "wooden" } },
    right = function(a) return (a.wooden and "wood" or a.material) == material end,
    hint = "Remember how it felt: hard, smooth or rough?",
    solution = ("%s is made of %s."):format(name:gsub("^%l", string.upper), material),
    examples = {
      right = { ("%s is made of %s"):format(name, material), material, wooden },
      wrong = { ("%s is made of %s"):format(name, wrong) },
      form = { ("%s is made by %s"):format(name, material), ("%s made of %s"):format(name, material) },
    },
  }
end

return {
  what_like("metal", "hard", "smooth", "soft", "metal is hard smooth"),
  what_like("wood", "hard", "rough", "slippery", "wood is hardly"),
  what_like("rock", "hard", "rough", "smooth", "rock is hard or rough"),
  which("hard", "harder", "metal", "wood"),
  which("hard", "harder", "rock", "wood"),
  which("rough", "rougher", "rock", "metal"),
  which("rough", "rougher", "wood", "metal"),
  which("rough", "rougher", "rock", "wood"),
  which("slippery", "more slippery", "metal", "wood"),
  which("slippery", "more slippery", "metal", "rock"),
  made_of("a spaceship", "A spaceship is hard, smooth and slippery, and nobody can look through its walls.", "metal", "wood"),
  made_of("a table", "A table feels a little rough, and once it was a tree.", "wood", "metal", "it is wooden"),
  made_of("a statue", "A statue is hard and rough, and comes from the mountains.", "rock", "rubber"),
  {
    id = "textures_paper", like = { "made_table" }, point = "passive_voice", idea = "materials",
    prompt = "What is paper made from?",
    answers = { "paper is made from {material}", "it is made from {material}", "[from] {material}" },
    nearly = { "(paper|it) [is] (made|make|makes) (of|by|from) {material}" },
    lists = { material = { "wood|trees", "metal", "rock|stone", "glass" } },
    right = function(a) return a.material == "wood" end,
    hint = "It grows.",
    solution = "Paper is made from wood.",
    examples = { right = { "paper is made from wood", "from trees" }, wrong = { "paper is made from metal" },
                 form = { "paper made from wood" } },
  },
}
