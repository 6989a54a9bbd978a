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
    answers = { "it is <comparative:easy> {far} from the support", "it is <comparative:easy> {near} the support",
                "it is <comparative:easy> " .. press .. " {far} from (the support|it)", "it is <comparative:easy> " .. press .. " {near} (the support|it)",
                "it is <comparative:easy> " .. press .. " {away}", "{far} from (the support|it)", "{near} (the support|it)", "{far}", "{by}" },
    nearly = { "in the {far}", "in the {near}", "it is (easy|easier|more easy) {far}", "it is (easy|easier|more easy) {near}" },
    lists = { near = { "near|nearer|close to|closer to|next to" }, far = { "far|far away|farther|further away" },
              away = { "far away|farther away|further away" }, by = { "near|nearer|close|closer" } },
    right = function(a) return (a.far or a.away) ~= nil end,
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
                "at the {handle}", "near the {hinge}", "the {handle}", "the {hinge}" },
    nearly = { "(in|on|by) [the] {handle}", "(in|on|by) [the] {hinge}", "it is easier (in|on|by) [the] {handle}" },
    lists = { handle = { "handle" }, hinge = { "hinge" } },
    right = function(a) return a.handle ~= nil end,
    hint = "The hinge is the support of a door.",
    solution = "It is easier at the handle: the arm is longer.",
    examples = { right = { "it is easier at the handle", "at the handle" }, wrong = { "near the hinge" },
                 form = { "it is more easy at the handle", "in the handle" } },
  },
  {
    id = "lever_torque", like = { "near_far" }, point = "passive_voice", idea = "lever",
    prompt = "What is force times arm called?",
    answers = { "(it|force times arm) is called {name}", "(we|people) call it {name}", "[it is] {name}" },
    nearly = { "it [is] (call|calls|calling) [the] {name}", "it called [the] {name}" },
    lists = { name = { "torque|the torque|moment|the moment|turning force", "weight", "speed", "energy" } },
    right = function(a) return a.name == "torque" end,
    hint = "It is what turns a thing.",
    solution = "It is called torque.",
    examples = { right = { "it is called torque", "torque", "force times arm is called torque" }, wrong = { "it is called weight" }, form = { "it called torque" } },
  },
  {
    id = "lever_twice", like = { "which_way", "near_far" }, point = "comparison", idea = "lever",
    prompt = "You press a lever at a place farther from its support. Do you need more force or less force?",
    answers = { "(I|you|we) need {amount} force", "it needs {amount} force", "(I|you|we) need {amount}", "{amount} [force]", "{amount} force is needed" },
    nearly = { "(I|you|we) (needs|am need|needing) {amount} [force]", "need {amount} [force]" },
    lists = { amount = { "more", "less" } },
    right = function(a) return a.amount == "less" end,
    hint = "A longer arm, and force times arm stays the same.",
    solution = "You need less force.",
    examples = { right = { "I need less force", "less", "less force is needed" }, wrong = { "we need more force" }, form = { "I needs less force" } },
  },
  {
    id = "lever_which_way", like = { "which_way" }, point = "preposition", idea = "lever",
    prompt = "A stone is too heavy. Must the support go nearer to the stone or nearer to your hand?",
    answers = { "(it|the support) must (go|move|be) " .. nearer, nearer, "(it|the support) (goes|moves) " .. nearer },
    nearly = { "(it|support|the support) (must to go|must goes|go|have to go) [nearer] [to] [(the|my)] {goal}", "[the] {goal}" },
    lists = { goal = { "stone", "hand" } },
    right = function(a) return a.goal == "stone" end,
    hint = "A long arm for you, a short arm for the stone.",
    solution = "It must go nearer to the stone.",
    examples = { right = { "it must go nearer to the stone", "to the stone", "nearer the stone" }, wrong = { "nearer to my hand" },
                 form = { "it must to go nearer to the stone", "near the my stone", "nearer to the stones" } },
  },
  {
    id = "lever_seesaw", like = { "near_far", "which_way" }, point = "comparison", idea = "lever",
    prompt = "A heavy child and a light child are on a seesaw. Who must sit nearer to the middle?",
    answers = { "the {who} child must sit <comparative:near> to the middle", "the {who} (child|one) [must|does]", "the {who} child must sit nearer", "the {who} child must sit closer [to the middle]" },
    nearly = { "[the] {who} [child] (must to sit|sits|sit) [nearer] [to the middle]", "{who} child" },
    lists = { who = { "heavy|heavier", "light|lighter" } },
    right = function(a) return a.who == "heavy" end,
    hint = "A big force needs a short arm.",
    solution = "The heavy child must sit nearer to the middle.",
    examples = { right = { "the heavy child must sit nearer to the middle", "the heavy child" }, wrong = { "the light child must" },
                 form = { "heavy child must to sit nearer", "heavier child must sit nearer to the middle" } },
  },
  {
    id = "lever_archimedes", like = { "how_strong" }, point = "verb", idea = "lever",
    prompt = "Who said: Give me a place to stand, and I shall move the Earth?",
    answers = { "{who} said (it|that|this)", "{who} did", "[it was] {who}" },
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
