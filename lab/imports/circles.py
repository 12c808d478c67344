"""Circles in a graph of imports."""


def circles(edges):
    """Groups of files that import one another in a circle, each with the imports between its files.

    `edges` holds an import a tuple: file, line, imported file.
    """
    graph = {}
    for file, _, imported in edges:
        graph.setdefault(file, set()).add(imported)
        graph.setdefault(imported, set())
    groups = [group for group in strong_components(graph) if len(group) > 1]
    return [sorted({edge for edge in edges if edge[0] in group and edge[2] in group}) for group in sorted(groups, key=min)]


def strong_components(graph):
    """Tarjan's algorithm, with a stack of its own instead of recursion."""
    index, low, path, on_path, components = {}, {}, [], set(), []

    def enter(node):
        index[node] = low[node] = len(index)
        path.append(node)
        on_path.add(node)
        return node, iter(sorted(graph[node]))

    for start in sorted(graph):
        work = [] if start in index else [enter(start)]
        while work:
            node, successors = work[-1]
            following = next(successors, None)
            if following is None:
                work.pop()
                if work:
                    caller = work[-1][0]
                    low[caller] = min(low[caller], low[node])
                if low[node] == index[node]:
                    component = set(path[path.index(node) :])
                    del path[path.index(node) :]
                    on_path -= component
                    components.append(component)
            elif following not in index:
                work.append(enter(following))
            elif following in on_path:
                low[node] = min(low[node], index[following])
    return components
