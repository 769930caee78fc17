"""Windows and films of the programs, and what is heard."""
