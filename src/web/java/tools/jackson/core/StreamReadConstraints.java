package tools.jackson.core;

/** Bounds of a text to be read. */
public final class StreamReadConstraints {

    long document = Long.MAX_VALUE;
    long tokens = Long.MAX_VALUE;
    int depth = Integer.MAX_VALUE;
    int string = Integer.MAX_VALUE;
    int name = Integer.MAX_VALUE;
    int number = Integer.MAX_VALUE;

    private StreamReadConstraints() {}

    public static Builder builder() {
        return new Builder();
    }

    /** Sets the bounds one by one. */
    public static final class Builder {

        private final StreamReadConstraints made = new StreamReadConstraints();

        public Builder maxDocumentLength(long most) {
            made.document = most;
            return this;
        }

        public Builder maxTokenCount(long most) {
            made.tokens = most;
            return this;
        }

        public Builder maxNestingDepth(int most) {
            made.depth = most;
            return this;
        }

        public Builder maxStringLength(int most) {
            made.string = most;
            return this;
        }

        public Builder maxNameLength(int most) {
            made.name = most;
            return this;
        }

        public Builder maxNumberLength(int most) {
            made.number = most;
            return this;
        }

        public StreamReadConstraints build() {
            return made;
        }
    }
}
