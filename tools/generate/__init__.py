"""What is generated and kept: pictures of the documentation."""
