--- Questions for revision on flying: the kite lesson's, asked again elsewhere. See `bank`.

local forces = { "lift|lift force", "drag|drag force", "weight|gravity", "tension|tension force|pull of the line" }

local kite = "(it|a kite|the kite)"

-- The first of each bracket's words, without what may be left out.
local function plainly(said) return (said:gsub("%s*%b[]", ""):gsub("%((.-)|.-%)", "%1")) end

-- "Which force …?", answered by "The lift holds it up."
local function which(id, right, prompt, said, verb, plain, hint)
  return {
    id = "kite_" .. id, like = { id == "tension" and "hand" or "up" }, point = "article", idea = "flight",
    prompt = prompt,
    answers = { ("the {force} %s"):format(said), "it is the {force}", "the {force} [does]", "I feel the {force} [in my hand]" },
    nearly = { ("{force} (%s|%s)"):format(said, (said:gsub(verb, plain))), ("the {force} %s"):format((said:gsub(verb, plain))), "{force}", "it is {force}" },
    lists = { force = forces },
    right = function(a) return a.force == right end,
    hint = hint,
    solution = ("The %s %s."):format(right, plainly(said)),
    examples = {
      right = { ("the %s"):format(right), ("it is the %s"):format(right) },
      wrong = { right == "drag" and "the lift" or "the drag" },
      form = { ("it is %s"):format(right) },
    },
  }
end

