// Has no code of its own: it carries the precompiled headers that the libraries share.
