// CW3…: language.
