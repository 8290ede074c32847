package rigibo.lab.hardcase;

import rigibo.backend.Pool;
import rigibo.lab.child.ClassFiles;
import rigibo.lab.child.Fields;
import rigibo.lab.child.Kept;
import rigibo.lab.child.Progress;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;

/** The margins of cases. Every run is logged, so that an interrupted report continues. */
public final class Margins {

    private static final String LOG = "cases.log";

    private Margins() {}

    /**
     * Runs the cases whose margins are missing.
     *
     * @param directory of the log
     * @param tell is told how far it is
     * @return the margins of all runs, in the order of the list
     */
    public static List<Margin> of(Cases cases, Path directory, Consumer<String> tell) {
        String engine = ClassFiles.of(Pool.class).hash();
        String key = engine + "-" + ClassFiles.of(HardCase.class).hash();
        Kept kept = new Kept(directory.resolve(LOG), key);
        Cases missing = cases.without(name -> kept.of(name).isPresent());
        Progress progress = new Progress(missing.count(), tell);
        missing.run(
                result -> {
                    kept.add(Cases.name(result), Fields.line(Margin.of(result)));
                    progress.done();
                });
        return cases.names().stream()
                .map(name -> Fields.parse(Margin.class, kept.of(name).orElseThrow()))
                .toList();
    }
}
