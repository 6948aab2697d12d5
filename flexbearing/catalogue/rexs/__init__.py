"""Cases from models of REXS, the exchange format of gearbox programs."""

from flexbearing.catalogue.rexs.cases import Order, case_file, cases

__all__ = ["Order", "case_file", "cases"]
