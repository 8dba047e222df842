"""Pictures of a run's model and frames."""
