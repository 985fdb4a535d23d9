"""Checks by hand: compilers of other makers, processor times of tests."""
