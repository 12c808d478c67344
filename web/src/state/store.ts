/** Keeps the state and tells of every change. */

import type { AppState } from "./app-state.ts";

export interface Store {
  get(): AppState;
  update(change: (state: AppState) => AppState): void;
  subscribe(listener: () => void): () => void;
}

export function createStore(initial: AppState): Store {
  let state = initial;
  const listeners = new Set<() => void>();
  return {
    get: () => state,
    update: (change) => {
      const next = change(state);
      if (next === state) return;
      state = next;
      listeners.forEach((listener) => listener());
    },
    subscribe: (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}

/** One field of the state, for code that changes no other. */
export interface Part<T> {
  get(): T;
  set(value: T): void;
}

export function partOf<K extends keyof AppState>(store: Store, key: K): Part<AppState[K]> {
  return {
    get: () => store.get()[key],
    set: (value) => store.update((state) => (state[key] === value ? state : { ...state, [key]: value })),
  };
}
