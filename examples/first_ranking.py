"""A first ranking: where does a strain film see its own contact depth best, and how sure is that?

Starts a service of its own on `tire.db`, runs the shipped study of five contact depths with a wall of 2.5 mm, not 3,
and writes the ranking, a map and the solved points. Run again, it finds the points in the database and solves nothing.
"""

import strainsite

# The coarse mesh knows its own error; a "draft" is faster and doesn't, "standard" is what to publish.
CHANGES = {
    "scene.geometry.wall_mm": 2.5,
    "accuracy.preset": "coarse",
    "layouts.films": [6, 12, 24],
    "layouts.depths_mm": [1.0],
}

with strainsite.local("tire.db") as client:
    expected = client.estimate("foot-tire", set=CHANGES)
    seconds = f"{expected.wall_s.expected:.1f} s" if expected.wall_s else "an unknown time"
    print(f"{expected.solves.left.expected} solves to go, {seconds} on {expected.threads} threads")

    study = client.submit("foot-tire", set=CHANGES).wait()
    result = study.result()

    # An index is the share of the variance of the strain at the centre that a location's own depth explains. "±" is
    # what quadrature, decomposition and mesh may be off together.
    for location in result.locations:
        x, y = location.gsi_x_percent, location.gsi_y_percent
        dx, dy = location.gsi_x_error_percent, location.gsi_y_error_percent
        certain = "" if location.rank_certain else "  (the rank isn't certain)"
        print(f"{location.rank}  {location.name}  x {x:6.2f} ±{dx:5.2f} %   y {y:6.2f} ±{dy:5.2f} %{certain}")

    # What to know before believing these numbers, in the program's words.
    for note in result.notes:
        print("-", note)

    # Where to glue films, how well they then know the contact, and how sure that is.
    answer = result.answer
    if answer is not None and answer.layout is not None:
        print(answer.sentence)
        print(f"{answer.layout.verdict}: {answer.layout.reason}")

    result.plot_ranking().savefig("ranking.png")
    result.plot_map("y", input="P3").savefig("map.png")
    study.export("csv", "points", "points.csv")
