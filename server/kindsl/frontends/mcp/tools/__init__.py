"""Has one module a tool; nothing else names them."""
