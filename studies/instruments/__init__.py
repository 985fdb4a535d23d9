"""What studies measure with: times, machines, processes, references, held-out fabrics, sheets."""
