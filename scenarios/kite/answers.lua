-- How each question of the kite may be answered, and what pupils say for it that is no good English.

local answers = {}

answers.change = {
  answers = {
    "[<who>] make the tail <bit> {size} <why>", "(I|we) (need|want) a {tail_size} tail <on>", "<it> needs a {tail_size} tail <why>", "<it> needs a {missing} <why>",
    "(I|we) (need|want) a {missing} <on>", "<it> (must|should|has to|could) have a {tail_size} tail",
    "<it> (must|should|has to|could) have a {missing}", "<it> has no {missing}", "<it> is missing a {missing}", "there is no {missing}", "<it> does not have a {missing}",
    "the tail (must|should|has to|could) be <bit> {size} [than (that|this)]", "[<who>] (move|push|put|tie|fix) the knot <bit> {way}", "the knot (must|should|has to|could) (be|go) <bit> {way}",
    "[<who>] make the cloth <bit> {weight} <why>", "(the cloth|it|the kite) (must|should|has to|could) be <bit> {weight}", "<it> needs a {weight} cloth",
    "(I|we) (need|want|would like) a {weight} cloth", "[<who>] (use|take|try) a {weight} cloth",
    "(I|we) (want|need|would like) the tail to be {wish}", "(I|we) (want|need|would like) a tail that is {size}", "[<who>] (use|take|try) {cloth} [for the cloth]", "[<who>] make (it|the cloth) (of|out of|from) {cloth}",
    "[<who>] <give> a {tail_size} tail <on>", "[<who>] <give> a {missing} <on>", "[(how|what) about] a {tail_size} tail", "[(how|what) about] a {weight} cloth",
    "[(how|what) about] a {missing}", "<it> (would|will) fly better with a {missing}", "<it> (would|will) fly better with a {tail_size} tail",
    "[<who>] change the {part}", "the {part}", "the tail is <too> {tail_fault}", "the cloth is <too> {cloth_fault}", "the knot is <too> {knot_fault}",
    "[<who>] lengthen the {lengthened}", "[<who>] (raise|lift) the {raised}", "[<who>] lower the {lowered}",
    -- Understood, and nothing that can be done here.
    "<it> needs {other}", "(I|we) (need|want) {other}", "[<who>] (use|try) {other}", "the (line|string) (must|should|has to) be {line}",
    "[<who>] make the (line|string) {line}", "[<who>] change {other}",
  },
  nearly = {
    "make tail {size}", "tail {size}", "more {tail_size} tail", "{tail_size} tail", "{missing}", "the {missing}",
    "<it> (miss|misses|wish|wishes|lack|lacks) [(a|the|its)] {missing}", "<it> (miss|misses|wish|wishes) [a] {tail_size} tail",
    "<it> (no have|not have|must has) [a] {missing}", "need [a] {missing}", "needs [a] {missing}", "add {missing}", "put {missing} <on>", "tail must be {size}",
    "(I|we) must to (add|make|use) [a] {missing}", "knot {way}", "{weight} cloth", "make cloth {weight}", "[let us] making the tail {size}",
    "[<who>] make the tail more {size}", "<it> (need|needs) [a] more {tail_size} tail", "the tail (must|should|has to) be more {size}",
    "let us to (make|add|give it) a {missing}", "(I|we) want that the tail (is|be|gets|becomes) [more] {wish}", "(I|we) (want|need) [a] tail [more] {tail_size}", "I want make the tail {size}",
    "(should|must) be {weight}", "I want to change {part}",
  },
  rules = {
    who = "((I|we|you) [(must|should|can|could|have to|need to|want to|would|will)]|let us|let me|(I|we) would like to|(can|could|shall) (I|we)|try to)",
    it = "(it|the kite)", give = "(add|give it|give the kite|put on|put|make|use|try|attach|tie|fix)", on = "[(on|to|for) (it|the kite|my kite)]",
    why = "[(to make (it|the kite) (fly|steady)|to (fly|stay steady))]", bit = "[(a bit|a little)]", too = "[much] too",
  },
  lists = {
    size = { "longer|long|bigger", "shorter|short|smaller" }, tail_size = { "longer|long|bigger", "shorter|short|smaller" },
    missing = { "tail|kite tail" }, part = { "knot", "cloth" },
    way = { "up|higher|further up", "down|lower|further down" }, weight = { "lighter|light", "heavier|heavy" }, cloth = { "silk", "paper", "plastic", "nylon" },
    tail_fault = { "short|small", "long|big" }, cloth_fault = { "heavy", "light" }, knot_fault = { "low", "high" }, lengthened = { "tail" }, raised = { "knot" }, lowered = { "knot" },
    other = { "more wind|stronger wind|wind", "wings", "more line|more string", "the line|the string", "the colour" }, line = { "longer", "shorter" },
    wish = { "longer|long|bigger", "shorter|short|smaller" },
  },
}

