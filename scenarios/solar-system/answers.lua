-- How each question about the planets may be answered, and what pupils say for it that is no good English.

local numbers = require "numbers"
local planets = require "planets"

local answers = {}

local how_many = numbers.words(0, 20)

answers.planets = {
  answers = {
    "there are {number} <plural:planet>", "[<there>] {number} <plural:planet> [<round>]",
    "{number} <plural:planet> (go|move|turn|are|travel) (round|around) (it|the Sun)", "{number} <plural:planet> (orbit|circle|revolve around) (it|the Sun)",
    "{number} <plural:planet> are (going|moving|travelling) (round|around) (it|the Sun)", "[<there>] {number} of them [go (round|around) (it|the Sun)]", "the number is {number}", "[there are] {number} [<plural:planet>] <names>",
  },
  nearly = {
    "(it|they|here|there|in solar system) (is|are|has|have) {number} [(planet|planets)]",
    "(is|are|have) {number} [(planet|planets)]", "in (the|our) solar system (is|are) {number} (planet|planets)",
    "{number} (planet|planets) (goes|going|is going|are go) [(round|around)] [(it|the Sun|Sun)]",
    "{number} (planet|planets) (orbits|is orbiting) [the] Sun",
  },
  rules = {
    names = "Mercury Venus [the] Earth Mars [Jupiter [Saturn [Uranus [and] [Neptune]]]]",
    there = "(there are|in (our|the) solar system there are|there must be|I see|I can (see|count)|I [have] (count|counted)|we have|we know|it has|(the Sun|(our|the) solar system) has [got])",
    round = "(in total|in (our|the) solar system|(round|around) (it|the Sun)|which (go|move|turn|are) (round|around) (it|the Sun)|which orbit (it|the Sun)"
      .. "|(going|moving) (round|around) (it|the Sun)|orbiting (it|the Sun))",
  },
  lists = { number = how_many },
}

-- Of one planet; `called` as in a sentence, "the Earth".
function answers.moons(name, called)
  local named = name == "Earth" and "[the] Earth" or name
  local it = "(it|" .. named .. "|(the|our|this) planet)"
  local has = name == "Earth" and "(we have|our Earth has)" or "we see"
  local own = name == "Earth" and "[(it|the Earth) has] the Moon" or "{number} <plural:moon> orbit (it|Mars)"
  return {
    answers = {
      called .. " has {number} <plural:moon>", it .. " has [got] {number} <moons>", "there are {number} <moons> [<round>]",
      "(I see|I can see) {number} <moons>", "{number} <moons>", it .. " (doesn't have|hasn't got) {none}", "there aren't {none}",
      "{number} <plural:moon> (go|move|turn) (round|around) " .. it, "{number} small ones",
      has .. " {number} <moons>", "there are {number} of them", own,
      it .. " has {many}", "there are {many}", "{many}",
    },
    nearly = {
      "(it|there|[the] " .. name .. ") [(is|are|has|have)] {number} [(moon|moons)]",
      "[it] (have|is|are) {number} [(moon|moons)]",
      "{number} (moon|moons) (has|have|is|are) [(it|[the] " .. name .. ")]", "{number} (moon|moons) (orbit|orbits) [the] " .. name,
    },
    rules = { moons = "(<plural:moon>|(small|little|tiny) <plural:moon>)", round = "(round|around) " .. it },
    lists = { number = how_many, none = { "any moons|any|a moon" }, many = { "many moons|lots of moons|many|a lot of moons|a lot" } },
  }
end

local asked_about = {}
for i, name in ipairs(planets.names) do asked_about[i] = name == "Earth" and "Earth|the Earth" or name end

answers.your_turn = {
  answers = {
    "how many moons does {planet} have",
    "how many <plural:moon> (does {planet} have|has {planet} got)",
    "how many moons are there around {planet}",
    "(tell me|I want to know) how many <plural:moon> {planet} has",
    "how {quality} is {planet}",
    "how {quality} is {planet} [away] from the Sun",
    "how {quality} is {planet} away",
    "what is the {distance} of {planet} from the Sun",
    "how long is [a|the] {time} on {planet}", "how long is one {time} on {planet}",
    "(tell me|I want to know) how {quality} {planet} is",
  },
  nearly = {
    "how (many|much) (moon|moons) {planet} [(has|have|got|has got|have got|does have|is have)]",
    "how (many|much) (moon|moons) (has|have|is have|is has|do) {planet} [(has|have)]",
    "how (many|much) (moon|moons) [there] (is|are) [(there|in|on|of)] {planet}",
    "how much (moon|moons) does {planet} (has|have)",
    "{planet} (has|have) how many (moon|moons)",
    "(what is|tell me) [the] number of moons of {planet}",
    "how {quality} {planet} [is] [from the Sun]",
    "how long {time} on {planet} [is]",
  },
  lists = { planet = asked_about, distance = { "distance" }, quality = { "big|large|wide", "far|far away", "heavy" },
            time = { "day", "year" } },
}

