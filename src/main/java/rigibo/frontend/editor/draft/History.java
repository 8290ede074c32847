package rigibo.frontend.editor.draft;

import java.util.ArrayDeque;
import java.util.Deque;

/** A draft with its past and future versions. All edits between two calls count as one change. */
public final class History {

    /** Most versions that are kept; drafts share everything unchanged. */
    private static final int LONGEST = 10_000;

    private final Deque<Draft> past = new ArrayDeque<>();
    private final Deque<Draft> future = new ArrayDeque<>();
    private Draft present;
    private Draft held;

    /** A history that begins with a draft. */
    public History(Draft first) {
        present = first;
    }

    /** The present draft. */
    public Draft present() {
        return present;
    }

    /** The draft with which the present gesture began; without one, the present draft. */
    public Draft origin() {
        return held == null ? present : held;
    }

    /** Whether changes are being collected into one. */
    public boolean isGesture() {
        return held != null;
    }

    /** Collects all changes into one until {@link #end}. */
    public void begin() {
        end();
        held = present;
    }

    /** Ends the change that {@link #begin} began. */
    public void end() {
        if (held != null && !held.equals(present)) {
            remember(held);
        }
        held = null;
    }

    /** Drops all changes since {@link #begin}. */
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

    /** Undoes the last change, if there is one. */
    public void undo() {
        end();
        if (canUndo()) {
            future.push(present);
            present = past.pop();
        }
    }

    /** Redoes the change that was undone last, if there is one. */
    public void redo() {
        end();
        if (canRedo()) {
            past.push(present);
            present = future.pop();
        }
    }
}
