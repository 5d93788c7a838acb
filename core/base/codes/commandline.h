// CW8…: commandline.
