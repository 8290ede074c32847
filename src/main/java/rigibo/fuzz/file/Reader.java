package rigibo.fuzz.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** A kind of file that the game reads. */
interface Reader {

    /** The name of the kind. */
    String title();

    /** Makes valid files of the kind in an empty folder, as the game writes them. */
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
