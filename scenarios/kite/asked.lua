-- What a pupil may ask about the kite that flies.

return function(L, kite)
  local function knows(id, asked, nearly, examples, answer)
    L:knows(id) { asked = asked, nearly = nearly, examples = examples, answer = answer }
  end

  knows("this",
    { "what is (this|that|it)", "what am I holding", "what do I have in my hand" }, {},
    { right = { "What is this?" }, other = { "what is it made of" } },
    function() return ("This is a kite on a line, a %s."):format(kite().shape) end)

  knows("wind",
    { "how strong is the wind", "how fast is the wind", "how fast does the wind blow" },
    { "how (strong|fast) (the wind|wind) [is]", "how (strong|fast) is wind" },
    { right = { "How strong is the wind?" }, form = { "how strong is wind" } },
    function() return ("The wind at the kite blows at %.0f metres a second."):format(kite().wind) end)

  knows("altitude",
    { "how high is (it|the kite)", "how high does (it|the kite) fly", "how high up is (it|the kite)" },
    { "how high (it|kite|the kite) (is|flies|fly)", "how high is kite" },
    { right = { "How high is the kite?" }, form = { "how high the kite is" } },
    function() return ("It is %.0f metres above the ground."):format(kite().altitude) end)

  knows("line",
    { "how long is the line", "how much line is out" },
    { "how long (the line|line) [is]", "how long is line" },
    { right = { "How long is the line?" }, form = { "how long the line is" } },
    function() return ("The line is %.0f metres long."):format(kite().line) end)

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

  knows("pull",
    { "how hard does (it|the kite|the line) pull", "how strong is the pull [of the (line|kite)]" },
    { "how (strong|hard) (it|the kite|the line) (pull|pulls)", "how strong does (it|the kite|the line) pull" },
    { right = { "How hard does the line pull?" }, form = { "how hard the kite pulls" } },
    function() return ("The line pulls with %.1f newtons."):format(kite().pull) end)

  knows("lift",
    { "how (big|strong|large) is the lift", "which force holds (it|the kite) up", "what holds (it|the kite) up" },
    { "how (big|strong|large) (lift|the lift) [is]", "what (hold|is hold|is holding) (it|the kite) up" },
    { right = { "How big is the lift?", "what holds the kite up" }, form = { "what hold it up" } },
    function() return ("The lift holds it up, with %.1f newtons."):format(kite().lift) end)
end
