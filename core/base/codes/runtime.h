// CW5…: runtime.
