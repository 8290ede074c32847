package rigibo.frontend.puzzle.replay;

import rigibo.frontend.document.Problem;

import java.util.List;
import java.util.Optional;

/**
 * What became of a replay file.
 *
 * @param recording nothing when the file has a problem
 * @param problems all of them, in the order of the file
 */
public record LoadedReplay(Optional<Recording> recording, List<Problem> problems) {}
