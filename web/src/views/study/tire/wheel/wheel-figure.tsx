import { useMemo } from "preact/hooks";
import { fileName } from "../../../../lib/shell/file-names.ts";
import type { SurfacePoint } from "../../../../lib/tire/map/map-grid.ts";
import type { Surface } from "../../../../lib/tire/surface/surface-reader.ts";
import type { Sight } from "../../../../lib/tire/view-address.ts";
import { ProblemText } from "../../../shared/problem-box.tsx";
import type { TireModel } from "../tire-model.ts";
import { useEye } from "./use-eye.ts";
import { WheelButtons } from "./wheel-buttons.tsx";
import { radiusOf, WheelCanvas, wheelActions } from "./wheel-canvas.tsx";

interface Props {
  model: TireModel;
  title: string;
  study: string;
  sight: Sight;
  onSight: (change: Partial<Sight>) => void;
  point: SurfacePoint | null;
  onPoint: (point: SurfacePoint | null) => void;
  onPin: (point: SurfacePoint | null) => void;
}

/** The wheel in three dimensions, or why there is none. */
export function WheelFigure(props: Props) {
  const { surface } = props.model;
  if (surface.status === "ready") return <Wheel {...props} surface={surface.value} />;
  return (
    <div class="wheel wheel-missing">
      {surface.status === "loading" ? (
        <p class="quiet" role="status">
          Loading the tire …
        </p>
      ) : (
        <div class="quiet" role="status">
          <p>There is no tire to turn, only its map.</p>
          <ProblemText problem={surface.problem} />
        </div>
      )}
    </div>
  );
}

function Wheel({ model, surface, title, study, sight, onSight, point, onPoint, onPin }: Props & { surface: Surface }) {
  const radius_mm = useMemo(() => radiusOf(surface), [surface.theta_deg]);
  const eye = useEye(sight.eye, (to) => onSight({ eye: to }));
  const actions = wheelActions(eye, sight.isCut, onSight);
  const saved = { title: `${study}: tire`, file: fileName(study, typeof sight.eye === "string" ? sight.eye : "turned", "png") };
  return (
    <WheelCanvas {...{ model, surface, title, radius_mm, sight, eye, actions, point, onPoint, onPin, saved }}>
      {(save) => (
        <>
          <WheelButtons
            actions={{ ...actions, save }}
            factor={sight.factor}
            onFactor={(factor) => onSight({ factor })}
            isCut={sight.isCut}
            hasGround={surface.ground !== null}
          />
          {model.isSector && <p class="quiet">The service sends no skins of this tire's whole wheel: only the map's sector of the inner skin is drawn.</p>}
        </>
      )}
    </WheelCanvas>
  );
}
