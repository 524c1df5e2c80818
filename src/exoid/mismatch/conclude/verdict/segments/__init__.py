"""What of a mismatch is not alike in all segments."""
