package rigibo.backend;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Restores a snapshot of a {@link Potpourri} from a file, goes on, and prints the end's hash. */
final class GoOn {

    private GoOn() {}

    /** Takes the file, and the numbers of the first step and of the one after the last. */
    public static void main(String[] arguments) throws IOException {
        Pool pool = Pool.restore(Files.readAllBytes(Path.of(arguments[0])));
        Potpourri.run(pool, Integer.parseInt(arguments[1]), Integer.parseInt(arguments[2]));
        System.out.println(Long.toHexString(pool.stateHash()));
    }
}