-- What is to be changed, said in one of these ways: the part, and what it is to be.
local faults = { short = "longer", long = "shorter", heavy = "lighter", light = "heavier", low = "up", high = "down" }
function answers.wanted(a)
  local tail = a.size or a.wish or a.tail_size or faults[a.tail_fault] or a.lengthened and "longer"
  if a.part then return a.part end
  if tail or a.missing then return "tail", tail or "longer" end
  local way, weight = a.way or faults[a.knot_fault] or a.raised and "up" or a.lowered and "down", a.weight or faults[a.cloth_fault]
  if way then return "knot", way end
  if weight or a.cloth then return "cloth", a.cloth or weight == "lighter" and "silk" or "paper" end
end

-- A force has "the" or none: "the lift holds it up", "lift holds it up". The bare {force} takes both, but "the {force}" says it back with
-- "the", and "lift force" needs it.
answers.up = {
  answers = {
    "the {force} holds (it|the kite) up", "the {force} [force] <of> <does>", "{force} <of> <does>", "it is the {force} [force] <of>", "it is {force} <of>",
    "the {force} [force] <of>", "{force} <of>", "it is (the {force} [force]|{force}) (that|which) <holds_it>", "(it|the kite) is (held|kept|pulled|pushed|carried|lifted) <up> by {force}",
    "the force (that|which) <holds_it> is [called] {force}", "(it|the force|the upward force|this force|that) is called {force}",
    "the (upward force|force) is (the {force}|{force})", "the force called {force}", "[it is] the force of {force}",
    -- Understood, and wrong.
    "the {force} <holds> (it|the kite) {down}", "the {no_force} [<does>]", "it is (the {no_force}|{no_force}) [(that|which) <holds_it>]",
  },
  nearly = {
    "[the] {force} (hold|holds|is hold|holding|keep|lift) [(it|the kite)] up", "[the] {force} (pull|push) [(it|the kite)] up", "[the] {force} (hold|holds|lift|lifts) up it",
    "[the] {force} it (hold|holds) [(it|the kite)] [up]", "(it is|is) [the] {force} (who|what|that) (hold|holds) (it|the kite) up",
    "[the] {force} (hold|holds) he up", "is [the] {force}",
  },
  rules = {
    of = "[(of|in|from) the (line|string|rope|kite|air)]", holds = "(holds|pulls|pushes|keeps|carries)", up = "(up [in the (air|sky)]|in the (air|sky))",
    holds_it = "(<holds> (it|the kite) <up>|<holds> up the kite|(lifts|carries|holds) (it|the kite))",
    does = "(<holds_it>|lifts (it|the kite) up|lifts up the kite|is (holding|pulling|pushing|keeping|carrying|lifting) (it|the kite) <up>|makes (it|the kite) fly|does [(it|that)]"
      .. "|is what <holds_it>|is the force (that|which) <holds_it>)",
  },
  lists = { force = { "lift", "drag", "weight|gravity", "tension" }, down = { "down" }, no_force = { "wind", "the line|the string" } },
  examples = { right = { "The lift pulls it up.", "The lift pushes it up.", "It's the lift that holds the kite up.", "It is held up by the lift.", "the lift is holding it up",
                         "Lift holds the kite up.", "The lift holds up the kite.", "It's lift that holds it up.", "lift does" },
               wrong = { "It's the drag that holds it up.", "It is held up by its weight.", "the lift pulls it down", "the wind", "drag holds it up" },
               form = { "the lift hold it up", "lift hold it up", "lift force holds it up", "is the lift", "a lift holds it up", "it is a lift" } },
}

