package tools.jackson.core;

/** Nothing that a reader asks about. */
public interface ObjectReadContext {

    static ObjectReadContext empty() {
        return new ObjectReadContext() {};
    }
}
