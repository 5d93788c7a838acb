// CW6…: fieldbus.
