-- What a pupil may ask about the kite that flies.

return function(L, kite)
  L:knows "wind" {
    asked = { "how strong is the wind", "how fast is the wind" },
    answer = function() return ("The wind at the kite blows with %.0f metres a second."):format(kite().wind) end,
  }

  L:knows "altitude" {
    asked = { "how high is (it|the kite)", "how high does (it|the kite) fly" },
    answer = function() return ("It is %.0f metres above the ground."):format(kite().altitude) end,
  }

  L:knows "line" {
    asked = { "how long is the line" },
    answer = function() return ("The line is %.0f metres long."):format(kite().line) end,
  }

  L:knows "kite_weight" {
    asked = { "how heavy is (it|the kite)", "how much does (it|the kite) weigh" },
    answer = function() return ("Kite and tail weigh %.1f newtons."):format(kite().weight) end,
  }

  L:knows "kite_made_of" {
    asked = { "what is (it|the kite) made of" },
    answer = function() return ("It is made of %s and %s."):format(kite().cloth, kite().spar) end,
  }
end
