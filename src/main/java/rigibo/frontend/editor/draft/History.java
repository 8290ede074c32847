package rigibo.frontend.editor.draft;

import java.util.ArrayDeque;
import java.util.Deque;

/** A draft with its past and future versions. All edits between two calls count as one change. */
public final class History {

    /** More than anyone takes back; drafts share what they have in common. */
    private static final int LONGEST = 10_000;

    private final Deque<Draft> past = new ArrayDeque<>();
    private final Deque<Draft> future = new ArrayDeque<>();
    private Draft present;
    private Draft held;

    /** A history that begins with a draft. */
    public History(Draft first) {
        present = first;
    }

    /** The draft as it stands. */
    public Draft present() {
        return present;
    }

    /** The draft that a gesture began with; as it stands where there is none. */
    public Draft origin() {
        return held == null ? present : held;
    }

    /** Whether several changes are being made that will be one. */
    public boolean isGesture() {
        return held != null;
    }

    /** From now on changes are one, until {@link #end}. */
    public void begin() {
        end();
        held = present;
    }

    /** The changes since {@link #begin} are done. */
    public void end() {
        if (held != null && !held.equals(present)) {
            remember(held);
        }
        held = null;
    }

    /** The changes since {@link #begin} are not to be. */
    public void cancel() {
        if (held != null) {
            present = held;
            held = null;
        }
    }

    /** A change. */
    public void change(Draft next) {
        if (held == null && !next.equals(present)) {
            remember(present);
        }
        present = next;
    }

    private void remember(Draft before) {
        past.push(before);
        future.clear();
        if (past.size() > LONGEST) {
            past.removeLast();
        }
    }

    public boolean canUndo() {
        return !past.isEmpty();
    }

    public boolean canRedo() {
        return !future.isEmpty();
    }

    /** Takes the last change back, where there is one. */
    public void undo() {
        end();
        if (canUndo()) {
            future.push(present);
            present = past.pop();
        }
    }

    /** Makes what was taken back, where there is something. */
    public void redo() {
        end();
        if (canRedo()) {
            past.push(present);
            present = future.pop();
        }
    }
}
