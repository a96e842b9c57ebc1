"""Long work in processes of its own, with progress, that ends at once when it is cancelled."""
