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
 * @param recording nothing when the file has a problem
 * @param otherRevision revision of the simulation in which it was played, if that is not the
 *     present one, which is a problem; 0 for files of the first format, which state none
 * @param unmade what its level has to be made from before it can be watched, which is a problem
 *     until then
 * @param problems all of them, in the order of the file
 */
public record LoadedReplay(
        Optional<Recording> recording,
        OptionalInt otherRevision,
        Optional<Origin> unmade,
        List<Problem> problems) {

    /** Of no file. */
    static final LoadedReplay NONE =
            new LoadedReplay(Optional.empty(), OptionalInt.empty(), Optional.empty(), List.of());

    /** Whether nothing is missing but its level, which this version of the generator makes. */
    public boolean lacksItsLevelAlone() {
        return unmade.filter(origin -> origin.generator() == Generator.VERSION).isPresent()
                && problems.size() == 1;
    }
}
