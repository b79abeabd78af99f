// Light and dark: as the system has it until the user says otherwise.

export function startTheme(stored: string | null): void {
  document.documentElement.dataset["theme"] = stored ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
}
export function turnTheme(): void {
  document.documentElement.dataset["theme"] = document.documentElement.dataset["theme"] === "dark" ? "light" : "dark";
}

/** The colours of the light theme, in which figures are exported. */
export function lightColours(): Map<string, string> {
  const colours = new Map<string, string>();
  for (const sheet of document.styleSheets)
    for (const rule of sheet.cssRules)
      if (rule instanceof CSSStyleRule && rule.selectorText === ":root") for (const name of rule.style) if (name.startsWith("--")) colours.set(name, rule.style.getPropertyValue(name).trim());
  return colours;
}
