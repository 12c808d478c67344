import { documentOf, exampleText, type Content, type Operation } from "../../lib/shell/reference/description.ts";
import { Code } from "./code.tsx";
import { MarkedText } from "./marked-text.tsx";

/** One operation, folded: what it takes, and what it answers. */
export function OperationEntry({ operation }: { operation: Operation }) {
  const { id, method, path, summary, description, parameters = [], requestBody, responses = {} } = operation;
  return (
    <details id={id} class="reference-entry">
      <summary>
        <code>
          <b>{method}</b> {path}
        </code>{" "}
        {summary}
      </summary>
      {description !== undefined && (
        <p>
          <MarkedText text={description} />
        </p>
      )}
      {parameters.length > 0 && (
        <dl>
          {parameters.map((parameter) => (
            <div key={`${parameter.in} ${parameter.name}`}>
              <dt>
                <code>{parameter.name}</code> in the {parameter.in}
                {parameter.required === true && ", needed"}
              </dt>
              <dd>
                <MarkedText text={parameter.description ?? ""} />
              </dd>
            </div>
          ))}
        </dl>
      )}
      {requestBody !== undefined && <Bodies what={`${method} ${path} takes`} contents={requestBody.content ?? {}} />}
      {Object.entries(responses).map(([status, response]) => (
        <div key={status}>
          <p>
            <b>{status}</b> <MarkedText text={response.description ?? ""} />
          </p>
          <Bodies what={`${status} of ${method} ${path}`} contents={response.content ?? {}} />
        </div>
      ))}
    </details>
  );
}

function Bodies({ what, contents }: { what: string; contents: Record<string, Content> }) {
  return (
    <>
      {Object.entries(contents).map(([kind, content]) => {
        const document = documentOf(content);
        const example = exampleText(content);
        return (
          <div key={kind}>
            <p class="quiet">
              {kind}
              {document !== null && (
                <>
                  :{" "}
                  <a href={`#${document}`} onClick={() => unfold(document)}>
                    {document}
                  </a>
                </>
              )}
            </p>
            {example !== null && <Code name={`${what}, as ${kind}`} text={example} />}
          </div>
        );
      })}
    </>
  );
}

/** The link's target is folded. */
function unfold(id: string): void {
  const target = document.getElementById(id);
  if (target instanceof HTMLDetailsElement) target.open = true;
}
