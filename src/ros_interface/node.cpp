// Node.
