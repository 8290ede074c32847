package rigibo.frontend.save;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;

/** Stands in for the lock of a folder; no other program writes to the page's folders. */
public final class FolderLock {

    /** The work done under the lock. */
    public interface Work {
        void run() throws IOException;
    }

    /** The lock of a folder. */
    public FolderLock(Path folder, Duration patience) {}

    /** Does the work at once. */
    public boolean during(Work work) throws IOException {
        work.run();
        return true;
    }
}
