"""The material file (`.loom`): read, write, version."""
