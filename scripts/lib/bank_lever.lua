--- Questions for revision on levers and torque: the lever lesson's, asked again elsewhere. See `bank`.

local numbers = require "numbers"

local press = "[to press [(it|a lever|the lever)]]"
local nearer = "([(nearer|closer)] to|near|towards) (the|my|your) {goal}"

-- Newtons that balance a load when the arms are so long.
local function balances(load, load_arm, arm) return load * load_arm / arm end

-- "A stone weighs 10 newtons … How many newtons do you need?"
local function how_strong(id, load, load_arm, arm, prompt)
  local need = math.floor(balances(load, load_arm, arm) + 0.5)
  return {
    id = "lever_" .. id, like = { "how_strong" }, point = "noun_number", idea = "lever",
    prompt = prompt,
    answers = { "I need {number} (<plural:newton>|N)", "(I|you|we) [(must|have to|can)] (need|press with|push with|use) {number} [(<plural:newton>|N)]",
                "it is {number} (<plural:newton>|N)", "{number} (<plural:newton>|N) [(is|are) enough]" },
    nearly = { "(I|you|we) (must|am|is) need {number} [(newton|newtons)]", "need {number} [(newton|newtons)]" },
    lists = { number = numbers.words { 0, 1, 2, 3, 4, 5, 6, 8, 10, 20, 40, 50, 100 } },
    right = function(a) return numbers.value(a.number) == need end,
    hint = "Force times arm is the same on both sides.",
    solution = ("You need %s newtons."):format(numbers.word(need)),
    examples = {
      right = { ("I need %s newtons"):format(numbers.word(need)), ("%s newtons"):format(numbers.word(need)) },
      wrong = { "I need one hundred newtons" },
      form = { ("I need %s newton"):format(numbers.word(need)) },
    },
  }
end

