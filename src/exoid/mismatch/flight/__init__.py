"""What swings by itself between two strikes, and where a search for it begins."""
