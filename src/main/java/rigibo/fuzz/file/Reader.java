package rigibo.fuzz.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** Something the game reads. */
interface Reader {

    /** The kind of file, in a word. */
    String title();

    /** Whole files of the kind, as the game writes them, made in an empty folder. */
    List<Sample> samples(Path folder) throws IOException;

    /**
     * Reads a file and goes on with it as the game would.
     *
     * @return the complaint with which it is refused, empty where it is taken
     * @throws Refused where the game tells the player by an exception
     */
    String read(Path file) throws Refused;

    /** A refusal that the game catches and shows. */
    final class Refused extends Exception {

        private static final long serialVersionUID = 1;

        Refused(Exception told) {
            super(told.getMessage(), told);
        }
    }
}