answers.hand = {
  answers = {
    "(I|we) [can] feel the {force} <of> <there>", "(I|we) [(can|could)] (feel|felt) the {force} [force] <of> <there>", "(I|we) [(can|could)] (feel|felt) {force} <of> <there>",
    "it is the {force} [force] <of> [that (I|we) [can] feel]", "it is {force} <of> [that (I|we) [can] feel]", "the {force} [force] <of> <there>", "{force} <of> <there>",
    "my hand (feels|felt) (the {force} [force]|{force}) <of>", "(I am|we are) feeling (the {force} [force]|{force}) <of>", "(it is|that is) called {force}",
    "the force [(that|which)] (I|we) [can] feel is (the {force}|{force}) <of>", "(the {force}|{force}) is [(the force that|what)] (I|we) [can] feel", "(I|we) [can] feel (the line pulling|how the line pulls)",
    "(the (line|string)|it) (pulls|is pulling) [on] (my|our) (hand|hands)",
    -- Understood, and wrong.
    "(I|we) [can] feel (the {no_force}|{no_force})", "[it is] the {no_force}",
  },
  nearly = {
    "(I|we) (am feel|feels|feeling) [the] {force} <of>", "is the {force}", "it (feel|feels) the {force}", "(I|we) can to feel [the] {force} <of>", "(I|we) [can] feel [the] {force} (of|in|from) (line|string)",
    "feel [the] {force} <of>", "{force} (of|in|from) (line|string)",
  },
  rules = { of = "[(of|in|from) (the|my) (line|string|rope|kite)]", there = "[(in|with) (my|our) (hand|hands)]" },
  lists = {
    force = { "lift", "drag", "weight|gravity", "tension|pull|force of the line" }, no_force = { "wind" },
  },
  examples = { right = { "I feel tension.", "I feel the tension", "tension", "The line pulls my hand.", "the line is pulling my hand", "I felt the tension" },
               wrong = { "I feel lift", "the wind", "it is the drag" }, form = { "feel the tension", "I feel tension of line", "I feel tension force", "I feel a tension" } },
}

answers.stronger = {
  answers = {
    "the {force} is <comparative:strong> [than the {other}]", "{force} is <comparative:strong> [than {other}]", "the {force} [force] is (<comparative:strong>|<bigger>) [than (the {other} [force]|{other})]",
    "{force} is <bigger> [than {other}]",
    "it is the {force}", "it is {force}", "the {force} [force]", "(the {force}|{force}) is [the] <comparative:strong>", "(the {force}|{force}) is the (<comparative:strong>|<bigger>) (force|one)",
    "the (<comparative:strong>|<bigger>) (force|one) is (the {force}|{force})", "(the {force}|{force}) has more newtons [than (the {other}|{other})]",
    "there is more {force} than {other}", "(they|both|the two forces) are {same}",
  },
  nearly = { "[the] {force} (are|be) <comparative:strong>", "is [the] {force}" },
  rules = { bigger = "(<comparative:big>|<comparative:great>|<comparative:large>|<comparative:high>|<comparative:powerful>)" },
  lists = { force = { "lift", "drag" }, other = { "lift", "drag" },
            same = { "the same|equal|equally strong|as strong" } },
}

