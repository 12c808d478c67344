/** Names of the service's documents in words. A name that isn't known here is shown as it came. */

const METHODS: Record<string, string> = {
  mdrm: "M-DRM (product form)",
  additive: "additive form",
  shifted: "shifted product form",
  corrected: "corrected form",
  bivariate: "bivariate form",
  tensor: "tensor grid",
  pce: "polynomial chaos",
  saltelli: "Saltelli's estimator",
};

const STATUSES: Record<string, string> = {
  ok: "ok",
  constant: "constant: no variance, so no indices",
  "product-form-broken": "product form broken",
  unusable: "unusable: too few points have a strain, so no indices",
};

/** What gave the indices of an output. */
export function methodName(method: string): string {
  return METHODS[method] ?? method;
}

/** How the analysis of an output ended. */
export function statusName(status: string): string {
  return STATUSES[status] ?? status;
}
