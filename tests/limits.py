"""How long a test waits for an event at most: what only a hang takes, on the slowest and busiest machine."""

HANG = 1200  # seconds
