"""loomlight: from a weave draft to a picture you would believe."""
