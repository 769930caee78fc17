"""Windows, films and sounds of the programs."""
