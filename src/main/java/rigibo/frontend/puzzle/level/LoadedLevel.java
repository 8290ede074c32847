package rigibo.frontend.puzzle.level;

import tools.jackson.databind.JsonNode;

import java.util.List;
import java.util.Optional;

/** What became of a level file: the level, unless an error keeps it from being played. */
public final class LoadedLevel {

    private final Optional<Level> level;
    private final Optional<LocatedJson> json;
    private final Problems problems;

    LoadedLevel(Optional<Level> level, Optional<LocatedJson> json, Problems problems) {
        this.level = level;
        this.json = json;
        this.problems = problems;
    }

    /** The level; nothing when the file has an error. */
    public Optional<Level> level() {
        return level;
    }

    /** The file as it stands, also with errors, to be read only; nothing when it is no JSON. */
    public Optional<JsonNode> document() {
        return json.map(LocatedJson::root);
    }

    /** All problems in the order of the file. */
    public List<Problem> problems() {
        return problems.inOrder();
    }

    public boolean hasErrors() {
        return problems.hasErrors();
    }

    /**
     * Adds an error that only playing the level can show.
     *
     * @param pointer JSON pointer of the value at fault
     */
    public void error(String pointer, String message) {
        problems.error(json.map(at -> at.at(pointer)).orElse(Place.START), pointer, message);
    }
}
