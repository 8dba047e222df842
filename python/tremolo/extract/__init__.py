"""`tremolo extract`: tables of a run, as practice reads it."""
