"""What every solver shares: a scene and its tables, and the stages of a step."""
