import { css, diverging } from "../../../lib/chart/colour.ts";
import { roundPeak } from "../../../lib/document/preview/preview-rows.ts";
import { microstrain } from "../../../lib/format.ts";
import { borders } from "../../../lib/document/preview/cell-borders.ts";
import type { IndexMap, MapLayer } from "../../../wire.ts";

const [WIDTH, HEIGHT] = [200, 96];

/** Strains at the means over the inner surface, both directions on one scale each that ends at a round number. */
export function PreviewMaps({ map }: { map: IndexMap }) {
  return (
    <div class="preview-maps">
      {map.layers.map((layer) => (
        <StrainMap key={layer.direction} map={map} layer={layer} />
      ))}
    </div>
  );
}

function StrainMap({ map, layer }: { map: IndexMap; layer: MapLayer }) {
  const peak = roundPeak(layer.strain.reduce((most, strain) => Math.max(most, Math.abs(strain)), 0));
  const [columns, rows] = [places(map.theta_deg, WIDTH), places(map.phi_deg, HEIGHT)];
  const label = `Strain ${layer.direction} over the inner surface at the means, from ${microstrain(-peak)} to ${microstrain(peak)} microstrain`;
  return (
    <figure>
      <figcaption>
        Strain {layer.direction}, ±{microstrain(peak)} µε
      </figcaption>
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={label} shape-rendering="crispEdges">
        {rows.flatMap((row, i) =>
          columns.map((column, j) => {
            const strain = layer.strain[i * columns.length + j] ?? 0;
            const fill = css(diverging(0.5 + strain / (2 * peak)));
            return <rect key={`${i} ${j}`} x={column.from} y={HEIGHT - row.to} width={column.to - column.from} height={row.to - row.from} fill={fill} />;
          }),
        )}
      </svg>
    </figure>
  );
}

/** Where the cells about these angles begin and end, spread over a length. */
function places(angles_deg: readonly number[], length: number): { from: number; to: number }[] {
  const edges = borders(angles_deg);
  const [first, last] = [edges[0] ?? 0, edges.at(-1) ?? 1];
  const at = (angle: number | undefined): number => (((angle ?? first) - first) / (last - first)) * length;
  return angles_deg.map((_, index) => ({ from: at(edges[index]), to: at(edges[index + 1]) }));
}
