package rigibo.lab.ablation;

import rigibo.backend.Pool;
import rigibo.lab.ablation.probe.Probe;
import rigibo.lab.ablation.probe.Workloads;
import rigibo.lab.child.ClassFiles;
import rigibo.lab.child.Fields;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Archives of the engine, whole and without the classes that a scene does not need. */
final class Archives {

    private final Path directory;
    private final Workloads workloads;
    private final ClassFiles engine = ClassFiles.of(Pool.class);
    private final ClassFiles probe = ClassFiles.of(Probe.class).and(ClassFiles.of(Fields.class));

    /** Makes a directory and writes the whole engine and the probe into it. */
    Archives(Path directory, Workloads workloads) {
        this.directory = directory;
        this.workloads = workloads;
        try {
            Files.createDirectories(directory);
        } catch (IOException cause) {
            throw new UncheckedIOException("cannot make " + directory, cause);
        }
        engine.write(whole());
        probe.write(probe());
    }

    private Path whole() {
        return directory.resolve("engine.jar");
    }

    /** The archive of the code that a process runs. */
    Path probe() {
        return directory.resolve("probe.jar");
    }

    /** Writes the engine without the classes that a scene does not need. */
    void strip(String scene) {
        engine.without(takenOut(scene)).write(stripped(scene));
    }

    private Path stripped(String scene) {
        return directory.resolve("engine-for-" + scene + ".jar");
    }

    /** The engine's archive on the class path of a run. */
    Path engine(Run run) {
        return run.engine() == Run.Engine.FULL ? whole() : stripped(run.workload());
    }

    /** The files that a scene's archive lacks. */
    List<String> takenOut(String scene) {
        return OwnClasses.undeclared(workloads.scene(scene).effects(), engine.names());
    }

    /** A hash of the classes' bytes. */
    String hash() {
        return engine.hash() + probe.hash();
    }
}
