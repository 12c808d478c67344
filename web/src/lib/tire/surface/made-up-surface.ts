/** A torus of known shape, pressed by a known amount: data for the tests beside this file. */

export const [RADIUS_MM, SECTION_MM, PRESSED_MM] = [40, 10, 2];

const DEGREE = Math.PI / 180;

/** Where an angle pair lies; `thickness` outward. */
export function torusPoint(theta_deg: number, phi_deg: number, thickness = 0): [number, number, number] {
  const section = SECTION_MM + thickness;
  const reach = RADIUS_MM - SECTION_MM + section * Math.cos(phi_deg * DEGREE);
  return [reach * Math.sin(theta_deg * DEGREE), section * Math.sin(phi_deg * DEGREE), -reach * Math.cos(theta_deg * DEGREE)];
}

/** The bytes that the service would send. */
export function surfaceBytes(columns: number, rows: number): ArrayBuffer {
  const theta_deg = Array.from({ length: columns }, (_, k) => -180 + (360 * k) / columns);
  const phi_deg = Array.from({ length: rows }, (_, k) => -120 + (240 * k) / (rows - 1));
  const points = (thickness: number) => phi_deg.flatMap((phi) => theta_deg.flatMap((theta) => torusPoint(theta, phi, thickness)));
  const pressed = phi_deg.flatMap(() => theta_deg.flatMap((theta) => [0, 0, Math.abs(theta) < 30 ? PRESSED_MM : 0]));
  const names = ["inner_inflated_mm", "inner_displacement_mm", "outer_inflated_mm", "outer_displacement_mm"];
  const count = rows * columns;
  const arrays = names.map((name, k) => ({ name, unit: "mm", components: 3, offset: 12 * count * k, count }));
  const ground = { x_mm: [-20, 20], z_mm: [-38, -38], camber_deg: 0 };
  const text = JSON.stringify({ study: "made-up", level: "draft", rows, columns, phi_deg, theta_deg, ground, arrays });
  const header = new TextEncoder().encode(text.padEnd(4 * Math.ceil(text.length / 4)));
  const bytes = new Uint8Array(4 + header.length + 4 * 12 * count);
  new DataView(bytes.buffer).setUint32(0, header.length, true);
  bytes.set(header, 4);
  [points(0), pressed, points(3), pressed].flat().forEach((value, k) => new DataView(bytes.buffer).setFloat32(4 + header.length + 4 * k, value, true));
  return bytes.buffer;
}
