"""Multi-scale models of one fabric: a folder a model, independent of each other, behind one interface."""
