// CW2…: family.
