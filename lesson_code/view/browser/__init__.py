"""What a notebook or a page shows and answers with."""
