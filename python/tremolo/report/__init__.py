"""`tremolo report`: one HTML file a run, or of several runs side by side, that needs no network."""