answers.pull = {
  answers = {
    "(it|the line) pulls {amount} <than>", "<it> pulls <me> <much> {amount} <than>", "<it> does pull <me> <much> {amount} <than>",
    "(I|we) [can] feel (it|the line|the pull) <much> {amount} <than>", "<it> is pulling <me> <much> {amount} <than>",
    "<it> pulls <me> with ({with}|a {stronger} (force|pull)) <than>", "(I|we) [can] feel ({with}|a {stronger} (force|pull)) <than>",
    "(it|the pull|the tension|the force) (is|gets|got|becomes|became) (<comparative:strong>|<comparative:hard>) <than>", "(it|the pull|the tension|the force) (is|gets|got) <much> {size} <than>",
    "<comparative:strong> <than>", "<much> {size} <than>", "<much> {amount} <than>",
    "<it> pulls {same}", "(it|the pull|the line) is {same}", "<it> does not pull {amount:denied}", "not {amount:denied}", "there is no {difference}", "{same}",
  },
  nearly = {
    "(it|the line|they) (pull|is pull|pulling|is pulls) <much> {amount} <than>", "(it|the line|they) (pull|pulls|is pull) {size}",
    "(it|the line|they) (pull|pulls|is pull|is pulling|does pulls) <me> <much> {stronger} <than>", "(it|the line|they) (pull|pulls|is pull|is pulling) <me> <much> {amount} (strong|hard) <than>", "(it|the line) {amount} pulls",
    "(it|the pull|the tension) is {amount} [than before]", "(pulls|pull|is pulling) <much> {amount} <than>", "(it|the line) does pulls <much> {amount} <than>",
  },
  rules = { it = "(it|the line|the kite)", me = "[(me|my hand|on my hand)] [up]", than = "[(than before|than in the breeze|than without the wind)] [(when|if|as) the wind (is|gets) stronger]", much = "[(much|a lot|a bit|a little|even|far)]" },
  lists = {
    amount = { "more|harder|more strongly", "less|more weakly" }, size = { "bigger|greater|larger|higher", "weaker|smaller" },
    with = { "more force|more pull", "less force|less pull" }, stronger = { "bigger|stronger", "smaller|weaker" },
    same = { "the same|as before|as much as before|just as much|just as hard|equally hard" }, difference = { "difference" },
  },
  examples = { right = { "it pulls a lot more now", "it pulls harder", "it's pulling more", "it pulls with a bigger force" }, wrong = { "it pulls much less now", "it pulls the same" },
               form = { "it pulls stronger", "it pulls more hard" } },
}

