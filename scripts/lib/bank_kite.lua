--- Questions for revision on flying: the kite lesson's, asked again elsewhere. See `bank`.

local forces = { "lift", "drag", "weight|gravity", "tension|pull of the line" }

local kite = "(it|a kite|the kite)"

-- The first of each bracket's words, without what may be left out.
local function plainly(said) return (said:gsub("%s*%b[]", ""):gsub("%((.-)|.-%)", "%1")) end

-- "Which force …?", answered by "The lift holds it up." or "Lift holds it up."; `also` are other words for what is said. The bare {force}
-- takes "the" as well, but it is "the lift force".
local function which(id, right, prompt, said, verb, plain, hint, also, both)
  return {
    id = "kite_" .. id, like = { id == "tension" and "hand" or "up" }, point = "verb", idea = "flight",
    prompt = prompt,
    answers = { ("the {force} %s"):format(said), "the {force} [force] <of> <does>", "{force} <of> <does>", "it is the {force} [force] <of>", "it is {force} <of>",
                "it is (the {force}|{force}) (that|which) <does>", "the {force} [force] <of>", "{force} <of>",
                "I feel the {force} [force] <of> [in my hand]", "I feel {force} <of> [in my hand]", "(the {force}|{force}) is what (I|we) feel", "the force is (the {force}|{force})",
                "{source} [<does>]", "it is {source}" },
    nearly = { ("[the] {force} %s"):format((said:gsub(verb, plain))), ("{force} force %s"):format(said), "is [the] {force}" },
    lists = { force = forces, source = { "the Earth", "the wind" } },
    rules = { does = ("(%s|%s|does [(it|that)])"):format(said, also), of = right == "tension" and "[(of|in|from) the (line|string)]" or "[of the (kite|air)]" },
    -- What pulls and what pushes, for those who say it for its force.
    right = function(a)
      if a.source then return right == (a.source == "Earth" and "weight" or "drag") end
      return a.force == right
    end,
    hint = hint,
    solution = ("The %s %s."):format(right, plainly(said)),
    examples = {
      right = { ("the %s"):format(right), ("it is the %s"):format(right), ("%s %s"):format(right, plainly(said)), ("it is %s"):format(right),
                table.unpack(both or {}) },
      wrong = { right == "drag" and "the lift" or "the drag", right == "drag" and "lift" or "drag" },
      form = { ("the %s %s"):format(right, plainly(said:gsub(verb, plain))), ("is the %s"):format(right) },
    },
  }
end

-- "Which force is bigger: the lift or the weight?"
local function compared(adjectives, more)
  local first, comparative = ("<comparative:%s>"):format(adjectives[1]), {}
  for i, adjective in ipairs(adjectives) do comparative[i] = ("<comparative:%s>"):format(adjective) end
  local any = "(" .. table.concat(comparative, "|") .. ")"
  return {
    answers = { ("the {force} is %s [than the {other}]"):format(any), ("{force} is %s [than {other}]"):format(any),
                ("(the {force} [force]|{force}) is %s [than (the {other} [force]|{other})] [(then|now|there)]"):format(first), "it is (the {force} [force]|{force})",
                "(the {force} [force]|{force}) [is]", ("the %s (force|one) is (the {force}|{force})"):format(any),
                ("(the {force}|{force}) (must|has to|should) be %s [than (the {other}|{other})]"):format(any) },
    nearly = { ("{force} force [is %s]"):format(more), "is [the] {force}" },
    lists = { force = { "lift", "weight|gravity" }, other = { "lift", "weight|gravity" } },
    right = function(a) return a.force == "lift" and a.other ~= "lift" end,
  }
end

-- One question of two tables.
local function with(question, more)
  for field, value in pairs(more) do question[field] = value end
  return question
end

