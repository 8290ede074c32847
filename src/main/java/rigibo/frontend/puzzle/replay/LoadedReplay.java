package rigibo.frontend.puzzle.replay;

import rigibo.frontend.document.Problem;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * The result of loading a replay file.
 *
 * @param recording nothing when the file has a problem
 * @param otherRevision revision of the simulation in which it was played, if that is not the
 *     present one, which is a problem; 0 for files of the first format, which state none
 * @param problems all of them, in the order of the file
 */
public record LoadedReplay(
        Optional<Recording> recording, OptionalInt otherRevision, List<Problem> problems) {

    /** Of no file. */
    static final LoadedReplay NONE =
            new LoadedReplay(Optional.empty(), OptionalInt.empty(), List.of());
}
