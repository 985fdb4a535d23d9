/** Sentences over the foot of the cloth: what was done and warnings leave by themselves, faults stay until dismissed. */
import { useEffect, useState } from "preact/hooks";

import { Icon } from "./controls/Icon.tsx";
import { download } from "./files.ts";
import { asideFile } from "./keeping/autosave.ts";
import type { Notice } from "./state/document.ts";

interface Props {
  readonly notices: readonly Notice[];
  readonly onDismiss: (id: number) => void;
}

/** Milliseconds that a notice stays: time to read its sentence twice. */
const STAYS: Readonly<Record<Notice["kind"], number | null>> = { done: 5_000, warning: 15_000, fault: null };

export function Notices({ notices, onDismiss }: Props) {
  return (
    <div class="notices" aria-live="polite">
      {notices.map((notice) => (
        <NoticeCard key={notice.id} notice={notice} onDismiss={onDismiss} />
      ))}
    </div>
  );
}

function NoticeCard({ notice, onDismiss }: { notice: Notice; onDismiss: (id: number) => void }) {
  // While it is read, by pointer or by keys, it stays.
  const [isRead, setRead] = useState(false);
  useEffect(() => {
    const stays = STAYS[notice.kind];
    if (stays === null || isRead) return;
    const timer = setTimeout(() => onDismiss(notice.id), stays);
    return () => clearTimeout(timer);
  }, [notice.id, isRead]);
  return (
    <div
      class={`notice is-${notice.kind}`}
      role={notice.kind === "fault" ? "alert" : "status"}
      data-testid={`notice-${notice.kind}`}
      onPointerEnter={() => setRead(true)}
      onPointerLeave={() => setRead(false)}
      onFocusIn={() => setRead(true)}
      onFocusOut={() => setRead(false)}
    >
      <p>
        {notice.text}
        {notice.offer === "aside" && (
          <>
            {" "}
            <button type="button" class="text-button" data-testid="aside" onClick={saveAside}>
              Save what was set aside
            </button>
          </>
        )}
      </p>
      <button type="button" class="icon-button" aria-label="Dismiss" onClick={() => onDismiss(notice.id)}>
        <Icon name="close" />
      </button>
    </div>
  );
}

function saveAside(): void {
  const file = asideFile();
  if (file !== null) download(file.name, file.content, "application/json");
}
