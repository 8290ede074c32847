package rigibo.frontend.puzzle.replay;

import rigibo.frontend.document.Problem;
import rigibo.frontend.puzzle.generate.Generator;
import rigibo.frontend.puzzle.level.Origin;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * The result of loading a replay file.
 *
 * @param recording empty if the file has a problem
 * @param otherRevision revision of the simulation in which it was played, if it is another one,
 *     which is a problem; 0 for files of the first format, which state none
 * @param unmade origin from which its level has to be made before the replay can be watched, which
 *     is a problem until then
 * @param problems all of them, in the order of the file
 */
public record LoadedReplay(
        Optional<Recording> recording,
        OptionalInt otherRevision,
        Optional<Origin> unmade,
        List<Problem> problems) {

    /** The result for no file. */
    static final LoadedReplay NONE =
            new LoadedReplay(Optional.empty(), OptionalInt.empty(), Optional.empty(), List.of());

    /** Whether only its level is missing and this version of the generator can make it. */
    public boolean lacksItsLevelAlone() {
        return unmade.filter(origin -> origin.generator() == Generator.VERSION).isPresent()
                && problems.size() == 1;
    }
}
