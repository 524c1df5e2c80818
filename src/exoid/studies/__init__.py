"""Many recordings of many people: a data set, a run over it, what is asked of a study."""