return {
  which("up", "lift", "Which force holds a kite up?", "holds " .. kite .. " up", "holds", "hold", "It points up, across the wind."),
  which("down", "weight", "Which force pulls a kite down?", "pulls " .. kite .. " down", "pulls", "pull", "Everything has it, on the ground too."),
  which("away", "drag", "Which force pushes a kite away with the wind?", "pushes " .. kite .. " away [with the wind]", "pushes", "push", "It points along the wind."),
  which("tension", "tension", "Which force of the line do you feel in your hand?", "pulls my hand", "pulls", "pull", "A line that is tight has it."),
  {
    id = "kite_four", like = { "up", "hand" }, point = "noun_number", idea = "flight",
    prompt = "How many forces act on a kite in the wind?",
    answers = { ("there are {number} <plural:force> [on %s]"):format(kite), ("{number} <plural:force> [act on %s [in the wind]]"):format(kite),
                "it has {number} <plural:force>", "there are {number}" },
    nearly = { "(it|they|there) (is|are|have) {number} (force|forces)" },
    lists = { number = { "two|2", "three|3", "four|4", "five|5" } },
    right = function(a) return a.number == "four" end,
    hint = "Count them: lift, drag, weight and tension.",
    solution = "There are four forces.",
    examples = { right = { "there are four forces", "four" }, wrong = { "there are three forces" }, form = { "there are four force" } },
  },
  {
    id = "kite_climbs", like = { "stronger", "why" }, point = "comparison", idea = "flight",
    prompt = "A kite stands high in the wind, and its line is tight. Which force is bigger: the lift or the weight?",
    answers = { "the {force} is (<comparative:big>|<comparative:great>) [than the {other}]", "it is the {force}", "the {force} [is]",
                "the (<comparative:big>|<comparative:great>) (force|one) is the {force}" },
    nearly = { "{force} [is bigger]", "it is {force}" },
    lists = { force = { "lift|lift force", "weight|gravity" }, other = { "lift", "weight" } },
    right = function(a) return a.force == "lift" and a.other ~= "lift" end,
    hint = "The lift carries the weight, and pulls the line tight as well.",
    solution = "The lift is bigger than the weight.",
    examples = { right = { "the lift is bigger than the weight", "the lift", "the bigger force is the lift" }, wrong = { "the weight is bigger" },
                 form = { "the lift is more big than the weight" } },
  },
  {
    id = "kite_falls", like = { "why" }, point = "comparison", idea = "flight",
    prompt = "The wind stops, and the kite begins to fall. Which force is smaller then: the lift or the weight?",
    answers = { "the {force} is <comparative:small> [than the {other}]", "it is the {force}", "the {force} [is]",
                "the <comparative:small> (force|one) is the {force}" },
    nearly = { "{force} [is smaller]", "it is {force}" },
    lists = { force = { "lift|lift force", "weight|gravity" }, other = { "lift", "weight" } },
    right = function(a) return a.force == "lift" and a.other ~= "lift" end,
    hint = "The weight stays the same, but lift needs wind.",
    solution = "The lift is smaller than the weight.",
    examples = { right = { "the lift is smaller than the weight", "the smaller one is the lift" }, wrong = { "the weight is smaller" },
                 form = { "the lift is more small than the weight" } },
  },
  {
    id = "kite_wind", like = { "pull" }, point = "comparison", idea = "flight",
    prompt = "The wind gets stronger. Does the line pull more or less?",
    answers = { "(it|the line) pulls {amount} [than before]", "{amount}", "the (pull|tension) is {size} [than before]" },
    nearly = { "(it|the line) pulls {size} [than before]", "(it|the line|line) (pull|is pull|pulling) {amount}" },
    lists = { amount = { "more|harder|more strongly", "less|more weakly" }, size = { "stronger|bigger|greater", "weaker|smaller" } },
    right = function(a) return a.amount == "more" or a.size == "stronger" end,
    hint = "Remember the storm in your hand.",
    solution = "It pulls more.",
    examples = { right = { "it pulls more", "more" }, wrong = { "the line pulls less" }, form = { "it pull more" } },
  },
  {
    id = "kite_tail", like = { "change" }, point = "article", idea = "flight",
    prompt = "A kite turns and swings. What does it need?",
    answers = { kite .. " needs a {part}", kite .. " needs a <comparative:long> {part}", kite .. " needs a long {part}", "a {part}", "a <comparative:long> {part}", "a long {part}" },
    nearly = { "it (need|is need) [a] [longer] {part}", "it needs {part}", "{part}" },
    lists = { part = { "tail", "wheel", "window", "door" } },
    right = function(a) return a.part == "tail" end,
    hint = "It hangs at the end of a kite, and has bows on it.",
    solution = "It needs a longer tail.",
    examples = { right = { "it needs a tail", "it needs a longer tail" }, wrong = { "it needs a wheel" },
                 form = { "it need a tail", "it needs a more long tail", "it needs a the tail" } },
  },
  {
    id = "kite_cloth", like = { "change" }, point = "adjective", idea = "flight",
    prompt = "There is only a gentle wind. Should the cloth of a kite be light or heavy?",
    answers = { "(it|the cloth [of (a|the) kite]) (should|must) be {weight}", "{weight}", "a {weight} one", "a {cloth}", "(I|we) need a {cloth}" },
    nearly = { "(it|cloth|the cloth) (should|must) {weight}", "(it|cloth|the cloth) (should|must) (is|to be) {weight}", "[the] {cloth}" },
    lists = { weight = { "light", "heavy" }, cloth = { "light cloth", "heavy cloth" } },
    right = function(a) return a.weight == "light" or a.cloth == "light cloth" end,
    hint = "The lift must be bigger than the weight.",
    solution = "It should be light.",
    examples = { right = { "it should be light", "light", "a light one" }, wrong = { "it should be heavy" }, form = { "it should light", "it should be a light" } },
  },
  {
    id = "kite_higher", like = { "stronger" }, point = "comparison", idea = "flight",
    prompt = "Where is the wind stronger: near the ground or high above it?",
    answers = { "(it|the wind) is <comparative:strong> {high} above (the ground|it)", "(it|the wind) is <comparative:strong> {near} the ground",
                "{high} above (the ground|it)", "{near} the ground", "{high}", "(it|the wind) is <comparative:strong> {up}" },
    nearly = { "in [the] {high}", "{high} (in|on) the ground" },
    lists = { high = { "high|higher|high up|higher up" }, near = { "near" }, up = { "high up|higher up|higher|up there" } },
    right = function(a) return (a.high or a.up) ~= nil end,
    hint = "Houses and trees slow the wind.",
    solution = "It is stronger high above the ground.",
    examples = { right = { "it is stronger high above the ground", "high above it", "the wind is stronger higher up" },
                 wrong = { "it is stronger near the ground" },
                 form = { "it is more strong high above the ground" } },
  },
}
