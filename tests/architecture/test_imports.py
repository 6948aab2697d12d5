"""Imports form no cycle, those for type checking included."""

from graphlib import TopologicalSorter

import grimp


def test_no_import_cycle():
    graph = grimp.build_graph("quasidynamic", "fem", "flexbearing", exclude_type_checking_imports=False)
    imports = {module: graph.find_modules_directly_imported_by(module) for module in graph.modules}
    TopologicalSorter(imports).prepare()  # raises CycleError, which names the modules


def test_type_checking_imports_are_looked_at():
    graph = grimp.build_graph("flexbearing", exclude_type_checking_imports=False)
    assert graph.find_modules_directly_imported_by("flexbearing")
