package rigibo.frontend.puzzle.replay;

import rigibo.frontend.document.Problem;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * What became of a replay file.
 *
 * @param recording nothing when the file has a problem
 * @param otherRevision of the simulation that it was played in, where that is not the present one,
 *     which is a problem; files of the first format know none and are of 0
 * @param problems all of them, in the order of the file
 */
public record LoadedReplay(
        Optional<Recording> recording, OptionalInt otherRevision, List<Problem> problems) {

    /** Of no file. */
    static final LoadedReplay NONE =
            new LoadedReplay(Optional.empty(), OptionalInt.empty(), List.of());
}
