"""What pages of the documentation site share: template, style, the script of live cloths, pictures."""