return {
  {
    id = "lever_easier", like = { "near_far" }, point = "comparison", idea = "lever",
    prompt = "Where is it easier to press a lever: near the support or far from it?",
    answers = { "pressing is <comparative:easy> {where}", "it is <comparative:easy> {far} from the support", "it is <comparative:easy> {near} the support",
                "it is <comparative:easy> " .. press .. " {far} from (the support|it)", "it is <comparative:easy> " .. press .. " {near} (the support|it)",
                "it is <comparative:easy> " .. press .. " {away}", "{far} from (the support|it)", "{near} (the support|it)", "{far}", "{by}",
                "when (I am|you are) {far} from (the support|it)", "at the {tip} [of the lever]", "it is <comparative:easy> at the {tip} [of the lever]", "(it|that) is {same}",
                "(it is <comparative:easy>|it is) in the {between}", "in the {between}", "the <comparative:{how}> the <comparative:easy>" },
    nearly = { "(more {far}|{far}) is <comparative:easy>", "in the {far}", "in the {near}", "it is (easy|easier|more easy) {far}", "it is (easy|easier|more easy) {near}" },
    lists = { near = { "near|nearer|close to|closer to|next to" }, far = { "far|far away|farther|further away" },
              away = { "far away|farther away|further away" }, tip = { "end|tip" }, same = { "the same|the same everywhere|the same at both places" }, by = { "near|nearer|close|closer" }, between = { "middle" },
              where = { "far from the support", "near the support", "at the end", "in the middle" }, how = { "far", "long", "near", "close", "short" } },
    right = function(a)
      if a.where then return a.where == "far from the support" or a.where == "at the end" end
      return (a.far or a.away or a.tip) ~= nil or a.how == "far" or a.how == "long"
    end,
    hint = "A long arm helps.",
    solution = "It is easier far from the support.",
    examples = { right = { "it is easier far from the support", "far from it", "it is easier to press it far away" },
                 wrong = { "it is easier near the support", "near it", "closer" },
                 form = { "it is more easy far from the support", "it is easier far", "it is the easier far from it" } },
  },
  {
    id = "lever_door", like = { "near_far" }, point = "preposition", idea = "lever",
    prompt = "Where is it easier to push a door: at the handle or near the hinge?",
    answers = { "it is <comparative:easy> [to push [(it|a door|the door)]] at the {handle}",
                "it is <comparative:easy> [to push [(it|a door|the door)]] near the {hinge}",
                "at the {handle}", "near the {hinge}", "the {handle}", "the {hinge}", "(near|close to|by|at) the {handle}", "at the {hinge}",
                "at the {handle} it is <comparative:easy>", "[it is <comparative:easy> [to push [(it|a door|the door)]]] (far|far away|away) from the {far_hinge}", "(it|that) is {same}" },
    nearly = { "(in|on) [the] {handle}", "(in|on|by) [the] {hinge}", "it is easier (in|on|by) [the] {handle}", "(on|in|at) [the] {handle} is easier" },
    lists = { handle = { "handle" }, hinge = { "hinge" }, far_hinge = { "hinge" }, same = { "the same" } },
    right = function(a) return (a.handle or a.far_hinge) ~= nil end,
    hint = "The hinge is the support of a door.",
    solution = "It is easier at the handle: the arm is longer.",
    examples = { right = { "it is easier at the handle", "at the handle" }, wrong = { "near the hinge" },
                 form = { "it is more easy at the handle", "in the handle" } },
  },
  {
    id = "lever_torque", like = { "near_far" }, point = "passive_voice", idea = "lever",
    prompt = "What is force times arm called?",
    answers = { "(it|force times arm) is called {name}", "(we|people|you) call it {name}", "[(it|force times arm|that) is] {name}", "(its|the) name is {name}" },
    nearly = { "[its] name is the {name}", "it [is] (call|calls|calling) [the] {name}", "it called [the] {name}" },
    lists = { name = { "torque|the torque|moment|the moment|turning force", "weight", "speed", "energy", "lift", "drag", "gravity", "lever", "force", "work" } },
    right = function(a) return a.name == "torque" end,
    hint = "It is what turns a thing.",
    solution = "It is called torque.",
    examples = { right = { "it is called torque", "torque", "force times arm is called torque" }, wrong = { "it is called weight" }, form = { "it called torque" } },
  },
  {
    id = "lever_twice", like = { "which_way", "near_far" }, point = "comparison", idea = "lever",
    prompt = "You press a lever at a place farther from its support. Do you need more force or less force?",
    answers = { "(I|you|we) need {amount} force", "it needs {amount} force", "(I|you|we) need {amount} [than before]", "(I|you|we) need {amount} force than before", "{amount} [force] [than before]", "(I|you|we) need a {size} force", "[(I|you|we) need] the {same} [force]", "{amount} force is needed", "(I|you|we) do not need (as|so) {much} force", "not (as|so) {much} force" },
    nearly = { "(I|you|we) (needs|am need|needing) {amount} [force]", "need {amount} [force]", "needs {amount} force" },
    lists = { amount = { "more", "less" }, much = { "much" }, size = { "bigger|greater|larger|stronger", "smaller|weaker" }, same = { "same" } },
    right = function(a) return a.amount == "less" or a.size == "smaller" or a.much ~= nil end,
    hint = "A longer arm, and force times arm stays the same.",
    solution = "You need less force.",
    examples = { right = { "I need less force", "less", "less force is needed" }, wrong = { "we need more force" }, form = { "I needs less force" } },
  },
  {
    id = "lever_which_way", like = { "which_way" }, point = "preposition", idea = "lever",
    prompt = "A stone is too heavy. Must the support go nearer to the stone or nearer to your hand?",
    answers = { "(it|the support) must (go|move|be) " .. nearer, "(it|the support) (has to|should|needs to) (go|move|be) " .. nearer, nearer, "(it|the support) (goes|moves) " .. nearer, "(away|farther|further|farther away|further away) from (the|my|your) {away}",
                "not " .. nearer:gsub("{goal}", "{away}") },
    nearly = { "(more near|more close|near of|nearer of|nearer from) [to] (the|my|your) {goal}", "(it|support|the support) (must to go|must goes|go|have to go) [nearer] [to] [(the|my)] {goal}", "[the] {goal}" },
    lists = { goal = { "stone", "hand" }, away = { "stone", "hand" } },
    right = function(a) return a.goal == "stone" or a.away == "hand" end,
    hint = "A long arm for you, a short arm for the stone.",
    solution = "It must go nearer to the stone.",
    examples = { right = { "it must go nearer to the stone", "the support has to go nearer to the stone", "to the stone", "nearer the stone" }, wrong = { "nearer to my hand" },
                 form = { "it must to go nearer to the stone", "near the my stone", "nearer to the stones" } },
  },
  {
    id = "lever_seesaw", like = { "near_far", "which_way" }, point = "comparison", idea = "lever",
    prompt = "A heavy child and a light child are on a seesaw. Who must sit nearer to the middle?",
    answers = { "the {who} child must sit <comparative:near> to the middle",
                "the {who} (child|one) (must|has to|should|needs to) (sit|be) (<comparative:near>|<comparative:close>) to (the middle|the support|it)", "the {who} (child|one) [must|does]", "the {who} child must sit nearer", "it is the {who} (child|one)", "[it is] not the {other} (child|one)", "{both}", "the {who} child must sit closer [to the middle]",
                "the {outer} (child|one) (must|has to|should|needs to) (sit|be) (<comparative:far>|further|farther away|further away) from (the middle|the support|it)" },
    nearly = { "[the] {who} (child|one) must (sits|sitting|to sit) [(nearer|closer)] [to the middle]", "the child {who}", "[the] {who} [child] (must to sit|sits|sit) [nearer] [to the middle]", "{who} child" },
    lists = { who = { "heavy|heavier", "light|lighter" }, other = { "heavy|heavier", "light|lighter" }, outer = { "heavy|heavier", "light|lighter" }, both = { "both|both of them", "neither|neither of them" } },
    right = function(a) return a.who == "heavy" or a.other == "light" or a.outer == "light" end,
    hint = "A big force needs a short arm.",
    solution = "The heavy child must sit nearer to the middle.",
    examples = { right = { "the heavy child must sit nearer to the middle", "the heavy child", "the heavy child has to sit nearer to the middle",
                            "the heavier one should be closer to it" }, wrong = { "the light child must" },
                 form = { "heavy child must to sit nearer", "heavier child must sit nearer to the middle" } },
  },
  {
    id = "lever_archimedes", like = { "how_strong" }, point = "verb", idea = "lever",
    prompt = "Who said: Give me a place to stand, and I shall move the Earth?",
    answers = { "{who} said (it|that|this|so)", "{who} did", "[it was] {who}", "(that|this) was {who}", "a (Greek|Greek man|man) (called|named) {who}" },
    nearly = { "{who} (say|says|sayed|is say) (it|that|this)" },
    lists = { who = { "Archimedes", "Newton|Isaac Newton", "Galileo", "Einstein" } },
    right = function(a) return a.who == "Archimedes" end,
    hint = "He lived in Syracuse more than two thousand years ago.",
    solution = "Archimedes said it.",
    examples = { right = { "Archimedes said that", "Archimedes" }, wrong = { "Newton did" }, form = { "Archimedes say that" } },
  },
  how_strong("same", 4, 1, 1, "Both arms of a lever are equally long. The stone on it weighs four newtons. How many newtons do you need?"),
  how_strong("double", 10, 1, 2, "A stone weighs ten newtons. Your arm of the lever is twice as long as its arm. How many newtons do you need?"),
  how_strong("ten", 20, 1, 10, "A stone weighs twenty newtons. Your arm of the lever is ten times as long as its arm. How many newtons do you need?"),
  how_strong("short", 5, 4, 1, "A stone weighs five newtons. Its arm of the lever is four times as long as yours. How many newtons do you need?"),
}
