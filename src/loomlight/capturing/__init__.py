"""A fabric file from a photograph of flat cloth."""
