package tools.jackson.core;

/** Needed by signatures only. */
public interface ObjectReadContext {

    static ObjectReadContext empty() {
        return new ObjectReadContext() {};
    }
}
