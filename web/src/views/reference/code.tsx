/** Text that is scrolled by itself, with the keyboard too. */
export function Code({ name, text }: { name: string; text: string }) {
  return (
    <pre tabIndex={0} role="group" aria-label={name}>
      {text}
    </pre>
  );
}
