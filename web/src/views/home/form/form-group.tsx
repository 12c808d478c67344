import type { ComponentChildren } from "preact";

/** Fields that belong together. */
export function FormGroup({ title, children }: { title: string; children: ComponentChildren }) {
  return (
    <fieldset class="form-group">
      <legend>{title}</legend>
      {children}
    </fieldset>
  );
}
