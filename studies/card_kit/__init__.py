"""What `python -m studies card` does: its jobs, their plan, what a machine has, what is carried."""
