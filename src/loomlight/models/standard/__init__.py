"""Textured standard materials as a model: bought ones beside cloth, in one scene."""
