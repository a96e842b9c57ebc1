// The head of the page: its views as tabs, its state as a link and as a file, its colours.

import { useEffect, useState } from "preact/hooks";
import { droppedFile } from "../parts/dropped_folder";
import { chosen } from "../parts/inputs";
import { saveFile } from "../parts/save";
import { change, link, type State } from "../state/state";
import { words } from "../words/page";
import { openFile, pageToml } from "./open_file";

interface Note {
  text: string;
  isWrong: boolean;
}

/** Seconds that a note stays; one that tells what is wrong stays until the next. */
const NOTE_S = 6;

export function Header({ state, views, view }: { state: State; views: string[]; view: string }) {
  const [note, setNote] = useState<Note>({ text: "", isWrong: false });
  const [isOver, setIsOver] = useState(false);
  const take = async (file: File | undefined) => file && setNote(await openFile(file));
  useDropAnywhere(take, (fault) => setNote({ text: `${words.badFile}: ${fault.message}`, isWrong: true }), setIsOver);
  useEffect(() => {
    if (!note.text || note.isWrong) return;
    const later = setTimeout(() => setNote({ text: "", isWrong: false }), 1000 * NOTE_S);
    return () => clearTimeout(later);
  }, [note]);
  const turn = (event: KeyboardEvent) => {
    const at = views.indexOf(view);
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1 + views.length, Home: 0, End: views.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    change("view", views[to % views.length]);
    document.getElementById(`tab-${views[to % views.length]}`)?.focus();
  };
  const copy = () =>
    navigator.clipboard?.writeText(link()).then(
      () => setNote({ text: words.copied, isWrong: false }),
      () => setNote({ text: words.notCopied, isWrong: true }),
    );
  const save = () =>
    pageToml().then(
      (text) => saveFile("studio.toml", text),
      (fault) => setNote({ text: fault.message === "offline" ? words.offline : fault.message, isWrong: true }),
    );
  return (
    <header class={`top${isOver ? " over" : ""}`}>
      <a
        class="skip button"
        href="#view"
        onClick={(event) => {
          // the address holds the state: it stays as it is
          event.preventDefault();
          document.getElementById("view")?.focus();
        }}
      >
        {words.skip}
      </a>
      <h1>{words.title}</h1>
      <div role="tablist" aria-label={words.title} onKeyDown={turn}>
        {views.map((name) => (
          <button key={name} id={`tab-${name}`} role="tab" aria-selected={name === view} aria-controls="tabpanel" tabIndex={name === view ? 0 : -1} onClick={() => change("view", name)}>
            {words.views[name]}
          </button>
        ))}
      </div>
      <span class="space" />
      <span role="status" class="hint">
        {note.isWrong ? "" : note.text}
      </span>
      <div class="pageFiles" role="group" aria-label={words.pageFiles}>
        <label class="button" title={words.openHint}>
          {words.openPage}
          <input type="file" accept=".toml,.xml,.nc,.csv,.json,.zip" onChange={(event) => void take(chosen(event))} />
        </label>
        <button onClick={() => void save()} title={words.savePageHint}>
          {words.savePage}
        </button>
        <button onClick={() => void copy()}>{words.copyLink}</button>
        <select aria-label={words.theme.label} value={state.theme} onChange={(event) => change("theme", event.currentTarget.value)}>
          <option value="auto">{words.theme.auto}</option>
          <option value="light">{words.theme.light}</option>
          <option value="dark">{words.theme.dark}</option>
        </select>
      </div>
      {note.isWrong && (
        <p class="fault" role="alert">
          {note.text}
        </p>
      )}
    </header>
  );
}

/** Files dropped anywhere: a TOML is taken whatever view it falls on, others where no view takes them itself. */
function useDropAnywhere(take: (file: File | undefined) => unknown, refuse: (fault: Error) => void, setIsOver: (is: boolean) => void) {
  useEffect(() => {
    let later = 0;
    const over = (event: DragEvent) => {
      if (!event.dataTransfer?.types.includes("Files")) return;
      event.preventDefault();
      setIsOver(true);
      clearTimeout(later);
      later = window.setTimeout(() => setIsOver(false), 300);
    };
    const first = (event: DragEvent) => {
      const file = event.dataTransfer?.files[0];
      if (!file?.name.toLowerCase().endsWith(".toml")) return;
      event.preventDefault();
      event.stopPropagation();
      take(file);
    };
    const last = (event: DragEvent) => {
      if (event.defaultPrevented) return;
      event.preventDefault();
      void droppedFile(event.dataTransfer).then(take, refuse);
    };
    window.addEventListener("dragover", over);
    window.addEventListener("drop", first, true);
    window.addEventListener("drop", last);
    return () => {
      window.removeEventListener("dragover", over);
      window.removeEventListener("drop", first, true);
      window.removeEventListener("drop", last);
    };
  }, []);
}
