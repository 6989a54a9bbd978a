-- What a pupil may ask about the kite that flies.

local know = require "know"

-- Below that nothing is felt or seen of a force, in newtons; the air may even press a kite down, and that is no lift.
local least = 0.05

local function counted(n, thing) return ("%.0f %s"):format(n, ("%.0f"):format(n) == "1" and thing or thing .. "s") end

return function(L, kite)
  local function knows(id, asked, nearly, examples, answer, lists)
    L:knows(id) { asked = asked, nearly = nearly, examples = examples, answer = answer, lists = lists }
  end

  -- What is told is what the hand gets; where the line is felt milder than it is, its own pull beside it.
  local function pull_at_hand(world)
    local felt, true_pull = world:tool().force, kite().pull
    if felt < least then return "The line does not pull now." end
    local told = ("The line pulls your hand with %.1f newtons"):format(felt)
    local is_milder = math.abs(true_pull - felt) > 0.1 * true_pull + 0.2
    return is_milder and ("%s, and on a real kite with %.1f."):format(told, true_pull) or told .. "."
  end

  knows("this",
    { "what is (this|that|it)", "what am I holding", "what do I have in my hand" }, {},
    { right = { "What is this?" }, other = { "what is it made of" } },
    function() return ("This is a kite on a line, a %s."):format(kite().shape) end)

  knows("wind",
    { "how strong is the wind", "how fast is the wind", "how fast does the wind blow" },
    { "how (strong|fast) (the wind|wind) [is]", "how (strong|fast) is wind" },
    { right = { "How strong is the wind?" }, form = { "how strong is wind" } },
    function()
      return kite().wind < 0.5 and "There is hardly any wind now." or ("The wind at the kite blows at %s a second."):format(counted(kite().wind, "metre"))
    end)

  knows("altitude",
    { "how high is (it|the kite)", "how high does (it|the kite) fly", "how high up is (it|the kite)" },
    { "how high (it|kite|the kite) (is|flies|fly)", "how high is kite" },
    { right = { "How high is the kite?" }, form = { "how high the kite is" } },
    function() return kite().altitude < 0.5 and "It is on the ground." or ("It is %s above the ground."):format(counted(kite().altitude, "metre")) end)

  knows("line",
    { "how long is the line", "how much line is out" },
    { "how long (the line|line) [is]", "how long is line" },
    { right = { "How long is the line?" }, form = { "how long the line is" } },
    function() return ("The line is %s long."):format(counted(kite().line, "metre")) end)

  knows("tail_length",
    { "how long is (the|its) tail", "how long is the tail of the kite" }, { "how long (the tail|its tail|tail) [is]", "how long is tail" },
    { right = { "How long is the tail?" }, form = { "how long the tail is" } },
    function() return kite().tail > 0 and ("Its tail is %.1f metres long."):format(kite().tail) or "It has no tail yet." end)

  knows("kite_weight",
    { "how heavy is (it|this|the kite)", "how much does (it|this|the kite) weigh", "what does the kite weigh" },
    { "how heavy (it|kite|the kite) [is]", "how heavy is kite" },
    { right = { "How heavy is it?", "how much does the kite weigh" }, form = { "how heavy the kite is" } },
    function() return ("Kite and tail weigh %.1f newtons."):format(kite().weight) end)

  knows("kite_made_of",
    { "what is (it|this|the kite) made of", "what are its sticks made of", "what is its cloth made of" },
    { "what is (it|this|kite|the kite) (make|made) (of|from|by)", "what (it|the kite) [is] made of" },
    { right = { "What is it made of?", "what is the kite made of" }, form = { "what is the kite make of" } },
    function() return ("It is made of %s and %s."):format(kite().cloth, kite().spar) end)

  knows("kite_is_made_of",
    { "is (it|this|the kite) made (of|from|out of) {stuff}" },
    { "is (it|this|kite|the kite) (make (of|from|by)|made by) {stuff}", "(it|the kite) is made (of|from|by) {stuff}" },
    { right = { "Is it made of paper?", "is the kite made of nylon" }, form = { "is the kite make of paper" } },
    function(a)
      if a.stuff == kite().cloth or a.stuff == kite().spar then return "Yes, it is." end
      return ("No, it is made of %s and %s."):format(kite().cloth, kite().spar)
    end,
    { stuff = { "nylon", "paper", "plastic", "silk", "tissue", "cellophane", "balsa", "birch", "wood", "metal", "cotton" } })

  knows("has_tail",
    { "does (it|the kite) have a tail", "has (it|the kite) got a tail" }, { "does (it|the kite) (has|have) tail", "(do|has) (it|the kite) (have|has) [a] tail" },
    { right = { "Does the kite have a tail?" }, form = { "does the kite has tail" } },
    function() return kite().tail > 0 and ("Yes, its tail is %.1f metres long."):format(kite().tail) or "No, it has no tail." end)

  knows("pull",
    { "how hard does (it|the kite|the line) pull", "how strong is the pull [of the (line|kite)]" },
    { "how (strong|hard) (it|the kite|the line) (pull|pulls)", "how strong does (it|the kite|the line) pull" },
    { right = { "How hard does the line pull?" }, form = { "how hard the kite pulls" } },
    function(_, world) return pull_at_hand(world) end)

  knows("holds",
    { "what holds (it|the kite) up", "which force holds (it|the kite) up", "why does (it|the kite) fly", "what keeps (it|the kite) up" },
    { "what (hold|is hold|is holding) (it|the kite) up", "why (it|the kite) (fly|flies)" },
    { right = { "what holds the kite up", "why does it fly" }, form = { "what hold it up" } },
    function() return kite().lift < least and "Nothing holds it up now: there is no lift." or "The lift holds it up: the force of the air." end)

  knows("force",
    { "how (big|strong|large|great) is [the] {force} [of the (kite|line)]", "how many newtons (is|has|does) [the] {force} [have]", "what is the size of the {force}",
      "how much {force} (is there|does (it|the kite) have)" },
    { "how (big|strong|large|much) (the {force}|{force}) [is]", "how many (newton|newtons) (the {force}|{force}) (is|has|have)" },
    { right = { "How big is the lift?", "how big is the drag", "how strong is the tension" }, form = { "how big lift is", "how strong the drag is" } },
    function(a, world)
      if a.force == "tension" then return pull_at_hand(world) end
      local newtons = kite()[a.force]
      if newtons >= least then return ("The %s is %.1f newtons."):format(a.force, newtons) end
      if a.force == "lift" then return "There is no lift now: the air does not hold it up." end
      return ("There is hardly any %s now."):format(a.force)
    end,
    { force = { "lift", "drag", "weight", "tension" } })

  know.words(L, { "arrow", "lift", "drag", "metre", "weight", "tension", "tie", "newton", "force", "weigh", "wheel", kite = "A kite is a light thing of cloth and sticks that flies on a line.",
    tail = "A tail is what hangs at the end of a kite and keeps it straight.", diamond = "A diamond is a square that stands on a corner.", knot = "A knot is where the line is tied to the kite." })
end
