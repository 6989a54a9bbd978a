-- What is told of a planet where it is seen from near, with its moons in it, and when it is first touched.

return {
  Mercury = {
    seen = "This is Mercury, the smallest planet. It is the first one from the Sun.",
    touched = "Mercury is hot on one side and very cold on the other.",
  },
  Venus = { seen = "This is Venus. It is the hottest planet.", touched = "Venus lies under thick clouds." },
  Earth = {
    seen = "This is the Earth. It turns once a day. It has MOONS.",
    touched = "The Earth is our planet. It turns round once a day.",
  },
  Mars = { seen = "This is Mars, the red planet. It has MOONS, and both are small.", touched = "Mars is red because of its rust." },
  Jupiter = {
    seen = "This is Jupiter. It is the biggest planet.",
    touched = "Jupiter is a ball of gas: only here can you touch it.",
  },
  Saturn = { seen = "This is Saturn. You can see its big rings.", touched = "Saturn's rings are made of ice and stones." },
  Uranus = { seen = "This is Uranus. It is blue, green and very cold.", touched = "Uranus turns lying on its side." },
  Neptune = {
    seen = "This is Neptune, the last planet. It is very far from the Sun.",
    touched = "Neptune is the last planet, and it has the strongest winds.",
  },
}
