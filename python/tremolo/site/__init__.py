"""A site under several models side by side: what `tremolo column --models` writes, as tables and pictures."""
