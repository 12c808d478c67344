import { different, panels } from "../../../lib/study/signals/film-curves.ts";
import type { Signals } from "../../../wire.ts";
import { ClaimsTable } from "./claims-table.tsx";
import { FilmKey, FilmPlot } from "./film-plot.tsx";

/** Volts of films over load, pressure and contact angle, and what holds of what is claimed of them. */
export function SignalsPanel({ signals, study }: { signals: Signals; study: string }) {
  const positions = different(signals.rows.map((row) => row.position));
  return (
    <section class="panel" aria-labelledby="signals-title">
      <h2 id="signals-title">Signals</h2>
      <p>
        Do the open circuit volts of strain films rise with the load and fall with the pressure, and are they a line over the angle around the wheel from the
        film to the contact? Below, the volts with their errors by the mesh.
      </p>
      {different(signals.claims.map((row) => row.tire)).map((tire) => (
        <ClaimsTable key={tire} tire={tire} claims={signals.claims.filter((row) => row.tire === tire)} />
      ))}
      <FilmKey positions={positions} />
      <div class="charts signal-charts">
        {panels(signals.rows, ["load", "pressure", "contact"]).map((panel) => (
          <FilmPlot key={`${panel.tire} ${panel.direction} ${panel.over}`} panel={panel} study={study} />
        ))}
      </div>
    </section>
  );
}
