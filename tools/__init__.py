"""What keeps the project: fuzzers and makers of shipped files; each module is a script."""