return {
  which("up", "lift", "Which force holds a kite up?", "holds " .. kite .. " up", "holds", "hold", "It points up, across the wind.",
    "(pushes|pulls|keeps|lifts) " .. kite .. " up|(holds|lifts) up (a|the) kite|carries " .. kite, { "lift pulls it up", "lift pushes it up" }),
  which("down", "weight", "Which force pulls a kite down?", "pulls " .. kite .. " down", "pulls", "pull", "Everything has it, on the ground too.",
    "pulls down (a|the) kite|brings " .. kite .. " down"),
  which("away", "drag", "Which force pushes a kite away with the wind?", "pushes " .. kite .. " away [with the wind]", "pushes", "push", "It points along the wind.",
    "(pulls|carries|moves|blows) " .. kite .. " away [with the wind]|pushes away (a|the) kite", { "drag pulls it away", "drag pushes it away" }),
  which("tension", "tension", "Which force of the line do you feel in your hand?", "pulls my hand", "pulls", "pull", "A line that is tight has it.",
    "pulls [on] my hand|pulls me"),
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
  with(compared({ "big", "great", "strong" }, "bigger"), {
    id = "kite_climbs", like = { "stronger", "why" }, point = "comparison", idea = "flight",
    prompt = "A kite stands high in the wind, and its line is tight. Which force is bigger: the lift or the weight?",
    hint = "The lift carries the weight, and pulls the line tight as well.",
    solution = "The lift is bigger than the weight.",
    examples = { right = { "the lift is bigger than the weight", "the lift", "the bigger force is the lift", "lift is bigger", "Lift is bigger than weight." },
                 wrong = { "the weight is bigger", "weight is bigger than lift" }, form = { "the lift is more big than the weight", "lift is more big" } },
  }),
  with(compared({ "small", "weak" }, "smaller"), {
    id = "kite_falls", like = { "why" }, point = "comparison", idea = "flight",
    prompt = "The wind stops, and the kite begins to fall. Which force is smaller then: the lift or the weight?",
    hint = "The weight stays the same, but lift needs wind.",
    solution = "The lift is smaller than the weight.",
    examples = { right = { "the lift is smaller than the weight", "the smaller one is the lift", "the lift is smaller then", "lift is smaller" },
                 wrong = { "the weight is smaller", "weight is smaller" }, form = { "the lift is more small than the weight", "lift is smaller then the weight" } },
  }),
  {
    id = "kite_wind", like = { "pull" }, point = "comparison", idea = "flight",
    prompt = "The wind gets stronger. Does the line pull more or less?",
    answers = { "(it|the line) pulls {amount} [than before]", "[much] {amount} [than before]", "it pulls {same}", "{same}", "the (pull|tension) is {size} [than before]" },
    nearly = { "(it|the line) pulls {size} [than before]", "(it|the line|line) (pull|is pull|pulling) {amount}" },
    lists = { amount = { "more|harder|more strongly", "less|more weakly" }, size = { "stronger|bigger|greater", "weaker|smaller" }, same = { "the same|the same as before|equally" } },
    right = function(a) return a.amount == "more" or a.size == "stronger" end,
    hint = "Remember the storm in your hand.",
    solution = "It pulls more.",
    examples = { right = { "it pulls more", "more" }, wrong = { "the line pulls less" }, form = { "it pull more" } },
  },
  {
    id = "kite_tail", like = { "change" }, point = "article", idea = "flight",
    prompt = "A kite turns and swings. What does it need?",
    answers = { kite .. " needs a {part}", "(I|you|we) (should|must|can|could|would) (give it|add|put on|use|tie on) a [(<comparative:long>|long)] {part}",
                "(give it|add|put on) a [(<comparative:long>|long)] {part}", kite .. " needs {other}", "{other}", kite .. " needs a {new}", "a {new}", kite .. " needs a <comparative:long> {part}", kite .. " needs a long {part}", "a {part}", "a <comparative:long> {part}", "a long {part}",
                kite .. " must have a [<comparative:long>] {part}", "its {part} must be <comparative:long>", "a {part} that is <comparative:long>", "{nothing}" },
    nearly = { "it (need|is need) [a] [longer] {part}", "it needs {part}", "{part}", "(needs|need) a [(longer|long)] {part}",
               "[(it|a kite|the kite) (needs|need)] [a] {part} [more] (long|longer)" },
    lists = { part = { "tail", "line|string", "knot", "wing" }, nothing = { "nothing" },
              other = { "more wind|stronger wind|wind", "less wind", "more cloth" }, new = { "bigger cloth", "lighter cloth" } },
    right = function(a) return a.part == "tail" end,
    hint = "It hangs at the end of a kite, and has bows on it.",
    solution = "It needs a longer tail.",
    examples = { right = { "it needs a tail", "it needs a longer tail" }, wrong = { "it needs a line", "more wind", "a bigger cloth" },
                 form = { "it need a tail", "it needs a more long tail", "it needs a the tail" } },
  },
  {
    id = "kite_cloth", like = { "change" }, point = "adjective", idea = "flight",
    prompt = "There is only a gentle wind. Should the cloth of a kite be light or heavy?",
    answers = { "(it|the cloth [of (a|the) kite]) (should|must) be {weight}", "(it|the cloth [of (a|the) kite]) (has to|needs to) be {weight}", "(it|that) (should|must) be a {cloth}", "{weight}", "not {other}", "a {weight} one", "a {cloth}", "(I|we) need a {cloth}" },
    nearly = { "(should|must|has to) be {weight}", "(it|cloth|the cloth) (should|must) {weight}", "(it|cloth|the cloth) (should|must) (is|to be) {weight}", "[the] {cloth}" },
    lists = { weight = { "light", "heavy" }, other = { "light", "heavy" }, cloth = { "light cloth", "heavy cloth" } },
    right = function(a) return a.weight == "light" or a.other == "heavy" or a.cloth == "light cloth" end,
    hint = "The lift must be bigger than the weight.",
    solution = "It should be light.",
    examples = { right = { "it should be light", "light", "a light one" }, wrong = { "it should be heavy" }, form = { "it should light", "it should be a light" } },
  },
  {
    id = "kite_higher", like = { "stronger" }, point = "comparison", idea = "flight",
    prompt = "Where is the wind stronger: near the ground or high above it?",
    answers = { "(it|the wind) blows <comparative:hard> {where}", "(it|the wind) is <comparative:strong> {high} above (the ground|it)", "(it|the wind) is <comparative:strong> {near} the ground",
                "{high} above (the ground|it)", "{near} the ground", "{high}", "(it|the wind) is <comparative:strong> {up}",
                "[{high}] in the {sky}", "above the {under}", "the {climb} the <comparative:strong>",
                "the {climb} ((you|we) (go|fly|climb|get|are)|it (goes|flies|climbs|gets|is)) the <comparative:strong> [(it|the wind) (is|gets)]", "on the {ground}", "(it|that) is {same}" },
    nearly = { "in [the] {high}", "{high} (in|on) the ground", "{up} is <comparative:strong>", "up {high} is <comparative:strong>" },
    lists = { high = { "high|higher|high up|higher up|far" }, near = { "near" }, up = { "high up|higher up|higher|up there" }, sky = { "sky|air" }, under = { "ground" },
              ground = { "ground" }, climb = { "higher", "lower" },
              where = { "near the ground", "high above the ground|high above it|high up" }, same = { "the same" } },
    right = function(a) return a.climb == "higher" or a.where == "high above the ground" or (a.high or a.up or a.sky or a.under) ~= nil end,
    hint = "Houses and trees slow the wind.",
    solution = "It is stronger high above the ground.",
    examples = { right = { "it is stronger high above the ground", "high above it", "the wind is stronger higher up" },
                 wrong = { "it is stronger near the ground" },
                 form = { "it is more strong high above the ground" } },
  },
}
