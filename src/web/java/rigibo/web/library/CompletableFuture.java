package rigibo.web.library;

import java.util.concurrent.Executor;
import java.util.function.Supplier;

/** What will be known later, and is waited for by nobody. */
public final class CompletableFuture<T> {

    private T value;
    private RuntimeException failure;
    private boolean isDone;

    /** A value that an executor finds out. */
    public static <T> CompletableFuture<T> supplyAsync(Supplier<T> source, Executor executor) {
        CompletableFuture<T> future = new CompletableFuture<>();
        executor.execute(() -> future.find(source));
        return future;
    }

    /** A value that is known already. */
    public static <T> CompletableFuture<T> completedFuture(T value) {
        CompletableFuture<T> future = new CompletableFuture<>();
        future.complete(value);
        return future;
    }

    public boolean complete(T found) {
        value = found;
        isDone = true;
        return true;
    }

    /** The value if it is there. */
    public T getNow(T otherwise) {
        return isDone ? value : otherwise;
    }

    private void find(Supplier<T> source) {
        try {
            value = source.get();
        } catch (RuntimeException thrown) {
            failure = thrown;
        }
        isDone = true;
    }

    public boolean isDone() {
        return isDone;
    }

    /** The value, which must be there. */
    public T join() {
        if (!isDone) {
            throw new IllegalStateException("nobody can wait in a page");
        }
        if (failure != null) {
            throw failure;
        }
        return value;
    }
}
