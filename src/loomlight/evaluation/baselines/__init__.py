"""Networks of other papers, trained beside the models of this package for comparisons; they need torch."""
