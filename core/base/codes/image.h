// CW4…: image.
