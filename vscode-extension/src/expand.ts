// Abbreviations in settings: `~`, ${userHome}, ${workspaceFolder}, ${env:NAME}.

export interface Places {
  readonly home: string;
  readonly workspaceFolder?: string;
  readonly env: Readonly<Record<string, string | undefined>>;
}

/** Return `text` with its abbreviations replaced; what has no value stays as it is written. */
export function expand(text: string, places: Places): string {
  return text
    .replace(/^~(?=$|[/\\])/, () => places.home)
    .replace(/\$\{userHome\}/g, () => places.home)
    .replace(/\$\{workspaceFolder\}/g, (whole) => places.workspaceFolder ?? whole)
    .replace(/\$\{env:([^}]+)\}/g, (whole, name: string) => places.env[name] ?? whole);
}
