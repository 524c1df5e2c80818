"""Files of frames, as loggers write them."""