answers.side_or_pole = {
  answers = {
    "it turns more (at|near|on) the {place} [than (at|near|on) the {other}]", "it turns more {from} the (axis|pole)", "it is <at> [that it <turns> <more>]", "it is (<comparative:easy>|better) [to (push|turn) [it]] <at> [than (at|near|on) the {other}]",
    "<it> <turns> <more> [(when|if) (I|you|we) push [it]] <at>", "<it> <turns> <more> (when|if) (I|you|we) push the {place}",
    "(when|if) (I|you|we) push [it] <at>", "(when|if) (I|you|we) push the {place} [it <turns> <more>]", "(I|you|we) [can] (turn|move) it <more> <at>",
    "(it|the same push|a push|the push) turns [it] <more> <at>", "(pushing|a push|the push|the same push) <at> (turns|moves) <it> <more>", "pushing the {place} (turns|moves) <it> <more>",
    "(when|if) (I|you|we) push [it] <at> it (<turns> <more>|is <comparative:easy>)", "the torque is <comparative:{torque}> <at>", "it has more effect <at>",
    "[more] <at> [it <turns> <more>]", "<at> (it is <comparative:easy>|[where] the (arm|lever arm) is longer)", "(when|where) the (arm|lever arm) is {arm}",
    "the {place} [is (better|easier)]", "(I|you|we) [(must|should|can)] push [it] <at>", "let us push [it] <at>",
    -- The other one is meant.
    "<it> <turns> {less} [(when|if) (I|you|we) push [it]] <at>", "it is {harder} [to (push|turn) it] <at>", "it is {same}", "<it> <turns> {same}",
  },
  nearly = {
    "(it|Earth|planet) (turn|turning|is turning|is turn|turns) [(more|faster|better)] (at|near|on|in) [the] {place}",
    "[the] {place} (turn|turns|turning|is turn|is turning) [it] [(more|faster|better)]", "the {place} it (turn|turns) more", "it turn more (when|if) (I|you) (pushing|pushes) [(at|near)] [the] {place}",
    "[the] {place} [is] (more|most|more fast|more good|faster)",
    "push (at|near|on|in) [the] {place}", "(near|next|far) of the {place}", "it turns more (to|in|by) the {place}",
  },
  rules = {
    it = "(it|the Earth|the planet)", turns = "(turns|goes|moves|spins|rotates)", more = "[(much|a lot|far|even)] (more|faster|better|further|farther|more easily|more quickly)",
    at = "((at|near|on) the {place} [of (it|the Earth|the planet)]|{from} the (axis|pole))",
  },
  lists = {
    place = { "side|rim|equator|edge", "pole|north pole|top" }, other = { "side|rim|equator|edge", "pole|north pole|top" },
    from = { "far from|far away from|farther from|farther away from|further away from", "close to|closer to" }, arm = { "longer|long", "shorter|short" },
    torque = { "big", "great", "small" }, less = { "less|more slowly|slower" }, harder = { "harder|more difficult" },
    same = { "the same|the same at both places|the same everywhere" },
  },
  examples = { right = { "It turns more at the side than near the pole.", "It's easier at the side.", "It turns less near the pole.", "at the side it's easier", "it spins faster at the side" },
               wrong = { "it turns more at the pole than at the side", "it turns less at the side", "where the arm is shorter" } },
}

answers.harder = {
  answers = {
    "[the] {planet} is <comparative:hard> to turn [than [the] {other}]", "[the] {planet} is <comparative:hard> [than [the] {other}]", "[the] {planet} feels <comparative:hard> [to turn] [than [the] {other}]",
    "[the] {planet} is <comparative:difficult> [to turn] [than [the] {other}]", "[the] {planet} is the <comparative:hard> one [to turn]",
    "it is (<comparative:hard>|<comparative:difficult>) to turn [the] {planet} [than [the] {other}]", "the (<comparative:hard>|<comparative:difficult>) one [to turn] is [the] {planet}",
    "[the] {planet} turns (more slowly|slower) [than [the] {other}]", "turning [the] {planet} is (<comparative:hard>|<comparative:difficult>) [than turning [the] {other}]",
    "to turn [the] {planet} is (<comparative:hard>|<comparative:difficult>) [than [to turn] [the] {other}]",
    "[it is] [the] {planet}", "[the] {planet} is", "[the] {planet} (needs|takes) <more> [to turn] [than [the] {other}]",
    "(I|you|we) need <more> (to turn|for) [the] {planet} [than for [the] {other}]", "(I|you|we) [(must|have to)] push harder to turn [the] {planet}", "it (takes|needs) <more> to turn [the] {planet} [than [to turn] [the] {other}]",
    "(I|you|we) [(must|have to)] push [the] {planet} harder", "[the] {planet} is not as easy [to turn] [as [the] {other}]", "(they are|both are|it is) {same}", "{same}",
  },
  nearly = {
    "[the] {planet} is (hard|difficult) [to turn] [than [the] {other}]",
    "[the] {planet} (more|is more|is most|is the most|is the) (hard|difficult|hardest|harder) [to turn] [than [the] {other}]",
    "[the] {planet} is (harder|hard|more difficult|more hard) (for turn|for turning|turn|turning|to turning|for to turn|to turned) [than [the] {other}]",
    "[the] {planet} (turn|turns|turning) (more slow|slow|harder|more hard|hard) [than [the] {other}]",
  },
  rules = { more = "(more (force|strength|power)|a (bigger|stronger) force)" },
  lists = { planet = { "Earth", "Jupiter" }, other = { "Earth", "Jupiter" }, same = { "the same|equal|equally hard|neither" } },
  examples = { right = { "Jupiter is the harder one", "Jupiter needs more force", "turning Jupiter is harder", "Jupiter is harder to turn than the Earth" },
               wrong = { "the Earth needs more force", "turning the Earth is harder", "they are the same" }, form = { "Jupiter is more hard to turn", "Jupiter is harder for turn" } },
}

return answers
