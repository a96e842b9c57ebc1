"""Results of studies, opened by what they hold in a process of their own: listing, figures, plans."""
