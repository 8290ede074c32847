package rigibo.frontend.editor;

import rigibo.frontend.document.Problem;
import rigibo.frontend.editor.desk.Inspection;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.puzzle.check.LevelProof;

import java.util.List;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;

/**
 * Plays drafts through on a thread of its own, so that the window stays responsive. The check's
 * parallel streams run in the pool from which they are started: one thread, with a priority below
 * the window's.
 */
final class Proving {

    private final ForkJoinPool thread =
            new ForkJoinPool(
                    1,
                    pool -> {
                        var worker =
                                ForkJoinPool.defaultForkJoinWorkerThreadFactory.newThread(pool);
                        worker.setPriority(Thread.MIN_PRIORITY);
                        return worker;
                    },
                    null,
                    false);
    private Draft draft;
    private ForkJoinTask<List<Problem>> task;
    private volatile long games;

    void start(Draft proved) {
        if (!isBusy()) {
            draft = proved;
            games = 0;
            task =
                    thread.submit(
                            () -> LevelProof.problems("draft", proved.toString(), this::count));
        }
    }

    private void count(long played) {
        games = played;
    }

    /** Games that were played for the present proof, or the last one. */
    long games() {
        return games;
    }

    boolean isBusy() {
        return task != null;
    }

    /** Hands over the findings as soon as there are any; returns whether there were. */
    boolean tell(Inspection inspection) {
        boolean isDone = task != null && task.isDone();
        if (isDone) {
            inspection.played(draft, task.join());
            task = null;
        }
        return isDone;
    }

    void close() {
        thread.shutdownNow();
    }
}
