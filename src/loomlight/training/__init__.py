"""One plain training loop: losses, checkpoints, resume."""
