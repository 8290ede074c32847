package rigibo.web.library;

/** A value that may be known later; no thread waits for it. */
public final class CompletableFuture<T> {

    private T value;
    private Throwable failure;
    private boolean isDone;

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

    public boolean completeExceptionally(Throwable thrown) {
        failure = thrown;
        isDone = true;
        return true;
    }

    /** The value if it is known, or another one. */
    public T getNow(T otherwise) {
        return isDone ? value : otherwise;
    }

    public boolean isDone() {
        return isDone;
    }

    /** The value, which must be known. */
    public T join() {
        if (!isDone) {
            throw new IllegalStateException("nobody can wait in a page");
        }
        if (failure != null) {
            throw new IllegalStateException(failure);
        }
        return value;
    }
}
