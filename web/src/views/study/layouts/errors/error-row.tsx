import { short } from "../../../../lib/layouts/layout-words.ts";

/** A row of what makes the errors of a layout: what it is of, and both errors then. */
export function ErrorRow({ of, angle, force }: { of: string; angle: number | null | undefined; force: number | null | undefined }) {
  return (
    <tr>
      <th scope="row" class="words">
        {of}
      </th>
      <td>{short(angle)}</td>
      <td>{short(force)}</td>
    </tr>
  );
}
