package rigibo.frontend.scene.trial;

import java.util.Optional;

/**
 * An experiment in pieces, each a step or two of a copy: a page, which has one thread, draws its
 * pictures between them.
 *
 * @param <R> what comes out
 */
public interface Trial<R> {

    /** Does the next piece; returns what came out after the last one. */
    Optional<R> goOn();
}
