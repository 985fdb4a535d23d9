"""How exact the models and their pictures are."""
