// Addresses of a page that the user's browser reaches by another way than the server itself.

/**
 * Return where a page of a loopback server is to be found, given where its root is.
 *
 * Some editors in a browser resolve a root only, and lose path and query of what lies below it.
 */
export function relocate(local: string, externalRoot: string): string {
  const { pathname, search } = new URL(local);
  const root = externalRoot.endsWith("/") ? externalRoot : `${externalRoot}/`;
  return new URL(`.${pathname}${search}`, root).toString();
}
