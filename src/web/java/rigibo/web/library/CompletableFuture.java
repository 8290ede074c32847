package rigibo.web.library;

/** What will be known later, and is waited for by nobody. */
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

    /** The value if it is there. */
    public T getNow(T otherwise) {
        return isDone ? value : otherwise;
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
            throw new IllegalStateException(failure);
        }
        return value;
    }
}
