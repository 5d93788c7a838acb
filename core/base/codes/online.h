// CW7…: online.
