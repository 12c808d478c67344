import type { JSX } from "preact";
import { formatRoute, SECTIONS, type Section, type StudyRoute } from "../../lib/route.ts";
import { later } from "../shared/later.tsx";
import { SectionNotes } from "../shared/section-notes.tsx";
import { useRoving } from "../shared/use-roving.ts";
import { AnswerView } from "./answer/answer-view.tsx";
import { RunView } from "./run/run-view.tsx";
import type { SectionProps } from "./section-props.ts";
import { SectionTerms } from "./section-terms.tsx";

const SECTION_NAMES: Record<(typeof SECTIONS)[number], string> = {
  answer: "Answer",
  tire: "Tire",
  layouts: "Layouts",
  indices: "Indices",
  trade: "Trade",
  run: "Run",
};

const IndicesView = later("the indices", async () => (await import("./indices/indices-view.tsx")).IndicesView);
const LayoutsView = later("the layouts", async () => (await import("./layouts/layouts-view.tsx")).LayoutsView);
const SheetView = later("the sheet", async () => (await import("./sheet/sheet-view.tsx")).SheetView);
const TireView = later("the tire", async () => (await import("./tire/tire-view.tsx")).TireView);
const TradeView = later("the trade", async () => (await import("./trade/trade-view.tsx")).TradeView);

const VIEWS: Record<Section, (props: SectionProps) => JSX.Element> = {
  answer: AnswerView,
  tire: TireView,
  layouts: LayoutsView,
  indices: IndicesView,
  trade: TradeView,
  run: RunView,
  sheet: SheetView,
};

/** Links to the sections of a study, one Tab stop. */
export function SectionLinks({ route }: { route: StudyRoute }) {
  const group = useRoving<HTMLElement>(null);
  return (
    <nav ref={group} class="sections" aria-label="Study">
      {SECTIONS.map((section) => (
        <a key={section} href={formatRoute({ ...route, section })} aria-current={section === route.section ? "page" : undefined}>
          {SECTION_NAMES[section]}
        </a>
      ))}
    </nav>
  );
}

/** The section that the address names. */
export function SectionBody(props: SectionProps) {
  const View = VIEWS[props.route.section];
  return (
    <div id="section" tabIndex={-1}>
      <View {...props} />
      <SectionNotes result={props.result} section={props.route.section} />
      <SectionTerms section={props.route.section} />
    </div>
  );
}
