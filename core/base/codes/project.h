// CW1…: project.
