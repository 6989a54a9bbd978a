-- What is told of a planet when it is first touched.

return {
  Mercury = "Mercury is hot on one side and very cold on the other.",
  Venus = "Venus lies under thick clouds.",
  Earth = "The Earth is our planet. It turns round once a day.",
  Mars = "Mars is red because of its rust.",
  Jupiter = "Jupiter is a ball of gas: only here can you touch it.",
  Saturn = "Saturn's rings are made of ice and stones.",
  Uranus = "Uranus turns lying on its side.",
  Neptune = "Neptune is the farthest planet, and the windiest.",
}
