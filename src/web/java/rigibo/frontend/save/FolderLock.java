package rigibo.frontend.save;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;

/** The lock of a folder of the page, which nobody else writes to. */
public final class FolderLock {

    /** The work done under the lock. */
    public interface Work {
        void run() throws IOException;
    }

    /** The lock of a folder. */
    public FolderLock(Path folder, Duration patience) {}

    /** Works at once. */
    public boolean during(Work work) throws IOException {
        work.run();
        return true;
    }
}
