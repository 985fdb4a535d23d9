"""Sheets of pictures that are to be looked at."""
