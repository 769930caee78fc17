"""The grader measured: what each rung of isolation stops, and how fast it is."""
