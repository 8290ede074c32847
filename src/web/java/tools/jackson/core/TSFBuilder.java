package tools.jackson.core;

/** Builds a factory of readers within bounds. */
public abstract class TSFBuilder<F, B extends TSFBuilder<F, B>> {

    protected StreamReadConstraints bounds;

    @SuppressWarnings("unchecked")
    public B streamReadConstraints(StreamReadConstraints kept) {
        bounds = kept;
        return (B) this;
    }
}
