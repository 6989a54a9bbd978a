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
-- "Hard, smooth and slippery."
local three = "<adjective:{feel}> [and] <adjective:{feel:also}> and <adjective:{feel:third}>"
local called = { "metal", "wood", "rock|stone", "rubber", "glass", "sandpaper" }
-- What a thing might be made of as well: understood, and wrong.
local guessed = { "metal", "wood", "rock|stone", "rubber", "glass", "plastic", "paper", "gold", "cloth" }
-- What else is true of them, and nobody can feel with an arm.
local also_true = {
  metal = { cold = true, shiny = true, grey = true, strong = true }, wood = { warm = true, brown = true, strong = true },
  rock = { cold = true, grey = true, bumpy = true, strong = true },
}

local function place_in(list, name)
  for i, each in ipairs(list) do
    if each == name then return i end
  end
end

-- "What is metal like?"
local function what_like(name, first, second, wrong, slip)
  local known = like[name]
  local own, others = {}, {}
  for _, words in ipairs(called) do table.insert(words:match "^%a+" == name and own or others, words) end
  return {
    id = "textures_like_" .. name, like = { "like_" .. name }, point = "adjective", idea = "materials",
    prompt = ("What is %s like?"):format(name),
    answers = { "{material} is <adjective:{feel}> [and <adjective:{feel:also}>]",
                "{material} (is|feels) <adjective:{feel}> [and <adjective:{feel:also}>]",
                "(it|this) feels <adjective:{feel}> [and <adjective:{feel:also}>]",
                "{material} (is|feels) <three>", "(it|this) (is|feels) <three>",
                "({material}|it) is a <adjective:{feel}> material", "{wrong} (is|feels) <adjective:{feel}> [and <adjective:{feel:also}>]",
                "({material}|it|this) can be <adjective:{feel}>", "({material}|it|this) (is|feels) <adjective:{extra}>",
                "({material}|it|this) (is|feels) <adjective:{extra}> and <adjective:{feel}>", "({material}|it|this) (is|feels) <adjective:{feel}> and <adjective:{extra}>",
                "[({material}|it) is] neither <adjective:{feel:not_one}> nor <adjective:{feel:not_other}>" },
    nearly = { "(it|{material}) has {feel}" },
    lists = { material = own, wrong = others, feel = adjectives, extra = { "cold", "warm", "shiny", "grey", "brown", "strong", "bumpy" } }, rules = { three = three },
    right = function(a)
      if a.wrong or a.extra and not also_true[name][a.extra] then return false end
      if a.not_one then return not known[a.not_one] and not known[a.not_other] end
      local said = {}
      for _, feel in pairs { a.feel, a.also or false, a.third or false } do
        if feel and (said[feel] or not known[feel]) then return false end
        if feel then said[feel] = true end
      end
      return true
    end,
    hint = "Is it hard or soft? Is it smooth or rough?",
    solution = ("%s is %s and %s."):format(name:gsub("^%l", string.upper), first, second),
    examples = {
      right = { ("%s is %s and %s"):format(name, first, second), "it is " .. first, first .. " and " .. second,
                table.unpack(known.slippery and { "metal is hard, smooth and slippery", "it is slippery, hard and smooth" } or {}) },
      wrong = { ("%s is %s"):format(name, wrong), ("%s is %s and %s"):format(name, first, first), ("%s is %s, %s and %s"):format(name, first, second, wrong),
                ("%s, %s and %s"):format(first, second, first) },
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
                "the <comparative:" .. adjective .. "> (one|material) is {material}",
                "{less_so} is less <adjective:" .. adjective .. ">" },
    lists = { material = { first, second }, other = { first, second }, less_so = { first, second } },
    right = function(a) return a.less_so == wrong or a.material == right and a.other ~= right end,
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
    answers = { "[a|an|the] {thing} <made_of:{material}>", "(it|[a|an|the] {thing}) is {wooden}", "the material is {material}",
                "(it|[a|the] {thing}) (must|could|might) be [made of] {material}", "(they|people|we) (make|made) (it|[a|the] {thing}) (of|out of|from) {material}",
                "(it|[a|the] {thing}) comes {source}", "{source}" },
    lists = { thing = { thing }, material = guessed, wooden = { "wooden" }, source = { "from a tree|from trees", "from the mountains|from a mountain" } },
    right = function(a) return (a.wooden and "wood" or a.source and (a.source == "from a tree" and "wood" or "rock") or a.material) == material end,
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
    answers = { "(paper|it) is made (from|of|out of) {material}", "[(from|of|out of)] {material}", "[made] (from|of|out of) {material}",
                "(paper|it) comes from {material}", "(we|they|people) make (it|paper) (from|out of) {material}" },
    nearly = { "(paper|it) [is] (made|make|makes) (of|by|from) {material}", "(paper|it) [are] (made|make) (of|by|from) {material}" },
    lists = { material = { "wood|trees", "metal", "rock|stone", "glass", "plastic" } },
    right = function(a) return a.material == "wood" end,
    hint = "It grows.",
    solution = "Paper is made from wood.",
    examples = { right = { "paper is made from wood", "from trees" }, wrong = { "paper is made from metal" },
                 form = { "paper made from wood" } },
  },
}