answers.why = {
  answers = {
    "[<because>] [the force of] the {force} is <comparative:{size}> than the {other} <so>", "[<because>] [the force of] the {force} (was|got|became) <comparative:{size}> than the {other} <so>",
    "[<because>] the {force} (is|was) {amount} than the {other} <so>", "[<because>] {force} (is|was) <comparative:{size}> than {other} <so>",
    "[<because>] there (is|was) no {nothing}", "[<because>] there (is|was) no {nothing} <so>", "[<because>] it (is|was) too {burden} [for the (lift|wind|air)]", "[<because>] the wind (is|was) not {enough} enough <to>",
    "[<because>] there (isn't|is not|wasn't|was not) (any|enough) {nothing} <so>", "[<because>] (it|the kite) (has|had) no {nothing} <so>", "[<because>] we (have|had) no {nothing} <so>",
    "[<because>] (it|the kite) (doesn't|didn't) (have|get) [(any|enough)] {nothing} <so>", "[<because>] the {nothing} (is|was|got|became) too (weak|small|little|low|slow) <to>",
    "[<because>] without {nothing} (it|the kite) (can't|cannot|doesn't|couldn't) (fly|stay up)", "[[because] there (is|was)] (no|not enough|too little|no more) {nothing} <to> <so>",
    "[<because>] the wind {gone} [(any more|any longer)] <so>", "[<because>] (it|the kite) lost its {nothing}", "[<because>] (nothing|no force) (holds|held|is holding|pushes) (it|the kite) up [any more]", "[<because>] the {nothing} (is|was) gone",
    "[<because>] (there is|there was) no {nothing} [any more] (<to>|(pushing|holding|lifting) (it|the kite) up)", "[<because>] there (isn't|wasn't) enough {nothing} <to>",
    "[(because|as)] without {nothing} (there (is|was)|(it|the kite) (has|had)) no {nothing:lift}", "[because] there (is no|is not any|was no) {nothing:lift} without {nothing}", "[<because>] there (is|was) {amount} {force} than {other}", "[because] it (has|had) no {nothing:lift} without {nothing}",
    "[<because>] (it|the kite) needs {nothing} to (fly|stay up)", "[it came down] (because of|due to) [the] {pull}", "{pull}",
    "[it came down] (because of|due to) (the lack of|too little|the missing) {nothing}", "[<because>] [the] {pull} (pulls|pulled|is pulling) ((it|the kite) down|down the kite)",
    "[<because>] the {nothing} (doesn't|does not|didn't|can't|couldn't|could not) (hold|keep|carry|lift|push) (it|the kite) up [(any more|any longer)]",
    "[<because>] (it|the kite) (is|was) (heavier|stronger) than the lift", "[<because>] [the] {pull} (wins|won)",
    -- Understood, and wrong: unless it is less wind.
    "[<because>] (the|its) {part} (is|was) too {much}", "[<because>] (the|its) {part} (is|was|got) <comparative:{size}> [than before]",
    "[<because>] the wind (is|was) too {much}", "[<because>] the wind (is|was|got|became) <comparative:{size}> [than before]",
    "[<because>] there (is|was) too much {nothing:plenty}", "[<because>] there (is|was) [(enough|a lot of|still)] {nothing:plenty}", "[<because>] the wind (did not stop|has not stopped|is {blowing})",
    "[<because>] (it|the kite) (has|had) no {body}", "[<because>] (it|the kite) (has|had) a {body}", "[<because>] (I|you|we) (pulled|pull) [(it|the line)] too {much}", "because of (the|its) {blame}", "[<because>] the {part} (broke|is broken|was broken)",
  },
  nearly = {
    "[because] (have|has|is|not|no have|not have|no has|is not) [no] [the] {nothing}", "[because] it (no|not) (have|has) [the] {nothing}", "[because] the {force} <comparative:{size}> than the {other}", "because (no|not enough) {nothing}",
    "[because] there (is|was) not {nothing}", "[because] (it|the kite) (don't|doesn't|didn't) (has|had|have) [(any|enough)] {nothing}",
    "[because] [the] {nothing} (stop|is stop|is stopped|stopping|it stopped)", "[because] [the] {nothing} (is not enough|are not enough)", "[because] wind {gone}", "[because] there (isn't|is not|wasn't) no {nothing}",
    "[because] there are no {nothing}", "because [of] {nothing}", "because of (no|not enough) {nothing}", "[because] (it|the kite) (has not|have not|had not) [(any|enough)] {nothing}", "[because] [the] {force} is {amount} (big|strong) than [the] {other}",
  },
  rules = {
    because = "(because|as|since|it is because|it (came down|fell) because)", to = "[to (hold|lift|push|keep|carry|fly) (it|the kite) [up]]",
    so = "[(and|so) [so] (there (is|was) no [more] lift|it (fell|came) down)]",
  },
  lists = {
    force = { "lift|lift force", "weight|gravity" }, other = { "lift|lift force", "weight|gravity" }, size = { "small", "big", "weak", "strong", "great" },
    amount = { "less", "more" }, nothing = { "wind|air", "lift" },
    gone = { "stopped|has stopped|stopped blowing|has stopped blowing", "does not blow|is not blowing|died down|ended|went away" }, 
    pull = { "gravity|weight" }, part = { "line|string", "tail", "cloth", "drag", "tension", "lift", "weight|gravity", "kite" }, burden = { "heavy", "light", "big", "small", "slow" }, enough = { "strong|fast|big" }, blame = { "line|string", "tail", "drag", "tension", "lift" },
    much = { "strong|fast|hard|big|high", "long", "heavy", "short|small" }, blowing = { "blowing" }, body = { "tail", "line", "hole" },
  },
  examples = { right = { "not enough wind", "because of gravity", "there isn't enough wind", "it fell because there was no wind", "because the wind stopped", "there was no lift", "because the kite is too heavy",
                         "because it is too heavy for the lift", "Because the weight was stronger.", "because the wind wasn't strong enough" },
               wrong = { "because the lift is bigger than the weight", "because there is too much wind", "because the tail is too long" },
               form = { "because there is no the wind", "because wind stopped", "because there isn't no wind" } },
}

return answers
